# SPDX-License-Identifier: Apache-2.0
"""A desk of its own for a test: display, session bus, accessibility bus and window manager, and the program on it as a
screen reader and a keyboard meet it."""
import contextlib
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import time

INNER = "TOUCHPHOTO_E2E_INNER"
STATUS = "TOUCHPHOTO_E2E_STATUS"  # a file for the verdict
LAUNCHER = "/usr/libexec/at-spi-bus-launcher"
SAID = "Last sentence: "
PATIENCE = 60.0  # s; how long a thing may take on a busy machine, asserted nowhere


def what_is_missing(*more_needed):
    """A sentence's beginning; nothing where all is there. `more_needed`: names of programs, paths of this system."""
    for needed in ("xvfb-run", "Xvfb", "dbus-run-session", "openbox") + more_needed:
        if needed.startswith("/"):
            if not os.path.exists(needed):
                return f"this system has no {needed}"
        elif shutil.which(needed) is None:
            return f"{needed} is not installed"
    if not os.path.exists(LAUNCHER):
        return "at-spi2-core is not installed"
    for module in ("gi", "pyatspi"):
        if importlib.util.find_spec(module) is None:
            return f"python3-{module} is not installed"
    return None


def at_a_desk(script, *more_needed, size="1400x900", seconds=280, opengl=False):
    """Runs `script` with its arguments once more, at a desk; its exit status, 77 where something is missing. Such a
    display has no GPU: OpenGL's pictures cost most of the time there, so some journeys alone are drawn by it."""
    missing = what_is_missing(*more_needed)
    if missing:
        print(f"SKIP: {missing}")
        return 77
    environment = dict(os.environ, QT_QPA_PLATFORM="xcb", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1", LC_ALL="C.UTF-8",
                       **{INNER: "1"})
    environment.pop("WAYLAND_DISPLAY", None)
    if not opengl:
        environment["QT_QUICK_BACKEND"] = "software"
    # -noreset: the first client that comes and goes would throw out whoever comes just then.
    command = ["xvfb-run", "-a", "-s", f"-screen 0 {size}x24 -noreset", "dbus-run-session", "--", sys.executable, script]
    with tempfile.NamedTemporaryFile("r") as status:
        environment[STATUS] = status.name
        ended = subprocess.run(command + sys.argv[1:], env=environment, timeout=seconds)
        said = status.read()
    # What a journey said itself: xvfb-run ends in 1 where the journey has killed the display.
    return int(said) if said else ended.returncode


def verdict(journey, *words):
    """Goes on a journey and says how it ended; an exit status, kept for whoever came to the desk."""
    try:
        journey(*words)
        status = 0
        print("PASS")
    except AssertionError as fault:
        status = 1
        print(f"FAIL: {fault}")
    with open(os.environ[STATUS], "w", encoding="ascii") as file:
        file.write(str(status))
    return status


def is_at_a_desk():
    return INNER in os.environ


def awaited(wanted):
    end = time.monotonic() + PATIENCE
    while not wanted():
        assert time.monotonic() < end, "waited in vain"
        time.sleep(0.05)


class Desk:
    """What stands on it besides the program; the window manager is started with these words."""

    def __init__(self, *words):
        self.manager = ["openbox", *words]

    def __enter__(self):
        self.helpers = [subprocess.Popen([LAUNCHER, "--launch-immediately"]), subprocess.Popen(self.manager)]
        time.sleep(1.0)
        return self

    def __exit__(self, *_):
        for process in self.helpers:
            process.terminate()
            process.wait(timeout=20)


@contextlib.contextmanager
def started(command, **how):
    """A program that still runs at the end of a journey, and is then told to end."""
    running = subprocess.Popen(command, **how)
    try:
        yield running
        assert running.poll() is None, "the program has ended"
    finally:
        running.terminate()
        running.wait(timeout=20)


def is_named(node, name):
    """By its name, or the beginning of it with "…" at its end; a name of its own that ends so counts too."""
    return node.name == name or name.endswith("…") and node.name.startswith(name[:-1])


class Page:
    """The program's window as a screen reader sees it, and the keyboard before it."""

    def __init__(self):
        import gi
        import pyatspi

        gi.require_version("Atspi", "2.0")
        from gi.repository import Atspi

        patience_ms = int(1000 * PATIENCE)  # of 800 ms; a busy machine stores a sheet before it answers
        Atspi.set_timeout(patience_ms, patience_ms)
        self.atspi = pyatspi

    def everything(self):
        for application in self.atspi.Registry.getDesktop(0):
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

    def window(self):
        """The first one; hit tests begin there."""
        return next(node for node in self.everything() if node.getRole() == self.atspi.ROLE_FRAME)

    def shown(self):
        """What is to be seen; pages that are not open stay in the tree."""
        for node in self.everything():
            try:
                if node.getState().contains(self.atspi.STATE_SHOWING):
                    yield node
            except Exception:
                continue

    def find(self, name, role=None):
        """By its name, as `is_named`."""
        for node in self.everything():
            try:
                if is_named(node, name) and (role is None or node.getRole() == role):
                    return node
            except Exception:
                continue
        return None

    def await_name(self, name, role=None, patience=PATIENCE):
        end = time.monotonic() + patience
        while time.monotonic() < end:
            node = self.find(name, role)
            if node is not None:
                return node
            time.sleep(0.1)
        heard = sorted({f"{n.getRoleName()} \"{n.name}\"" for n in self.everything()})
        raise AssertionError(f"\"{name}\" never appeared; there are: " + ", ".join(heard))

    def act(self, node, wanted="press"):
        actions = node.queryAction()
        for i in range(actions.nActions):
            if actions.getName(i).lower() == wanted:
                actions.doAction(i)
                return
        raise AssertionError(f"\"{node.name}\" offers no {wanted}")

    def press(self, name, role=None):
        self.act(self.await_name(name, role))

    def keys(self, *names):
        """Keys as xdotool names them, one after the other."""
        for name in names:
            subprocess.run(["xdotool", "key", "--clearmodifiers", name], check=True)

    def again(self, name, times):
        """A key so often, quickly."""
        if times > 0:
            subprocess.run(["xdotool", "key", "--clearmodifiers", *[name] * times], check=True)

    def type(self, text):
        subprocess.run(["xdotool", "type", "--delay", "30", text], check=True)


class Listener:
    """Everything that the program says, in order: the words in its bar at the bottom, as they change. A quick one goes on
    as soon as it hears what it awaits, as people do who know what comes next."""

    def __init__(self, quick=False):
        import gi

        gi.require_version("Atspi", "2.0")
        from gi.repository import Atspi, GLib

        self.heard, self.quick = [], quick
        self.context = GLib.MainContext.default()
        self.listener = Atspi.EventListener.new(self.note)
        self.listener.register("object:property-change:accessible-name")

    def note(self, event):
        try:
            name = event.source.get_name()  # as it is now: of two sentences at once the last one is heard
        except Exception:  # it went away
            return
        if name.startswith(SAID):
            self.heard.append(name[len(SAID):])

    def listen(self, seconds=0.2, for_one=False):
        """For so long; `for_one` sentence more at most."""
        end, before = time.monotonic() + seconds, len(self.heard)
        while time.monotonic() < end and not (for_one and len(self.heard) > before):
            while self.context.iteration(False):
                pass
            time.sleep(0.01)

    def await_words(self, *sentences):
        """These were said after what was awaited before, in this order; others may come between. What is matched is a
        part of each."""
        end = time.monotonic() + PATIENCE
        for sentence in sentences:
            while True:
                places = [i for i, heard in enumerate(self.heard) if sentence in heard]
                if places:
                    del self.heard[: places[0] + 1]
                    break
                if time.monotonic() > end:
                    raise AssertionError(f"\"{sentence}\" was never said; heard since: {self.heard}")
                self.listen(for_one=self.quick)
