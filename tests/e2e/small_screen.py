#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The program on a small screen, 1024 by 600 pixels of which a panel takes 40 at the bottom and its frame some more: its
window lies whole in what is left, and on each of its pages what was said last lies whole in the window. In Care's People Tab
comes to everything, in sight. Asked to end, as when a person logs out, the program ends in good order.

small_screen.py PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing
PHOTOS: one person is on three of them.
"""
import os
import subprocess
import sys
import tempfile
import time

import desk
from album import Album, preferences
from every_page import Focus, Walker

SCREEN = (1024, 600)
PANEL = 40  # px, at the bottom
CONFIG = f"""<?xml version="1.0"?>
<openbox_config xmlns="http://openbox.org/3.4/rc"><margins><bottom>{PANEL}</bottom></margins></openbox_config>
"""
PAGES = (None, "browse", "explore", "care", "capture", "settings", "lab", "study")


def extents(page, node):
    place = node.queryComponent().getExtents(page.atspi.DESKTOP_COORDS)
    return place.x, place.y, place.x + place.width, place.y + place.height


def within(inner, outer):
    return inner[0] >= outer[0] and inner[1] >= outer[1] and inner[2] <= outer[2] and inner[3] <= outer[3]


def frame(window):
    """What the window manager has put round it, px: left, right, top, bottom."""
    told = subprocess.run(["xprop", "-id", window, "_NET_FRAME_EXTENTS"], capture_output=True, text=True, check=True).stdout
    return [int(number) for number in told.split("=")[1].split(",")]


def window_with_frame(page):
    window = subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "TouchPhoto"], capture_output=True, text=True,
                            check=True).stdout.split()[0]
    inside, (left, right, top, bottom) = extents(page, page.window()), frame(window)
    assert top > 10, f"the window has no title bar: {top} px"
    return inside, (inside[0] - left, inside[1] - top, inside[2] + right, inside[3] + bottom)


def awaited(what, wanted):
    """The value once it is there; else what is wrong with it."""
    end = time.monotonic() + desk.PATIENCE
    while (fault := wanted()) is not None:
        assert time.monotonic() < end, f"{what}: {fault}"
        time.sleep(0.1)


def fault_of_window(page):
    _, outside = window_with_frame(page)
    room = (0, 0, SCREEN[0], SCREEN[1] - PANEL)
    return None if within(outside, room) else f"it lies at {outside}, and {room} is left"


def fault_of_words(page):
    inside, _ = window_with_frame(page)
    said = [node for node in page.shown() if node.name.startswith(desk.SAID)]
    if not said:
        return "nothing was said"
    place = extents(page, said[0])
    return None if within(place, inside) and place[3] > place[1] else f"\"{said[0].name}\" lies at {place}, the window at {inside}"


def walk_people(running, page, focus):
    """Through the people of the album, and through one of them."""
    walker = Walker(running, page, focus)
    walker.press("People…")
    # The program looks in its own time: until nothing comes any more, rows move under the keyboard.
    page.await_name("2 people without a name. 1 face on one photograph only.", patience=3 * desk.PATIENCE)
    ways = [walker.goes_round(0)]
    walker.press("Who is this?, 3 photographs, …")
    walker.tab_to("ben_angry.jpg, …")
    page.keys("Return")
    ways.append(walker.goes_round(0))
    for way, wanted in zip(ways, ({"Back to the photographs"}, {"Back to the people", "Name", "Not this person"})):
        names = {stop.name for stop in way}
        assert wanted <= names, f"Tab never comes to {wanted - names}, only to {sorted(names)}"
        walker.in_reading_order(way)
    awaited("what was said last among people", lambda: fault_of_words(page))


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder:
        config = os.path.join(folder, "openbox.xml")
        with open(config, "w", encoding="utf-8") as file:
            file.write(CONFIG)
        with desk.Desk("--config-file", config):
            album, focus = Album(lab, photos, folder), Focus()
            for name in PAGES:
                environment = preferences(folder, asked=True, voice="screen_reader", language="en", album_folders=[album.folder])
                running = subprocess.Popen([program] + ([] if name is None else ["--page", name]), env=environment)
                try:
                    page = desk.Page()
                    page.await_name("Home" if name else "Help")
                    awaited(f"the window of {name or 'start'}", lambda: fault_of_window(page))
                    awaited(f"what was said last on {name or 'start'}", lambda: fault_of_words(page))
                    if name == "care":
                        walk_people(running, page, focus)
                finally:
                    running.terminate()
                    ended = running.wait(timeout=desk.PATIENCE)
                assert ended == 0, f"asked to end, the program did not end in good order: {ended}"


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, sys.argv[1], sys.argv[2], sys.argv[3:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "xprop", size=f"{SCREEN[0]}x{SCREEN[1]}"))
