#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a PNG of noise over slopes in any of the specification's kinds of pixels (PNG, third edition, 11.2.1).

    make_png.py OUT WIDTH HEIGHT BITS KIND [--interlaced]

KIND is grey, colour, palette, grey-alpha, colour-alpha; grey-key and colour-key have a transparent value (tRNS), as palettes
have here always.
"""
import argparse
import random
import struct
import zlib
from pathlib import Path

TYPES = {"grey": (0, 1), "grey-key": (0, 1), "colour": (2, 3), "colour-key": (2, 3), "palette": (3, 1), "grey-alpha": (4, 2),
         "colour-alpha": (6, 4)}
# Adam7: where each pass begins, and its steps.
PASSES = [(0, 0, 8, 8), (4, 0, 8, 8), (0, 4, 4, 8), (2, 0, 4, 4), (0, 2, 2, 4), (1, 0, 2, 2), (0, 1, 1, 2)]


def chunk(kind: bytes, data: bytes) -> bytes:
    return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))


def packed(values, bits: int) -> bytes:
    """A row's samples."""
    row = 0
    for value in values:
        row = row << bits | value
    length = len(values) * bits
    return (row << -length % 8).to_bytes((length + 7) // 8, "big")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("out", type=Path)
    parser.add_argument("width", type=int)
    parser.add_argument("height", type=int)
    parser.add_argument("bits", type=int)
    parser.add_argument("kind", choices=TYPES)
    parser.add_argument("--interlaced", action="store_true")
    asked = parser.parse_args()
    kind, samples = TYPES[asked.kind]
    most = (1 << asked.bits) - 1
    chance = random.Random(asked.width * asked.height)
    pixels = [[[(x * most // asked.width + y * (i + 1) + chance.randrange(most // 4 + 1)) % (most + 1) for i in range(samples)]
               for x in range(asked.width)] for y in range(asked.height)]
    passes = PASSES if asked.interlaced else [(0, 0, 1, 1)]
    rows = b""
    for left, top, right, down in passes:
        for y in range(top, asked.height, down):
            if left < asked.width:
                rows += b"\0" + packed([v for x in range(left, asked.width, right) for v in pixels[y][x]], asked.bits)
    extra = b""
    if kind == 3:
        extra = chunk(b"PLTE", bytes(chance.randrange(256) for _ in range(3 * (most + 1)))) + chunk(b"tRNS", bytes([0, 128]))
    elif asked.kind.endswith("key"):
        extra = chunk(b"tRNS", struct.pack(f">{samples}H", *([most // 2] * samples)))
    header = struct.pack(">IIBBBBB", asked.width, asked.height, asked.bits, kind, 0, 0, asked.interlaced)
    asked.out.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + extra + chunk(b"IDAT", zlib.compress(rows))
                          + chunk(b"IEND", b""))


if __name__ == "__main__":
    main()
