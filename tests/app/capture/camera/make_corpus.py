#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the corpus of fuzz_camera_frame: a small picture in every form that a camera gives, and frames of which something else
is told than is there. How a frame is written: frame_check.hpp.

    tests/app/capture/camera/make_corpus.py        writes tests/app/capture/camera/frame_corpus
"""
import struct
from pathlib import Path

import cv2
import numpy as np

CORPUS = Path(__file__).resolve().parent / "frame_corpus"
WIDE, HIGH = 16, 8  # px
FORMS = ("bgra", "bgrx", "rgba", "rgbx", "yuyv", "uyvy", "grey", "nv12", "nv21", "yuv420p", "yv12", "jpeg", "p010")


def frame(form: str, *planes: bytes, size=(WIDE, HIGH), steps=(0, 0), count=None) -> bytes:
    count = len(planes) if count is None else count
    lengths = [min(len(plane), 0xFFFF) for plane in planes[:2]] + [0, 0]
    return struct.pack("<BHHhhHH", FORMS.index(form) | count << 6, *size, *steps, *lengths[:2]) + b"".join(planes)


def colours(count: int) -> bytes:
    return bytes(i * 7 % 256 for i in range(count))


def segments(jpeg: bytes):
    """Each segment before the first scan as its marker and its bytes, then that scan's header and the rest."""
    at = 2
    while True:
        length = struct.unpack(">H", jpeg[at + 2:at + 4])[0]
        if jpeg[at + 1] == 0xDA:
            return
        yield jpeg[at + 1], jpeg[at:at + 2 + length]
        at += 2 + length


def without(jpeg: bytes, marker: int) -> bytes:
    for kind, segment in list(segments(jpeg)):
        if kind == marker:
            jpeg = jpeg.replace(segment, b"", 1)
    return jpeg


def last_scan(jpeg: bytes) -> bytes:
    return jpeg[jpeg.rindex(b"\xff\xda"):jpeg.rindex(b"\xff\xd9")]


def main():
    area, quarter = WIDE * HIGH, WIDE * HIGH // 4
    made = {form: frame(form, colours(4 * area), steps=(4 * WIDE, 0)) for form in FORMS[:4]}
    made |= {form: frame(form, colours(2 * area), steps=(2 * WIDE, 0)) for form in ("yuyv", "uyvy")}
    made["grey"] = frame("grey", colours(area), steps=(WIDE, 0))
    made |= {form: frame(form, colours(area), colours(area // 2), steps=(WIDE, WIDE)) for form in ("nv12", "nv21")}
    made |= {form: frame(form, colours(area), colours(quarter), colours(quarter), steps=(WIDE, WIDE // 2))
             for form in ("yuv420p", "yv12")}
    made["p010"] = frame("p010", colours(2 * area), colours(area), steps=(2 * WIDE, 2 * WIDE))

    made["no_bytes"] = b""
    made["grey_of_no_width"] = frame("grey", colours(area), size=(0, HIGH), steps=(WIDE, 0))
    made["grey_of_16_gigapixels"] = frame("grey", colours(area), size=(0xFFFF, 0xFFFF), steps=(0x7FFF, 0))
    made["grey_cut_by_a_byte"] = frame("grey", colours(area - 1), steps=(WIDE, 0))
    made["grey_from_the_end"] = frame("grey", colours(area), steps=(-WIDE, 0))
    made["yuyv_of_an_odd_width"] = frame("yuyv", colours(2 * area), size=(WIDE - 1, HIGH), steps=(2 * WIDE, 0))
    made["nv12_in_one_plane"] = frame("nv12", colours(area * 3 // 2), steps=(WIDE, 0))
    made["nv12_without_colours"] = frame("nv12", colours(area), b"", steps=(WIDE, WIDE))
    made["yuv420p_of_one_row"] = frame("yuv420p", colours(WIDE), b"", b"", size=(WIDE, 1), steps=(WIDE, WIDE // 2))

    picture = np.arange(WIDE * HIGH * 3, dtype=np.uint8).reshape(HIGH, WIDE, 3)
    jpeg = cv2.imencode(".jpg", picture)[1].tobytes()
    stairs = cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_PROGRESSIVE, 1])[1].tobytes()
    size_of = next(segment for marker, segment in segments(jpeg) if marker == 0xC0)
    other_size = size_of[:5] + struct.pack(">HH", 6000, 8000) + size_of[9:]
    made["jpeg"] = frame("jpeg", jpeg)
    made["jpeg_without_tables"] = frame("jpeg", without(jpeg, 0xC4))
    made["jpeg_in_stairs"] = frame("jpeg", stairs)
    made["jpeg_of_601_scans"] = frame("jpeg", stairs[:-2] + 600 * last_scan(stairs) + stairs[-2:])
    made["jpeg_of_whole_blocks"] = frame("jpeg", cv2.imencode(".jpg", np.pad(picture, ((0, 8), (0, 0), (0, 0))))[1].tobytes())
    made["jpeg_of_48_megapixels"] = frame("jpeg", jpeg.replace(size_of, other_size))
    made["jpeg_of_two_sizes"] = frame("jpeg", jpeg.replace(size_of, other_size + size_of))
    made["jpeg_cut"] = frame("jpeg", jpeg[:len(jpeg) * 7 // 8])
    made["jpeg_that_is_a_png"] = frame("jpeg", cv2.imencode(".png", picture)[1].tobytes())

    CORPUS.mkdir(exist_ok=True)
    for name, content in made.items():
        (CORPUS / name).write_bytes(content)


if __name__ == "__main__":
    main()
