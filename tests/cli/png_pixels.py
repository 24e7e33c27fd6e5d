"""Pixels of the PNG files that hazumi writes: 8-bit RGB, not interlaced."""

import struct
import zlib

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def chunks_of(data):
    """Kinds and contents, in order."""
    assert data.startswith(SIGNATURE)
    found, at = [], 8
    while at < len(data):
        length, kind = struct.unpack_from(">I4s", data, at)
        found.append((kind, data[at + 8:at + 8 + length]))
        at += 12 + length
    return found


def joined(chunks):
    """A file of these chunks."""
    data = SIGNATURE
    for kind, content in chunks:
        data += struct.pack(">I", len(content)) + kind + content
        data += struct.pack(">I", zlib.crc32(kind + content))
    return data


def paeth(left, above, both):
    p = left + above - both
    distances = abs(p - left), abs(p - above), abs(p - both)
    return (left, above, both)[distances.index(min(distances))]


def unfiltered(kind, line, before):
    """A line of a picture, three bytes a pixel, of which `kind` says how it is stored."""
    for i in range(len(line)):
        left = line[i - 3] if i >= 3 else 0
        both = before[i - 3] if i >= 3 else 0
        guess = (0, left, before[i], (left + before[i]) // 2, paeth(left, before[i], both))[kind]
        line[i] = line[i] + guess & 255
    return line


def rows_of(path):
    """The bytes of each row of a picture, three a pixel."""
    chunks = chunks_of(path.read_bytes())
    width, height, depth, color = struct.unpack(">IIBB", chunks[0][1][:10])
    assert (depth, color) == (8, 2), path
    packed = zlib.decompress(b"".join(content for kind, content in chunks if kind == b"IDAT"))
    rows, before = [], bytes(3 * width)
    for y in range(height):
        line = packed[y * (3 * width + 1):(y + 1) * (3 * width + 1)]
        before = unfiltered(line[0], bytearray(line[1:]), before)
        rows.append(bytes(before))
    return rows


def change_pixel(path, x, y, by):
    """Adds to the red of a pixel; all else of the file stays."""
    rows = [bytearray(row) for row in rows_of(path)]
    rows[y][3 * x] = rows[y][3 * x] + by & 255
    pixels = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    chunks = [c for c in chunks_of(path.read_bytes()) if c[0] != b"IDAT"]
    path.write_bytes(joined(chunks[:-1] + [(b"IDAT", pixels), chunks[-1]]))


def without_text(path, key):
    """Takes a text out of a picture."""
    chunks = [c for c in chunks_of(path.read_bytes())
              if not (c[0] in (b"tEXt", b"iTXt") and c[1].startswith(key.encode() + b"\0"))]
    path.write_bytes(joined(chunks))
