#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the corpus of fuzz_picture: a drawn portrait, small, in every format and manner that is read. HEIC and AVIF are coded
by heif-enc (Debian: libheif-examples).

    tests/faces/decode/make_corpus.py        writes tests/faces/decode/corpus
"""
import argparse
import struct
import subprocess
import tempfile
from pathlib import Path

import cv2
import numpy as np

import make_heif
import make_raw

HERE = Path(__file__).resolve().parent
PORTRAIT = HERE.parents[2] / "resources/samples/anna_smiling.jpg"
SIDE = 96  # px


def with_orientation(jpeg: bytes, orientation: int) -> bytes:
    """The JPEG with an EXIF segment that holds its orientation (EXIF 2.32, tag 0x0112) and nothing else."""
    tiff = b"MM\0*" + struct.pack(">IH", 8, 1) + struct.pack(">HHIHH", 0x0112, 3, 1, orientation, 0) + b"\0\0\0\0"
    body = b"Exif\0\0" + tiff
    return jpeg[:2] + b"\xff\xe1" + struct.pack(">H", len(body) + 2) + body + jpeg[2:]


def encoded(ending: str, picture: np.ndarray, *options: int) -> bytes:
    return cv2.imencode(ending, picture, list(options))[1].tobytes()


def coded(ending: str, picture: np.ndarray, folder: Path) -> Path:
    """The picture as a file of heif-enc."""
    number = len(list(folder.iterdir()))
    png, file = folder / f"{number}.png", folder / f"{number}.coded{ending}"
    cv2.imwrite(str(png), picture)
    subprocess.run(["heif-enc", "-q", "40", png, "-o", file], check=True)
    return file


def heif(*pictures: Path, **more) -> bytes:
    options = dict(columns=0, size=None, says=None, primary=0, turn=0, mirror=None, thumbnail=None, exif_orientation=None, cut=0)
    return make_heif.made(argparse.Namespace(pictures=list(pictures), **options | more))


def heif_files(face: np.ndarray) -> dict:
    # Sides of less than 64 px and odd ones are filled up by heif-enc, which then makes a tile of the picture.
    even = cv2.resize(face, (128, 156))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        whole, small = coded(".heic", even, folder), coded(".heic", cv2.resize(even, (64, 78)), folder)
        tiles = [coded(".heic", even[y:y + 64, x:x + 64], folder) for y in (14, 78) for x in (0, 64)]
        deep = coded(".heic", even.astype(np.uint16) * 257, folder)
        return {
            "face.heic": heif(whole),
            "face_turned.heic": heif(whole, turn=90, mirror=1, exif_orientation=6, thumbnail=small),
            "face_tiles.heic": heif(*tiles, columns=2, size=(128, 120)),
            "face_10_bit.heic": heif(deep),
            "face_canvas_beyond.heic": heif(small, columns=1, size=(30000, 30000), says=(64, 78)),
            "face_cut_short.heic": heif(whole, cut=200),
            "face.avif": heif(coded(".avif", even, folder)),
            "face_alpha.avif": coded(".avif", np.dstack([even, np.full(even.shape[:2], 128, np.uint8)]), folder).read_bytes(),
        }


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
        **{f"face.{kind}": make_raw.made(kind, jpeg, encoded(".jpg", cv2.resize(face, (24, 29))), 6)
           for kind in ("dng", "cr2", "cr3", "nef", "arw", "orf", "rw2")},
        **heif_files(face),
        "not_a_picture": b"Dear Anna, here is the picture.",
    }
    folder = HERE / "corpus"
    folder.mkdir(exist_ok=True)
    for name, content in files.items():
        (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
