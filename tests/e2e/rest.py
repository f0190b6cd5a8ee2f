#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A tablet at rest rests: on every page where nothing is felt the program hardly wakes up, with a face on it too once the
hand has gone, also after one was felt and the lab has run. Prints for each page how often its threads wake up and which share of a core they take, and which do.

rest.py PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing
"""
import glob
import subprocess
import sys
import tempfile
import time

import desk
from album import Album, preferences

MOST_WAKE_UPS = 20.0  # a second, of all threads
MOST_OF_A_CORE = 0.005
WINDOW = 3.0  # s
PAGES = ("start", "browse", "care", "settings")
BY_NUMBER = {"browse": "1", "care": "3", "settings": "4", "lab": "5"}  # of the start page


def threads(process):
    """Of each thread its name, how often it has slept, and for how long it has run, s."""
    found = {}
    for folder in glob.glob(f"/proc/{process}/task/*"):
        try:
            with open(folder + "/status", encoding="ascii", errors="replace") as status:
                lines = dict(line.rstrip("\n").split(":\t", 1) for line in status if ":\t" in line)
            with open(folder + "/schedstat", encoding="ascii") as ran:
                seconds = 1e-9 * int(ran.read().split()[0])
        except OSError:  # it has ended
            continue
        found[folder] = (lines["Name"], int(lines["voluntary_ctxt_switches"]), seconds)
    return found


def window(process):
    """Wake-ups a second, share of a core, and those threads that woke up, the busiest first."""
    before, begun = threads(process), time.monotonic()
    time.sleep(WINDOW)
    after, taken = threads(process), time.monotonic() - begun
    each = []
    for thread, (name, slept, ran) in after.items():
        _, slept_before, ran_before = before.get(thread, (name, 0, 0.0))
        each.append(((slept - slept_before) / taken, (ran - ran_before) / taken, name))
    each.sort(reverse=True)
    return sum(one[0] for one in each), sum(one[1] for one in each), [one for one in each if one[0] > 0.0]


def resting(process, where):
    """Once what the page began has ended; a machine that is busy with something else makes it no less."""
    end = time.monotonic() + desk.PATIENCE
    while True:
        wake_ups, share, busy = window(process)
        words = ", ".join(f"{name} {often:.1f}" for often, _, name in busy[:4])
        if wake_ups <= MOST_WAKE_UPS and share <= MOST_OF_A_CORE:
            print(f"{where}: {wake_ups:.1f} wake-ups a second, {100 * share:.2f} % of a core ({words})")
            return
        assert time.monotonic() < end, f"{where} does not rest: {wake_ups:.1f} wake-ups a second, " \
                                       f"{100 * share:.2f} % of a core: {words}"


def go(page, name):
    page.keys("alt+Home")
    desk.awaited(lambda: page.window().name == "TouchPhoto")
    if name != "start":
        page.keys(BY_NUMBER[name])
        desk.awaited(lambda: page.window().name != "TouchPhoto")


def visit(program, environment, first, then):
    """Opens the program on a page with something on it, and calls `then` with its number and the page."""
    with desk.started([program, "--page", first], env=environment) as running:
        then(running.pid, desk.Page())


def point(x, y):
    subprocess.run(["xdotool", "mousemove", str(int(x)), str(int(y))], check=True)


def felt(process):
    """Somebody is there: the servo ticks."""
    desk.awaited(lambda: window(process)[0] > MOST_WAKE_UPS * 10)


def after_a_face_was_felt(process, page):
    eye = page.await_name("left eye")
    point(0, 0)  # off the picture
    resting(process, "explore")
    place = eye.queryComponent().getExtents(page.atspi.DESKTOP_COORDS)
    point(place.x + place.width / 2, place.y + place.height / 2)
    felt(process)
    point(0, 0)
    resting(process, "explore, after a hand")
    go(page, "lab")
    for name in PAGES:
        go(page, name)
        resting(process, name)


def inner(program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        album = Album(lab, photos, folder)
        environment = preferences(folder, asked=True, voice="screen_reader", language="en", album_folders=[album.folder],
                                  last_photo=album.photos[0])
        visit(program, environment, "explore", after_a_face_was_felt)
        for name in ("mend", "print"):
            visit(program, environment, name, lambda process, page: (page.await_name("Home"), resting(process, name)))


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, sys.argv[1], sys.argv[2], sys.argv[3:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "/proc/self", seconds=580))
