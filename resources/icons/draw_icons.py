#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the program's icon in every size that icon themes ask for: draw_icons.py makes hicolor/SIZE/NAME.png of NAME.svg,
all beside this file.

Needs Debian's python3-gi, gir1.2-gdkpixbuf-2.0 and librsvg2-common; what is built and tested uses the files it made.
"""
import pathlib

import gi

gi.require_version("GdkPixbuf", "2.0")
from gi.repository import GdkPixbuf  # noqa: E402 (after the version was chosen)

NAME = "org.touchphoto.TouchPhoto"
SIZES = (16, 22, 24, 32, 48, 64, 96, 128, 256, 512)


def main():
    here = pathlib.Path(__file__).parent
    for size in SIZES:
        file = here / "hicolor" / f"{size}x{size}" / f"{NAME}.png"
        file.parent.mkdir(parents=True, exist_ok=True)
        GdkPixbuf.Pixbuf.new_from_file_at_size(str(here / f"{NAME}.svg"), size, size).savev(str(file), "png", [], [])


if __name__ == "__main__":
    main()
