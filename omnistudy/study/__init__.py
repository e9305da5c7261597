"""What may happen in a study: it is created, frozen, enrolled and planned here."""

from omnistudy.study.amend import Amendment, amend_study, amendment
from omnistudy.study.create import create_study
from omnistudy.study.find import new_study_file, resolve_study, studies_folder, study_files
from omnistudy.study.frozen import check_unchanged, frozen_protocol
from omnistudy.study.order_check import OrderCheck
from omnistudy.study.session_plan import SessionTrial, plan_session
from omnistudy.study.status import listed_studies, participants_status, study_status

__all__ = [
    "Amendment",
    "OrderCheck",
    "SessionTrial",
    "amend_study",
    "amendment",
    "check_unchanged",
    "create_study",
    "frozen_protocol",
    "listed_studies",
    "new_study_file",
    "participants_status",
    "plan_session",
    "resolve_study",
    "studies_folder",
    "study_files",
    "study_status",
]
