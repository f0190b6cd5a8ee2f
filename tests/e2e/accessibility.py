#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A real accessibility client reads and operates the explore page.

accessibility.py PROGRAM PHOTO starts a display, a session bus, the accessibility bus and a window manager of its
own, then the program, and does what a screen reader would do. Exits 77, with a line that says why, where something
it needs is not installed.
"""
import importlib.util
import os
import shutil
import subprocess
import sys
import time

INNER = "TOUCHPHOTO_E2E_INNER"
LAUNCHER = "/usr/libexec/at-spi-bus-launcher"
PATIENCE = 60.0  # s; how long a thing may take on a busy machine, asserted nowhere


def what_is_missing():
    for tool in ("xvfb-run", "Xvfb", "dbus-run-session", "openbox"):
        if shutil.which(tool) is None:
            return tool
    if not os.path.exists(LAUNCHER):
        return "at-spi2-core"
    for module in ("gi", "pyatspi"):
        if importlib.util.find_spec(module) is None:
            return f"python3-{module}"
    return None


def outer():
    missing = what_is_missing()
    if missing:
        print(f"SKIP: {missing} is not installed")
        return 77
    environment = dict(os.environ, QT_QPA_PLATFORM="xcb", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", **{INNER: "1"})
    environment.pop("WAYLAND_DISPLAY", None)
    command = ["xvfb-run", "-a", "-s", "-screen 0 1400x900x24", "dbus-run-session", "--", sys.executable]
    return subprocess.run(command + [__file__] + sys.argv[1:], env=environment, timeout=280).returncode


class Page:
    """The program's window as a screen reader sees it."""

    def __init__(self, atspi):
        self.atspi = atspi

    def everything(self):
        desktop = self.atspi.Registry.getDesktop(0)
        for application in desktop:
            if application is not None and application.name == "touchphoto":
                yield from self.below(application)

    def below(self, node):
        yield node
        for i in range(node.childCount):
            try:
                child = node.getChildAtIndex(i)
            except Exception:  # it went away while we were looking
                continue
            if child is not None:
                yield from self.below(child)

    def find(self, name, role=None):
        for node in self.everything():
            try:
                if node.name == name and (role is None or node.getRole() == role):
                    return node
            except Exception:
                continue
        return None

    def await_name(self, name, role=None):
        end = time.monotonic() + PATIENCE
        while time.monotonic() < end:
            node = self.find(name, role)
            if node is not None:
                return node
            time.sleep(0.1)
        heard = sorted({f"{n.getRoleName()} \"{n.name}\"" for n in self.everything()})
        raise AssertionError(f"\"{name}\" never appeared; there are: " + ", ".join(heard))

    def press(self, name):
        node = self.await_name(name, self.atspi.ROLE_PUSH_BUTTON)
        actions = node.queryAction()
        for i in range(actions.nActions):
            if actions.getName(i).lower() == "press":
                actions.doAction(i)
                return
        raise AssertionError(f"\"{name}\" offers no press")


def check(page):
    atspi = page.atspi
    page.await_name("One face. Eyes, mouth and outline can be felt.")
    page.await_name("anna_smiling.jpg", atspi.ROLE_HEADING)
    print("found: the sentence and the heading")

    for name in ("Guided tour", "Where am I?", "Stop", "Next feature", "Open photograph…", "face", "left eye",
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
    page.await_name("Tour round the left eye.")
    page.await_name("Tour finished.")
    print("pressed: Guided tour; it went round and finished")

    page.press("Where am I?")
    page.await_name("On the left eye.")
    page.press("Stop")
    page.await_name("Force on", atspi.ROLE_PUSH_BUTTON)
    page.press("Force on")
    page.await_name("The force is on.")
    print("pressed: Where am I?, Stop, Force on")

    slider.currentValue = 0.5
    end = time.monotonic() + PATIENCE
    while abs(slider.currentValue - 0.5) > 1e-6 and time.monotonic() < end:
        time.sleep(0.1)
    assert abs(slider.currentValue - 0.5) < 1e-6, slider.currentValue
    print("set: the strongest force")


def inner(program, photo):
    import pyatspi

    helpers = [subprocess.Popen([LAUNCHER, "--launch-immediately"]), subprocess.Popen(["openbox"])]
    time.sleep(1.0)
    running = subprocess.Popen([program, "--voice", "off", photo])
    try:
        check(Page(pyatspi))
        assert running.poll() is None, "the program has ended"
        print("PASS")
        return 0
    except AssertionError as fault:
        print(f"FAIL: {fault}")
        return 1
    finally:
        for process in [running] + helpers:
            process.terminate()
            process.wait(timeout=20)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(inner(*sys.argv[1:]) if INNER in os.environ else outer())
