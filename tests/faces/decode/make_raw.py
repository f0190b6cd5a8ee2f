#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes files that begin and hold their previews as the raw files of cameras do; no sensor's data is in them.

    make_raw.py OUT KIND PREVIEW [--orientation N] [--small PREVIEW]

KIND is dng, cr2, cr3, nef, arw, orf, rw2; or tiff, which has what a NEF file has but says that its first picture is the whole.
PREVIEW is a JPEG file; --small a second, smaller one, where the kind has a place for it (dng, nef). Each first directory
holds a picture of 16 × 12 px, all of one grey, as many raw files do. TIFF 6.0; for CR3 the description of its boxes by L. Clévy.
"""
import argparse
import struct
from pathlib import Path

SHORT, LONG, ASCII, BYTE, UNDEFINED = 3, 4, 2, 1, 7
UNITS = {SHORT: "H", LONG: "I"}
GREY = bytes([128]) * (16 * 12 * 3)


class Directory:
    def __init__(self, *entries):
        self.entries = sorted(entries)  # (tag, type, value): numbers, bytes, or a Directory or Data that lies elsewhere


class Data:
    def __init__(self, content: bytes):
        self.content = content


def entry(tag, kind, *values):
    return tag, kind, values


def laid_out(magic: bytes, directory: Directory, first_at: int) -> bytes:
    """The directory as a file, little-endian: first itself, then what it points to."""
    out = bytearray(magic + bytes(first_at - len(magic)))
    struct.pack_into("<I", out, 4, first_at)

    def put(content: bytes) -> int:
        out.extend(b"\0" * (len(out) % 2))
        out.extend(content)
        return len(out) - len(content)

    def write(one: Directory) -> int:
        at = put(bytes(2 + 12 * len(one.entries) + 4))
        struct.pack_into("<H", out, at, len(one.entries))
        for i, (tag, kind, values) in enumerate(one.entries):
            numbers = [write(v) if isinstance(v, Directory) else put(v.content) if isinstance(v, Data) else v for v in values]
            raw = numbers[0] if isinstance(numbers[0], bytes) else struct.pack(f"<{len(numbers)}{UNITS[kind]}", *numbers)
            count = len(raw) if isinstance(numbers[0], bytes) else len(numbers)
            field = raw.ljust(4, b"\0") if len(raw) <= 4 else struct.pack("<I", put(raw))
            struct.pack_into("<HHI4s", out, at + 2 + 12 * i, tag, kind, count, field)
        return at

    write(directory)
    return bytes(out)


def picture(subfile: int, *more) -> list:
    return [entry(0x00FE, LONG, subfile), entry(0x0100, LONG, 16), entry(0x0101, LONG, 12), entry(0x0102, SHORT, 8, 8, 8),
            entry(0x0103, SHORT, 1), entry(0x0106, SHORT, 2), entry(0x0111, LONG, Data(GREY)), entry(0x0115, SHORT, 3),
            entry(0x0116, LONG, 12), entry(0x0117, LONG, len(GREY)), *more]


def width(jpeg: bytes) -> int:
    """What a JPEG's frame header says, px."""
    at = 2
    while jpeg[at + 1] not in (0xC0, 0xC2):
        at += 2 + struct.unpack(">H", jpeg[at + 2:at + 4])[0]
    return struct.unpack(">H", jpeg[at + 7:at + 9])[0]


def made(kind: str, jpeg: bytes, small: bytes, orientation: int) -> bytes:
    turned = entry(0x0112, SHORT, orientation)
    strip = [entry(0x0111, LONG, Data(jpeg)), entry(0x0117, LONG, len(jpeg))]
    inside = lambda one: [entry(0x0201, LONG, Data(one)), entry(0x0202, LONG, len(one))]  # JPEGInterchangeFormat
    parts = [Directory(entry(0x00FE, LONG, 1), entry(0x0103, SHORT, 6), *inside(one)) for one in (jpeg, small) if one]
    if kind == "cr3":
        return made_cr3(jpeg, laid_out(b"II*\0", Directory(turned, entry(0x010F, ASCII, b"Canon\0")), 8))
    if kind == "dng":
        previews = [Directory(entry(0x00FE, LONG, 1), entry(0x0100, LONG, width(one)), entry(0x0101, LONG, 12), entry(0x0103, SHORT, 7),
                              entry(0x0106, SHORT, 6), entry(0x0111, LONG, Data(one)), entry(0x0117, LONG, len(one)))
                    for one in (jpeg, small) if one]
        return laid_out(b"II*\0", Directory(*picture(1, turned, entry(0x010F, ASCII, b"Google\0"), entry(0x014A, LONG, *previews),
                                                     entry(0xC612, BYTE, bytes([1, 4, 0, 0])))), 8)
    if kind in ("nef", "tiff"):
        return laid_out(b"II*\0", Directory(*picture(int(kind == "nef"), turned, entry(0x010F, ASCII, b"NIKON CORPORATION\0"),
                                                     entry(0x014A, LONG, *parts))), 8)
    if kind == "arw":
        return laid_out(b"II*\0", Directory(entry(0x00FE, LONG, 1), entry(0x0103, SHORT, 6), entry(0x010F, ASCII, b"SONY\0"),
                                            turned, *inside(jpeg)), 8)
    if kind == "cr2":
        return laid_out(b"II*\0\0\0\0\0CR\2\0\0\0\0\0", Directory(entry(0x0100, SHORT, 16), entry(0x0101, SHORT, 12),
                                                              entry(0x0102, SHORT, 8, 8, 8), entry(0x0103, SHORT, 6),
                                                              entry(0x010F, ASCII, b"Canon\0"), turned, *strip), 16)
    if kind == "orf":
        return laid_out(b"IIRO", Directory(*picture(1, turned, entry(0x010F, ASCII, b"OLYMPUS CORPORATION\0"),
                                                    entry(0x014A, LONG, *parts))), 8)
    if kind == "rw2":
        return laid_out(b"IIU\0", Directory(entry(0x002E, UNDEFINED, jpeg), entry(0x010F, ASCII, b"Panasonic\0"), turned), 8)
    raise ValueError(kind)


def made_cr3(jpeg: bytes, tiff: bytes) -> bytes:
    box = lambda name, *content: struct.pack(">I", 8 + sum(map(len, content))) + name + b"".join(content)
    about = box(b"uuid", bytes.fromhex("85c0b687820f11e08111f4ce462b6a48"), box(b"CMT1", tiff))
    shown = box(b"PRVW", struct.pack(">IHHHHI", 0, 1, 16, 12, 1, len(jpeg)), jpeg)
    return (box(b"ftyp", b"crx ", struct.pack(">I", 1), b"crx ", b"isom") + box(b"moov", about) +
            box(b"uuid", bytes.fromhex("eaf42b5e1c984b88b9fbb7dc406e4d16"), struct.pack(">II", 0, 1), shown))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("kind")
    parser.add_argument("preview", type=Path)
    parser.add_argument("--small", type=Path)
    parser.add_argument("--orientation", type=int, default=1)
    options = parser.parse_args()
    small = options.small.read_bytes() if options.small else b""
    options.out.write_bytes(made(options.kind, options.preview.read_bytes(), small, options.orientation))


if __name__ == "__main__":
    main()
