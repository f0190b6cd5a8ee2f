#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A real accessibility client reads and operates the explore page.

accessibility.py PROGRAM PHOTO starts a display, a session bus, the accessibility bus and a window manager of its
own, then the program, and does what a screen reader would do. Exits 77, with a line that says why, where something
it needs is not installed.
"""
import sys
import time

import desk
from desk import PATIENCE


def check(page, listener):
    atspi = page.atspi
    page.await_name("left eye", atspi.ROLE_PUSH_BUTTON)
    page.await_name("anna_smiling.jpg", atspi.ROLE_HEADING)
    print("found: the eye and the heading")

    for name in ("Guided tour", "Tour of the face", "Where am I?", "Stop", "Zoom in", "Zoom out", "Next feature", "Open photograph…", "face", "left eye",
                 "right eye", "lips", "mouth opening", "face outline"):
        page.await_name(name, atspi.ROLE_PUSH_BUTTON)
    page.await_name("Voice", atspi.ROLE_CHECK_BOX)
    slider = page.await_name("Strongest force", atspi.ROLE_SLIDER).queryValue()
    assert (slider.minimumValue, slider.maximumValue) == (0.1, 1.5), (slider.minimumValue, slider.maximumValue)
    for node in page.everything():
        if node.getRole() in (atspi.ROLE_PUSH_BUTTON, atspi.ROLE_CHECK_BOX, atspi.ROLE_SLIDER, atspi.ROLE_CANVAS):
            assert node.name, f"a {node.getRoleName()} has no name"
    print("found: every control, each with a name")

    eye = page.await_name("left eye", atspi.ROLE_PUSH_BUTTON)
    place = eye.queryComponent().getExtents(atspi.DESKTOP_COORDS)
    assert place.width > 10 and place.height > 5, place
    page.press("left eye")
    page.await_name("Under the finger: left eye")
    page.await_name("left eye", atspi.ROLE_NOTIFICATION)
    print("pressed: left eye; the finger is there and a notification says so")

    page.press("Guided tour")
    listener.await_words("Tour round the left eye.")
    listener.await_words("Tour finished.")
    print("pressed: Guided tour; it went round and finished")

    page.press("Where am I?")
    listener.await_words("The face. On the left eye, at its ")
    page.press("Stop")
    page.await_name("Force on", atspi.ROLE_PUSH_BUTTON)
    page.press("Force on")
    listener.await_words("The force is on.")
    print("pressed: Where am I?, Stop, Force on")

    page.press("Zoom in")
    listener.await_words("Zoomed to the eyes.")
    page.press("Zoom out")
    listener.await_words("Zoomed out to the whole face.")
    page.press("Tour of the face")
    listener.await_words("Tour of the face: ")
    page.press("Stop")
    page.press("Guide: Beeps")
    print("pressed: Zoom in, Zoom out, Tour of the face, a guide")

    slider.currentValue = 0.5
    end = time.monotonic() + PATIENCE
    while abs(slider.currentValue - 0.5) > 1e-6 and time.monotonic() < end:
        time.sleep(0.1)
    assert abs(slider.currentValue - 0.5) < 1e-6, slider.currentValue
    print("set: the strongest force")


def inner(program, photo):
    with desk.Desk():
        listener = desk.Listener()
        with desk.started([program, "--voice", "off", photo]):
            check(desk.Page(), listener)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:]) if desk.is_at_a_desk() else desk.at_a_desk(__file__))
