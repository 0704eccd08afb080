# SPDX-License-Identifier: GPL-3.0-or-later
"""The process that decodes pictures: picture.py FOLDERS BYTES SECONDS.

Started by path with `python -I`; FOLDERS are where its modules are. Reads from its standard input
how many pictures there are and, of each, how many bytes and the bytes; answers of each with width
and height and three bytes for each pixel from the upper left, or with 0, 0 and why not.
"""

from __future__ import annotations

import io
import os
import struct
import sys

MOST_PIXELS = 64_000_000
"""Of a picture that is decoded: 8000 x 8000."""
LARGEST_SIDE = 2048
"""[px] Larger ones are made smaller: no organ has so many vertices."""
FORMATS = ("PNG", "JPEG", "BMP", "TGA", "WEBP", "TIFF")


def decode(content: bytes) -> bytes:
    from PIL import Image

    try:
        with Image.open(io.BytesIO(content), formats=FORMATS) as picture:
            width, height = picture.size
            if width * height > MOST_PIXELS:
                return refuse(
                    f"{width} x {height} pixels, at most {MOST_PIXELS // 1_000_000} million"
                )
            picture.draft("RGB", (LARGEST_SIDE, LARGEST_SIDE))
            plain = picture.convert("RGB")
    except MemoryError:
        return refuse("it needs more memory than there is for it")
    except Exception as problem:  # whatever a decoder stumbles over is the picture's fault
        said = " ".join(str(problem).split())[:120] or type(problem).__name__
        # where a decoder names the buffer it read from, that is nobody's business
        return refuse(said.split(" <_io")[0])
    factor = -(-max(plain.size) // LARGEST_SIDE)
    if factor > 1:
        plain = plain.reduce(factor)
    return struct.pack("<2I", *plain.size) + plain.tobytes()


def refuse(why: str) -> bytes:
    words = why.encode(errors="replace")
    return struct.pack("<3I", 0, 0, len(words)) + words


def main(folders: str, memory: str, seconds: str) -> int:
    sys.path += folders.split(os.pathsep)
    from PIL import Image

    from palpate_editor.formats_child.confine import confine

    Image.init()
    Image.MAX_IMAGE_PIXELS = None  # asked for above, in a sentence of our own
    libraries = [*folders.split(os.pathsep), os.path.dirname(os.__file__)]
    given = sys.stdin.buffer.read()
    answers = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)
    confine(os.devnull, libraries, int(memory), int(seconds))
    (count,) = struct.unpack_from("<I", given)
    at = 4
    for _ in range(count):
        (size,) = struct.unpack_from("<I", given, at)
        answers.write(decode(given[at + 4 : at + 4 + size]))
        answers.flush()
        at += 4 + size
    return 0


if __name__ == "__main__":
    os._exit(main(*sys.argv[1:]))
