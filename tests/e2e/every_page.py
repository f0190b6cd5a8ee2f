#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A real accessibility client goes over every page, in every language, with ordinary and with twice as large text, in a wide and
in a tall window: whatever can be used has a name, a role, an action and the required size. In the language with the longest words,
Tab goes round every page, in reading order, and never stays, and where it comes to is in sight.

every_page.py [--whole] PROGRAM LAB PHOTOS...    ends in 77 where something that it needs is missing

Every page is seen in every pair of a language, a size of text and a shape of the window; with --whole in all twelve of the three.
"""
import os
import subprocess
import sys
import tempfile
import time

import desk
from album import Album, preferences

LANGUAGES = ("en", "de", "ko")
LONGEST_WORDS = "de"  # where pages are longest; Tab's way is the same in every language
WIDE, TALL = (1280, 800), (800, 1280)
SHAPES = {(language, text_scale): shape for shape, seen in (  # the longest words, twice as large, where there is least room
    (WIDE, (("en", 2.0), ("de", 1.0), ("ko", 1.0))), (TALL, (("en", 1.0), ("de", 2.0), ("ko", 2.0)))) for language, text_scale in seen}
SMALLEST = 48  # px, a caregiver's target; DESIGN.md, section 10
BY_NUMBER = {"browse": "1", "explore": "2", "care": "3", "settings": "4", "lab": "5", "capture": "6", "study": "7"}  # of the start page
MOST_STOPS = 400  # of Tab on one page; more is no way round


class Focus:
    """Where the keyboard is, as the program tells its clients; and keys, which are not waited for, since it is heard what each does."""

    def __init__(self):
        import gi

        gi.require_version("Atspi", "2.0")
        from gi.repository import Atspi, GLib

        self.told = None
        self.context = GLib.MainContext.default()
        self.listener = Atspi.EventListener.new(self.note)
        self.listener.register("object:state-changed:focused")
        self.typist = subprocess.Popen(["xdotool", "-"], stdin=subprocess.PIPE, text=True)  # ends with us

    def note(self, event):
        if event.detail1:
            self.told = event.source

    def after(self, key):
        """What is told last after `key`, and then for a moment no more; None where nothing is told."""
        self.listen(0.0)
        self.told = None
        self.typist.stdin.write(f"key --clearmodifiers {key}\n")
        self.typist.stdin.flush()
        end = time.monotonic() + desk.PATIENCE
        while self.told is None:
            if time.monotonic() >= end:
                return None
            self.listen(0.02)
        self.listen(0.05)
        return self.told

    def listen(self, seconds):
        end = time.monotonic() + seconds
        while True:
            while self.context.iteration(False):
                pass
            if time.monotonic() >= end:
                return
            time.sleep(0.005)


class Walker:
    """A person's way over the pages of one running program."""

    def __init__(self, running, page, focus):
        self.running, self.page, self.focus, self.atspi = running, page, focus, page.atspi
        self.frame = None  # of the one window, found once
        self.used = {self.atspi.ROLE_PUSH_BUTTON: "press", self.atspi.ROLE_CHECK_BOX: "toggle",
                     self.atspi.ROLE_RADIO_BUTTON: "toggle", self.atspi.ROLE_LIST_ITEM: "press",
                     self.atspi.ROLE_SLIDER: "increase"}
        self.also_focused = (self.atspi.ROLE_TEXT, self.atspi.ROLE_ENTRY, self.atspi.ROLE_CANVAS, self.atspi.ROLE_LIST)

    def seen(self, node=None):
        """What is to be seen, in reading order; pages that are not open are passed over whole."""
        node = node or self.window()
        try:
            states = node.getState()
            if not states.contains(self.atspi.STATE_VISIBLE):
                return
            yield node
            children = [node.getChildAtIndex(i) for i in range(node.childCount)]
        except Exception:  # it went away while we were looking
            return
        for child in children:
            if child is not None:
                yield from self.seen(child)

    def window(self):
        if self.frame is None:
            self.frame = self.awaited("a window", lambda: next((node for node in self.page.everything()
                                                                if node.getRole() == self.atspi.ROLE_FRAME), None))
        return self.frame

    def place(self, node):
        return node.queryComponent().getExtents(self.atspi.DESKTOP_COORDS)

    def usable(self):
        """What a person can act on or write into."""
        for node in self.seen():
            if node.getRole() in self.used or node.getRole() in self.also_focused:
                states = node.getState()
                if states.contains(self.atspi.STATE_FOCUSABLE) and states.contains(self.atspi.STATE_ENABLED):
                    yield node

    def faults(self, node):
        what = f"{node.getRoleName()} \"{node.name}\""
        if not node.name.strip():
            yield what + " has no name"
        place = self.place(node)
        on_a_surface = node.parent is not None and node.parent.getRole() in (self.atspi.ROLE_CANVAS, self.atspi.ROLE_PUSH_BUTTON)
        if not on_a_surface and (place.width < SMALLEST or place.height < SMALLEST):
            yield f"{what} is {place.width} by {place.height} pixels large"
        if node.getRole() in self.used:
            actions = node.queryAction()
            offered = [actions.getName(i).lower() for i in range(actions.nActions)]
            if self.used[node.getRole()] not in offered:
                yield f"{what} offers {offered}"
        elif node.getRole() not in self.also_focused:
            yield what + " has a role that says nothing of its use"

    def faultless(self, where):
        """Once the page has come to rest."""
        end = time.monotonic() + desk.PATIENCE / 6
        while faults := [fault for node in self.usable() for fault in self.faults(node)]:
            assert time.monotonic() < end, f"{where}: " + "; ".join(faults)
            time.sleep(0.1)

    def focused(self):
        for node in self.seen():
            if node.getState().contains(self.atspi.STATE_FOCUSED) and node.getRole() != self.atspi.ROLE_FRAME:
                return node
        return None

    def awaited(self, what, wanted):
        end = time.monotonic() + desk.PATIENCE
        while time.monotonic() < end:
            got = wanted()
            if got:
                return got
            assert self.running.poll() is None, "the program has ended"
            time.sleep(0.05)
        raise AssertionError(f"{what}: waited in vain")

    def press(self, name):
        """What is to be seen and is named so; pages that are not open have such things too."""
        self.page.act(self.awaited(name, lambda: next((node for node in self.seen() if desk.is_named(node, name)), None)))

    def shape(self, size):
        """Gives the window a size, and waits until it has it."""
        if self.place(self.window()).width == size[0]:
            return
        name = str(self.window().name)
        command = ["xdotool", "search", "--onlyvisible", "--name", "TouchPhoto", "windowsize", "--sync", *map(str, size)]
        self.awaited(f"{name} on the display", lambda: subprocess.run(command).returncode == 0)  # 1: it is not there yet
        self.awaited(f"{name} in {size}", lambda: self.place(self.window()).width == size[0])

    def turned(self):
        """The window is turned over an open page, and back; what a page complains of then is read with the rest."""
        place = self.place(self.window())
        self.shape((place.height, place.width))
        self.shape((place.width, place.height))

    def go(self, name):
        if name in BY_NUMBER:
            self.go("start")
            title = self.window().name
            self.page.keys(BY_NUMBER[name])
            self.awaited(name, lambda: self.window().name != title)
        elif name == "start":
            self.page.keys("alt+Home")
            self.awaited("the start page", lambda: self.window().name == "TouchPhoto")
        self.awaited(f"a keyboard on {name}", self.focused)

    def points(self, name):
        """Through how many points of what has the keyboard Tab goes before it leaves; they come with the photograph."""
        if name == "mend":
            return self.awaited("the points of a contour", lambda: sum(
                child.getRole() == self.atspi.ROLE_PUSH_BUTTON for child in self.focused() if child is not None))
        if name == "explore":  # its features, once a face is found
            return self.awaited("a face", lambda: sum(face.childCount for face in self.focused() if face is not None))
        return 0

    def goes_round(self, points):
        """Presses Tab until it is where it was first; what was on the way, each in sight and without fault. Of the first,
        Tab goes through so many points before it leaves."""
        first = self.focused()
        self.page.again("Tab", points)
        stops = [first]
        window = self.place(self.window())
        while len(stops) <= MOST_STOPS:
            now = self.focus.after("Tab")
            if now is None:
                raise AssertionError(f"{self.window().name}: the keyboard stays where it is, told on {stops[-1].name}, "
                                     f"by its state on {self.focused()}; it went through {points} points first")
            if now == first:
                return stops
            place = self.place(now)
            middle = (place.x + place.width / 2, place.y + place.height / 2)
            in_sight = window.x <= middle[0] <= window.x + window.width and window.y <= middle[1] <= window.y + window.height
            faults = list(self.faults(now)) + ([] if in_sight else [f"\"{now.name}\" lies out of sight at {middle}"])
            assert not faults, "Tab comes to a thing with faults: " + "; ".join(faults)
            stops.append(now)
        raise AssertionError("no way round by Tab: " + ", ".join(stop.name for stop in stops[-8:]))

    def place_in_tree(self, node):
        """The way down to it: what is read before something else has the smaller one."""
        way = []
        while node is not None and node.getRole() != self.atspi.ROLE_FRAME:
            way.insert(0, node.getIndexInParent())
            node = node.parent
        return way

    def tab_to(self, name):
        """Presses Tab until the keyboard is on what is named so."""
        for _ in range(MOST_STOPS):
            if desk.is_named(self.awaited("a keyboard", self.focused), name):
                return
            self.focus.after("Tab")
        raise AssertionError(f"Tab never comes to {name}")

    def in_reading_order(self, stops):
        places = [self.place_in_tree(stop) for stop in stops]
        begin = places.index(min(places))
        places = places[begin:] + places[:begin]
        assert places == sorted(places), "Tab does not go in reading order: " + ", ".join(stop.name for stop in stops)


def warnings(file):
    """What QML complained of."""
    with open(file, encoding="utf-8") as lines:
        return [line.strip() for line in lines if line.startswith("qrc:") or ".qml:" in line]


def walk(program, album, folder, focus, language, text_scale, shapes):
    """Every page of one language and size of text, in windows of these shapes; at how many places Tab stopped, where it went
    round."""
    count = 0
    complaints = os.path.join(folder, "stderr.txt")
    for first, names in (("mend", ("mend", "start", *BY_NUMBER)), ("print", ("print",))):
        environment = preferences(folder, asked=True, voice="screen_reader", language=language, text_scale=text_scale,
                                  album_folders=[album.folder], last_photo=album.photos[0])
        with open(complaints, "w", encoding="utf-8") as file:
            running = subprocess.Popen([program, "--page", first, "--camera", "simulated:" + album.photos[0], "--size", "x".join(map(str, shapes[0]))], env=environment, stderr=file)
        try:
            walker = Walker(running, desk.Page(), focus)
            for name in names:
                for size in shapes:
                    walker.shape(size)
                    walker.go(name)
                    where = f"{name}, {language}, text {text_scale:g}, {size[0]}x{size[1]}"
                    walker.awaited(where, lambda: next(walker.usable(), None))
                    walker.faultless(where)
                if language == LONGEST_WORDS:
                    stops = walker.goes_round(walker.points(name))
                    walker.in_reading_order(stops)
                    count += len(stops)
                    walker.turned()
            assert running.poll() is None, "the program has ended"
        finally:
            running.terminate()
            running.wait(timeout=20)
        assert not warnings(complaints), f"{first}, {language}, text {text_scale:g}: " + "; ".join(warnings(complaints))
    return count


def inner(whole, program, lab, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        album = Album(lab, photos, folder)
        album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", album.photos[0], "Anna")
        focus = Focus()
        for language in LANGUAGES:
            for text_scale in (1.0, 2.0):
                shapes = (WIDE, TALL) if whole else (SHAPES[language, text_scale],)
                count = walk(program, album, folder, focus, language, text_scale, shapes)
                seen = " and ".join(f"{wide}x{high}" for wide, high in shapes)
                stopped = f"; Tab stopped {count} times, always in sight" if count else ""
                print(f"{language}, text {text_scale:g}, {seen}: without fault{stopped}")


if __name__ == "__main__":
    words = [word for word in sys.argv[1:] if word != "--whole"]
    if len(words) < 3:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, "--whole" in sys.argv, words[0], words[1], words[2:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", size="1400x1400", seconds=1180))
