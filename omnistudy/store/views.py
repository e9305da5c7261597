"""Views for people who open a study with a database browser.

They are not part of the migrations: every migration drops them first and they are made anew after.
"""

from sqlalchemy import Connection

VIEWS = {
    "trial_overview": """
        SELECT trial.id AS trial,
               participant.code AS participant,
               participant.kind AS participant_kind,
               participant.group_name AS group_name,
               session.visit AS visit,
               trial.position AS position,
               trial.attempt AS attempt,
               trial.kind AS kind,
               trial.condition AS condition,
               (SELECT group_concat(level.factor || ' = ' || level.level, ', ')
                  FROM condition_level AS level
                 WHERE level.condition = trial.condition) AS levels,
               trial.repetition AS repetition,
               trial.task AS task,
               trial.route AS route,
               trial.status AS status,
               trial.duration_s AS duration_s,
               trial.path_length_m AS path_length_m,
               trial.collisions AS collisions,
               trial.contact_time_s AS contact_time_s,
               trial.reason AS reason
          FROM trial
          JOIN session ON session.id = trial.session_id
          JOIN participant ON participant.id = session.participant_id
         ORDER BY participant.code, session.visit, trial.position, trial.attempt""",
    "condition_overview": """
        SELECT trial.condition AS condition,
               participant.kind AS participant_kind,
               count(*) AS trials,
               count(DISTINCT participant.id) AS participants,
               avg(trial.duration_s) AS mean_duration_s,
               avg(trial.collisions) AS mean_collisions,
               avg(trial.contact_time_s) AS mean_contact_time_s
          FROM trial
          JOIN session ON session.id = trial.session_id
          JOIN participant ON participant.id = session.participant_id
         WHERE trial.status = 'completed'
         GROUP BY trial.condition, participant.kind
         ORDER BY trial.condition, participant.kind""",
}
"""Name of each view and the query behind it."""


def drop_views(connection: Connection) -> None:
    """Take the views away, so that tables can be changed."""
    for name in VIEWS:
        connection.exec_driver_sql(f"DROP VIEW IF EXISTS {name}")


def create_views(connection: Connection) -> None:
    """Make the views."""
    for name, query in VIEWS.items():
        connection.exec_driver_sql(f"CREATE VIEW {name} AS {query}")
