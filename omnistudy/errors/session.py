"""Mistakes in running a study."""

from omnistudy.errors.base import OmnistudyError


class HumanParticipants(OmnistudyError):
    """A study of people, asked to run by itself."""

    def __init__(self, study: str) -> None:
        super().__init__(
            f"study '{study}' has human participants, who cannot be run by a virtual operator: "
            "create a study with participants.kind=virtual"
        )


class NotVirtualDriver(OmnistudyError):
    """A protocol without the driver that is to be calibrated."""

    def __init__(self, protocol: str, kind: str) -> None:
        super().__init__(
            f"protocol '{protocol}' is driven by the operator '{kind}': only 'virtual_driver' is "
            "calibrated; give a protocol with it, or add operator=virtual_driver"
        )


class NoFreeCondition(OmnistudyError):
    """A protocol without a no-feedback condition to calibrate on."""

    def __init__(self, protocol: str) -> None:
        super().__init__(
            f"protocol '{protocol}' has no condition with the law 'none': a driver is calibrated "
            "on no-feedback trials alone, so give a protocol with one"
        )


class CannotCalibrate(OmnistudyError):
    """A target that no skill reaches."""

    def __init__(self, target: float, reached: float, skill: float) -> None:
        super().__init__(
            f"{target:g} collisions a trial are out of reach: the response measured gives "
            f"{reached:.1f} at skill {skill:g}; measure it at higher skills, or check the target"
        )


class WorkerDied(OmnistudyError):
    """A worker process that the system ended."""

    def __init__(self) -> None:
        super().__init__(
            "a worker process was ended from outside (too little memory, or killed); what was "
            "finished is kept: run the command again, with --workers 1 if memory is short"
        )


class AlwaysVoid(OmnistudyError):
    """A trial whose attempts were void one after the other."""

    def __init__(self, participant: str, position: int, attempts: int, cause: str) -> None:
        super().__init__(
            f"trial {position} of {participant} was void {attempts} times in a row, the last time "
            f"because {cause}; mend that, then run the session again: another attempt is planned"
        )


class NobodyAnswers(OmnistudyError):
    """A page that waited for a person in vain."""

    def __init__(self, page: str, patience_s: float) -> None:
        super().__init__(
            f"the {page} page waited {patience_s / 60.0:.0f} minutes for an answer: what was "
            "driven is kept; run the command again when somebody is there"
        )


class StoppedBetweenTrials(OmnistudyError):
    """A participant who pressed stop on a page between two trials."""

    def __init__(self, page: str) -> None:
        super().__init__(
            f"stop was pressed on the {page} page: what was driven is kept; run the command again "
            "to go on with the next trial"
        )
