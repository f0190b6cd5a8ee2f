#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the corpus of fuzz_picture: a drawn portrait, small, in every format and manner that is read.

    tests/faces/make_corpus.py        writes tests/faces/corpus
"""
import struct
from pathlib import Path

import cv2
import numpy as np

HERE = Path(__file__).resolve().parent
PORTRAIT = HERE.parents[1] / "resources/samples/anna_smiling.jpg"
SIDE = 96  # px


def with_orientation(jpeg: bytes, orientation: int) -> bytes:
    """The JPEG with an EXIF segment that holds its orientation (EXIF 2.32, tag 0x0112) and nothing else."""
    tiff = b"MM\0*" + struct.pack(">IH", 8, 1) + struct.pack(">HHIHH", 0x0112, 3, 1, orientation, 0) + b"\0\0\0\0"
    body = b"Exif\0\0" + tiff
    return jpeg[:2] + b"\xff\xe1" + struct.pack(">H", len(body) + 2) + body + jpeg[2:]


def encoded(ending: str, picture: np.ndarray, *options: int) -> bytes:
    return cv2.imencode(ending, picture, list(options))[1].tobytes()


def main() -> None:
    whole = cv2.imread(str(PORTRAIT))
    face = cv2.resize(whole, (SIDE, SIDE * whole.shape[0] // whole.shape[1]), interpolation=cv2.INTER_AREA)
    grey = cv2.cvtColor(face, cv2.COLOR_BGR2GRAY)
    alpha = np.dstack([face, np.full(grey.shape, 128, np.uint8)])
    quality = (cv2.IMWRITE_JPEG_QUALITY, 60)
    jpeg = encoded(".jpg", face, *quality)
    files = {
        "face.jpg": jpeg,
        "face_progressive.jpg": encoded(".jpg", face, *quality, cv2.IMWRITE_JPEG_PROGRESSIVE, 1),
        "face_grey.jpg": encoded(".jpg", grey, *quality),
        "face_turned.jpg": with_orientation(encoded(".jpg", cv2.rotate(face, cv2.ROTATE_90_COUNTERCLOCKWISE), *quality), 6),
        "face_cut_short.jpg": jpeg[: len(jpeg) * 2 // 3],
        "face.png": encoded(".png", cv2.resize(face, None, fx=0.5, fy=0.5)),
        "face_16_bit.png": encoded(".png", cv2.resize(grey, None, fx=0.5, fy=0.5).astype(np.uint16) * 257),
        "face_alpha.png": encoded(".png", cv2.resize(alpha, None, fx=0.5, fy=0.5)),
        "face.webp": encoded(".webp", face, cv2.IMWRITE_WEBP_QUALITY, 60),
        "face.bmp": encoded(".bmp", cv2.resize(face, None, fx=0.4, fy=0.4)),
        "face.tiff": encoded(".tiff", cv2.resize(face, None, fx=0.4, fy=0.4)),
        "not_a_picture": b"Dear Anna, here is the picture.",
    }
    folder = HERE / "corpus"
    folder.mkdir(exist_ok=True)
    for name, content in files.items():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
