#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts pictures that heif-enc coded into one HEIC or AVIF file, in the ways that phones do and heif-enc cannot.

    make_heif.py OUT PICTURE... [--columns N --size WxH] [--turn DEGREES] [--mirror AXIS] [--exif-orientation N]
                 [--thumbnail PICTURE] [--primary N] [--says WxH] [--cut BYTES]

Each PICTURE is a file of heif-enc that holds one picture of its own (even sides of 64 px and more; others it fills up and
crops again). With --columns they are the tiles of one
picture of --size; otherwise pictures of their own, of which --primary (0: the first) is meant. --turn is irot,
anticlockwise; --mirror imir (0: top and bottom change places, 1: left and right); --says another size than the true one.
ISO/IEC 14496-12 (boxes) and 23008-12 (items and their properties).
"""
import argparse
import struct
from pathlib import Path


def box(kind: bytes, *content: bytes) -> bytes:
    body = b"".join(content)
    return struct.pack(">I", len(body) + 8) + kind + body


def full_box(kind: bytes, version: int, flags: int, *content: bytes) -> bytes:
    return box(kind, struct.pack(">I", version << 24 | flags), *content)


def boxes(data: bytes):
    """(kind, content) of each box."""
    at = 0
    while at + 8 <= len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        yield kind, data[at + 8:at + size]
        at += size


def inside(data: bytes, *path: bytes) -> bytes:
    for kind, content in boxes(data):
        if kind == path[0]:
            content = content[4:] if kind == b"meta" else content
            return inside(content, *path[1:]) if len(path) > 1 else content
    raise ValueError(f"no {path[0]!r}")


class Coded:
    """The one coded picture of a file that heif-enc wrote: its decoder's configuration, size and bytes."""

    def __init__(self, file: Path):
        data = file.read_bytes()
        meta = inside(data, b"meta")
        properties = list(boxes(inside(meta, b"iprp", b"ipco")))
        self.kind = b"hvc1" if any(kind == b"hvcC" for kind, _ in properties) else b"av01"
        self.setup = next(box(kind, content) for kind, content in properties if kind in (b"hvcC", b"av1C"))
        self.size = struct.unpack(">II", next(content for kind, content in properties if kind == b"ispe")[4:12])
        places = inside(meta, b"iloc")  # version 0, sizes 4 4 4 0, one extent: as heif-enc writes it
        base, _, at, length = struct.unpack(">IHII", places[12:26])
        self.bytes = data[base + at:base + at + length]


class Writer:
    def __init__(self):
        self.items, self.properties, self.uses, self.references = [], [], {}, []

    def item(self, kind: bytes, data: bytes, hidden: bool = False) -> int:
        self.items.append((kind, data, hidden))
        return len(self.items)

    def has(self, item: int, *properties: bytes) -> None:
        for one in properties:
            if one not in self.properties:
                self.properties.append(one)
            self.uses.setdefault(item, []).append(self.properties.index(one) + 1)

    def coded(self, picture: Coded, hidden: bool = False, says=None) -> int:
        item = self.item(picture.kind, picture.bytes, hidden)
        self.has(item, picture.setup, spatial_extent(says or picture.size))
        return item

    def file(self, primary: int, brand: bytes) -> bytes:
        start = box(b"ftyp", brand, struct.pack(">I", 0), b"mif1", brand)
        meta = self.meta(primary, 0)
        return start + self.meta(primary, len(start) + len(meta) + 8) + box(b"mdat", *(data for _, data, _ in self.items))

    def meta(self, primary: int, data_at: int) -> bytes:
        places, entries = [], []
        for number, (kind, data, hidden) in enumerate(self.items, 1):
            places.append(struct.pack(">HHHHII", number, 0, 0, 1, data_at, len(data)))
            data_at += len(data)
            entries.append(full_box(b"infe", 2, int(hidden), struct.pack(">HH", number, 0), kind, b"\0"))
        uses = [struct.pack(">HB", item, len(which)) + bytes(0x80 | one for one in which) for item, which in self.uses.items()]
        references = [box(kind, struct.pack(f">HH{len(to)}H", item, len(to), *to)) for kind, item, to in self.references]
        return full_box(
            b"meta", 0, 0,
            full_box(b"hdlr", 0, 0, struct.pack(">I", 0), b"pict", bytes(13)),
            full_box(b"pitm", 0, 0, struct.pack(">H", primary)),
            full_box(b"iloc", 1, 0, b"\x44\0", struct.pack(">H", len(places)), *places),
            full_box(b"iinf", 0, 0, struct.pack(">H", len(entries)), *entries),
            full_box(b"iref", 0, 0, *references) if references else b"",
            box(b"iprp", box(b"ipco", *self.properties), full_box(b"ipma", 0, 0, struct.pack(">I", len(uses)), *uses)))


def spatial_extent(size) -> bytes:
    return full_box(b"ispe", 0, 0, struct.pack(">II", *size))


def exif(orientation: int) -> bytes:
    """EXIF that states that (tag 0x0112), the day (0x9003), and nothing else."""
    day = b"2024:05:01 10:11:12\0"
    inner = struct.pack(">H", 1) + struct.pack(">HHII", 0x9003, 2, len(day), 56) + bytes(4)
    outer = struct.pack(">H", 2) + struct.pack(">HHIHH", 0x0112, 3, 1, orientation, 0) + struct.pack(">HHII", 0x8769, 4, 1, 38) + bytes(4)
    return struct.pack(">I", 6) + b"Exif\0\0" + b"MM\0*" + struct.pack(">I", 8) + outer + inner + day


def side_by_side(text: str):
    return tuple(int(side) for side in text.split("x"))


def made(options: argparse.Namespace) -> bytes:
    writer = Writer()
    pictures = [Coded(file) for file in options.pictures]
    if options.columns:
        tiles = [writer.coded(picture, hidden=True) for picture in pictures]
        rows = len(tiles) // options.columns
        primary = writer.item(b"grid", struct.pack(">BBBBHH", 0, 0, rows - 1, options.columns - 1, *options.size))
        writer.has(primary, spatial_extent(options.says or options.size))
        writer.references.append((b"dimg", primary, tiles))
    else:
        items = [writer.coded(picture, says=options.says) for picture in pictures]
        primary = items[options.primary]
    if options.turn:
        writer.has(primary, box(b"irot", bytes([options.turn // 90])))
    if options.mirror is not None:
        writer.has(primary, box(b"imir", bytes([options.mirror])))
    if options.thumbnail:
        writer.references.append((b"thmb", writer.coded(Coded(options.thumbnail)), [primary]))
    if options.exif_orientation:
        writer.references.append((b"cdsc", writer.item(b"Exif", exif(options.exif_orientation)), [primary]))
    data = writer.file(primary, b"heic" if pictures[0].kind == b"hvc1" else b"avif")
    return data[:len(data) - options.cut]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("pictures", type=Path, nargs="+")
    parser.add_argument("--columns", type=int)
    parser.add_argument("--size", type=side_by_side)
    parser.add_argument("--turn", type=int, default=0)
    parser.add_argument("--mirror", type=int)
    parser.add_argument("--exif-orientation", type=int)
    parser.add_argument("--thumbnail", type=Path)
    parser.add_argument("--primary", type=int, default=0)
    parser.add_argument("--says", type=side_by_side)
    parser.add_argument("--cut", type=int, default=0)
    options = parser.parse_args()
    options.out.write_bytes(made(options))


if __name__ == "__main__":
    main()
