"""Parts of a Markdown file that scripts write: between <!-- NAME: begin --> and <!-- NAME: end -->."""

import sys


def put(file, name, text):
    """Puts text, which ends with a line feed, in the place of what was there. file: a path."""
    begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->\n"
    old = file.read_text(encoding="utf-8")
    if begin not in old or end not in old:
        sys.exit(f"{file}: the markers {begin.strip()} and {end.strip()} are missing")
    head, rest = old.split(begin)
    file.write_text(head + begin + text + end + rest.split(end)[1], encoding="utf-8")
