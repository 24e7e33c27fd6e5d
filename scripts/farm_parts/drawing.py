"""The options that hazumi --render and --export share, as far as the farm has to know them."""

import json
import math
import re
import subprocess
from fractions import Fraction

from .errors import USAGE, FarmError

SAME_FRAME = 1e-9  # instants this near are one [frames]; as in engine/timeline/frame_time.h


def value_of(options, name):
    """What an option is given, as --name X or --name=X, the last time; None: it is not there."""
    found = None
    for i, option in enumerate(options):
        if option == name:
            if i + 1 == len(options):
                raise FarmError(f"{name}: a value is missing", USAGE)
            found = options[i + 1]
        elif option.startswith(name + "="):
            found = option[len(name) + 1:]
    return found


def without(options, name):
    """The options but for one and its value."""
    left, skip = [], False
    for option in options:
        if not skip and option != name and not option.startswith(name + "="):
            left.append(option)
        skip = not skip and option == name
    return left


def rate_of(text):
    """Frames a second of --fps: 60, 29.97 or 30000/1001; thousandths, as hazumi takes them."""
    try:
        rate = Fraction(text)
    except (ValueError, ZeroDivisionError):
        raise FarmError(f"--fps {text}: is no rate such as 60, 29.97 or 30000/1001",
                        USAGE) from None
    return rate if "/" in text else Fraction(round(rate * 1000), 1000)


def info_of(hazumi, file, options):
    """The first and last frame of a file and its rate. Raises FarmError with hazumi's own words."""
    clip = value_of(options, "--clip")
    command = [hazumi, "--info", "--json", *(["--clip", clip] if clip else []), str(file)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise FarmError(last_line(done.stderr), done.returncode)
    info = json.loads(done.stdout)
    return (*info["frames"], Fraction(info["fps"]).limit_denominator(1001))


def last_line(text):
    """What a program said at last, without its name."""
    lines = [line for line in text.splitlines() if line.strip() and line != "see hazumi --help"]
    return lines[-1].removeprefix("hazumi: ") if lines else "it says nothing"


def frames_of(hazumi, file, options):
    """(first, last, rate): the frames to be drawn and the rate of the video. Raises FarmError."""
    first, last, rate = info_of(hazumi, file, options)
    fps = value_of(options, "--fps")
    if fps is not None:
        output = rate_of(fps)
        first = math.ceil(first * float(output) / float(rate) - SAME_FRAME)
        last = math.floor(last * float(output) / float(rate) + SAME_FRAME)
        rate = output
    asked = value_of(options, "--frames")
    if asked is None:
        return first, last, rate
    ends = re.fullmatch(r"(-?\d+)(?:\.\.(-?\d+))?", asked)
    if not ends:
        raise FarmError(f"--frames {asked}: is no range such as 5..15, nor a frame", USAGE)
    low, high = int(ends[1]), int(ends[2] or ends[1])
    if low > high or high < first or low > last:
        raise FarmError(f"--frames {asked}: {file} has frames {first}..{last}", USAGE)
    return max(low, first), min(high, last), rate


def check_even(options):
    """Videos have even sizes only."""
    size = value_of(options, "--size") or "1280x720"
    if any(int(side) % 2 for side in re.findall(r"\d+", size)):
        raise FarmError(f"--size {size}: videos have even sizes; give one a pixel larger, or "
                        "--no-video", USAGE)
