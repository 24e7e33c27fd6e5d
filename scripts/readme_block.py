"""Parts of README.md that scripts write: between <!-- NAME: begin --> and <!-- NAME: end -->."""

import pathlib
import sys

README = pathlib.Path(__file__).resolve().parent.parent / "README.md"


def put(name, text):
    """Puts text, which ends with a line feed, in the place of what was there."""
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->\n"
    old = README.read_text(encoding="utf-8")
    if begin not in old or end not in old:
        sys.exit(f"README.md: the markers {begin.strip()} and {end.strip()} are missing")
    head, rest = old.split(begin)
    README.write_text(head + begin + text + end + rest.split(end)[1], encoding="utf-8")
