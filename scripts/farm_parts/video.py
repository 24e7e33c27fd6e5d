"""Pictures become a video, the same bytes as hazumi --export writes (render/pipeline/video.cpp):
ffmpeg decodes them, another one is given the pixels with the same options."""

import json
import os
import shutil
import subprocess
import tempfile
import threading

from .errors import FarmError

INPUT = ["ffmpeg", "-hide_banner", "-loglevel", "error", "-y"]
OUTPUT = ["-vf", "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p", "-c:v", "libx264",
          "-preset", "medium", "-crf", "18", "-color_range", "tv", "-colorspace", "bt709",
          "-color_primaries", "bt709", "-color_trc", "bt709", "-movflags", "+faststart",
          "-f", "mp4"]


def has_sound(file):
    """A project says so; what is no JSON is no project."""
    try:
        document = json.loads(file.read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return False
    return isinstance(document, dict) and "audio" in document


def sound_of(hazumi, file, options, folder):
    """The options of ffmpeg for the sound of a project, by a video of small pictures."""
    path = os.path.join(folder, "sound.mp4")
    done = subprocess.run([hazumi, "--export", path, *options, "--size", "16x16", "--samples", "1",
                           str(file)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise FarmError(f"the sound of {file}: {done.stderr.strip().splitlines()[-1]}",
                        done.returncode)
    return ["-i", path, "-map", "0:v:0", "-map", "1:a:0?", "-c:a", "copy"]


def size_of(picture):
    """Its width and height [px], of a PNG file's header."""
    with open(picture, "rb") as file:
        header = file.read(24)
    return int.from_bytes(header[16:20], "big"), int.from_bytes(header[20:24], "big")


def feed(pictures, sink):
    """All files, one after the other, into a pipe. It ends where its reader does."""
    try:
        with sink:
            for picture in pictures:
                with open(picture, "rb") as file:
                    shutil.copyfileobj(file, sink)
    except BrokenPipeError:
        pass  # the reader says why


def encode(pictures, rate, sound, temporary):
    """One ffmpeg decodes the pictures, another one encodes them. Raises FarmError."""
    width, height = size_of(pictures[0])
    decode = [*INPUT, "-f", "image2pipe", "-c:v", "png", "-i", "pipe:0", "-f", "rawvideo",
              "-pix_fmt", "rgb0", "pipe:1"]
    write = [*INPUT, "-f", "rawvideo", "-pixel_format", "rgb0", "-video_size", f"{width}x{height}",
             "-framerate", f"{rate.numerator}/{rate.denominator}", "-i", "pipe:0",
             *(sound or ["-an"]), *OUTPUT, f"file:{temporary}"]
    with tempfile.TemporaryFile("w+") as says:
        with subprocess.Popen(decode, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                              stderr=says) as decoder:
            with subprocess.Popen(write, stdin=decoder.stdout, stderr=says) as encoder:
                decoder.stdout.close()
                feeder = threading.Thread(target=feed, args=(pictures, decoder.stdin))
                feeder.start()
                feeder.join()
        if decoder.returncode or encoder.returncode:
            says.seek(0)
            raise FarmError(f"the video: ffmpeg: {'; '.join(says.read().split(chr(10))[:3])}")


def write_video(pictures, rate, sound, path):
    """A video that is there when it is whole. Raises FarmError."""
    if not shutil.which("ffmpeg"):
        raise FarmError("the program ffmpeg, which makes videos, is not installed; on Debian: apt "
                        "install ffmpeg; all frames are kept")
    temporary = path.with_name(f".{path.name}.{os.getpid()}.tmp")
    try:
        encode(pictures, rate, sound, temporary)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)
