"""What kinds of work there are."""

from .errors import BAD_DATA, FarmError
from .render_work import RenderWork
from .sweep_work import SweepWork

KINDS = {"render": RenderWork, "sweep": SweepWork}


def work_of(folder, plan):
    """The work of a plan. Raises FarmError."""
    kind = plan["work"].get("kind")
    if kind not in KINDS:
        raise FarmError(f"{folder.plan_file}: work: {kind} is not known to this scripts/farm; use "
                        "the one that wrote it", BAD_DATA)
    return KINDS[kind](folder, plan)
