"""Where the captures and characters are that are no part of the repository: in the folder that the
environment variable HAZUMI_DATA names, or else in ../shared/data beside the repository."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]


def is_promised():
    """Whatever is missing is an error."""
    return bool(os.environ.get("HAZUMI_DATA"))


def path(name=""):
    """Of a file or folder of the data, whether it is there or not."""
    return pathlib.Path(os.environ.get("HAZUMI_DATA") or ROOT.parent / "shared" / "data") / name
