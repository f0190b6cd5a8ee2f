#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A blind person feels a face by ticks under a bare finger, by keys, pointer and what the program says: ticks are chosen, tried
and measured in the settings; in Explore they come at the output where a line is crossed, lead on a tour, give way to the drawn
finger when the output is unplugged, and come back with it. What reaches the output is read from it. What is said, in each
language; what the finger feels, in the first.

ticks.py PROGRAM LAB PHOTO    ends in 77 where something is missing; TP_PICTURES=FOLDER keeps what was on the screen
"""
import json
import os
import subprocess
import sys
import tempfile
import time

import desk
from album import Album, preferences
from study import Screen, Words

LANGUAGES = ("en", "de", "ko")
STRENGTH = 0.5
SURFACE_MM = 200  # wide
STEP = 2  # px from place to place of a sweep
STEP_S = 0.03
NEAR_MM = 2.0  # a tick to the line that it tells of, with what the finger went on meanwhile
CHEEK_MM = 35  # below an eye, from where there is no line on the way to it
ASIDE_MM = 8  # away from the place that leads
REACTION_S = 0.3  # of the person, who is no faster than people are
TESTS = 3  # at most: a busy machine may be too late for one


class Motor:
    """The output: a file, which is plugged in while it is there (device/touch_output/force_feedback/motor_file.hpp)."""

    def __init__(self, folder):
        self.file = os.path.join(folder, "motor")
        self.name = "simulated:" + self.file

    def plug_in(self):
        with open(self.file, "w", encoding="ascii"):
            pass

    def unplug(self):
        os.remove(self.file)

    def lines(self):
        with open(self.file, encoding="ascii") as file:
            return [line.split()[1:] for line in file.read().splitlines()]

    def ticks(self):
        """Thousandths of the full amplitude, one after the other."""
        return [int(line[1]) for line in self.lines() if line[0] == "tick"]

    def awaits_tick(self, before):
        desk.awaited(lambda: len(self.ticks()) > before)


def latencies_in(preferences_file):
    """Of outputs by their names, s."""
    with open(preferences_file, encoding="utf-8") as file:
        return json.load(file)["touch_latencies_s"]


class Person:
    def __init__(self, page, listener, words, motor, screen, pictures):
        self.page, self.listener, self.words, self.motor = page, listener, words, motor
        self.screen, self.pictures = screen, pictures
        self.pointer = None

    def hears(self, *sentences):
        self.listener.await_words(*sentences)
        for sentence in sentences:
            print("heard:", sentence)

    def keep_picture(self, name):
        if self.pictures:
            self.screen.part((0, 0, 8, 8), os.path.join(self.pictures, f"{name}-{self.words.language}.png"))

    def picks(self, label, option):
        words = self.words
        name = words("%1: %2", words(label), words(option))
        self.page.act(self.page.await_name(name, self.page.atspi.ROLE_RADIO_BUTTON), "toggle")

    def opens_page(self, number):
        self.page.await_name("4: " + self.words("Settings") + "…")
        desk.awaited(lambda: any(node.getState().contains(self.page.atspi.STATE_FOCUSED) for node in self.page.shown()
                                 if node.getRole() != self.page.atspi.ROLE_FRAME))
        self.page.keys(str(number))

    # Settings

    def chooses_ticks(self):
        words = self.words
        self.picks("Guide when there is no force", "Ticks under the finger")
        self.hears(words("Ticks under the finger") + ".")
        self.picks("What ticks under the finger", "simulated motor")
        self.hears(words("Ticks: %1.", words("simulated motor")))
        slider = self.page.await_name(words("Strength of ticks"), self.page.atspi.ROLE_SLIDER)
        slider.queryValue().currentValue = STRENGTH
        self.hears(words("Strength of ticks: %1 percent.", round(100 * STRENGTH)))

    def feels_one_tick(self):
        button = self.page.await_name(self.words("Feel a tick now"))
        button.queryComponent().grabFocus()
        time.sleep(0.5)  # it is scrolled to
        self.keep_picture("settings")
        self.page.act(button)
        self.motor.awaits_tick(0)
        desk.awaited(lambda: self.motor.lines()[-1] == ["closed"])
        assert self.motor.ticks() == [round(1000 * STRENGTH)], self.motor.lines()

    def measures(self, preferences_file):
        """How late ticks are felt, by taps; it is kept for this output."""
        words = self.words
        late = words.beginning("Ticks are felt %n millisecond(s) late.")
        button = self.page.await_name(words("Measure how late ticks are felt"))
        for _ in range(TESTS):
            before = len(self.motor.ticks())
            closed = self.motor.lines().count(["closed"])
            self.page.act(button)
            while self.motor.lines().count(["closed"]) == closed:
                if len(self.motor.ticks()) > before:
                    before = len(self.motor.ticks())
                    time.sleep(REACTION_S)
                    self.page.act(button)
                time.sleep(0.01)
            self.listener.listen(0.5)
            said = [heard for heard in self.listener.heard if heard.startswith(late)]
            if said:
                print("heard:", said[-1])
                desk.awaited(lambda: list(latencies_in(preferences_file)) == [self.motor.name])
                return
        raise AssertionError(f"no test by taps was answered: {self.listener.heard[-5:]}")

    # Explore

    def feels(self):
        self.page.keys("Escape", "Escape")
        self.hears("1: " + self.words("Listen to photographs"))
        self.page.keys("1")
        self.listener.listen(1.0)
        self.page.keys("e")
        self.hears(self.words("Ticks: %1.", self.words("simulated motor")))

    def place_of(self, name, role):
        """Once it stays where it is: other words below may take other lines, and all above moves."""
        thing, places = self.page.await_name(name, role).queryComponent(), [None]
        while len(places) < 2 or places[-1] != places[-2]:
            time.sleep(0.5)
            place = thing.getExtents(self.page.atspi.DESKTOP_COORDS)
            places.append((place.x, place.y, place.width, place.height))
        return places[-1]

    def moves_to(self, x, y):
        subprocess.run(["xdotool", "mousemove", str(round(x)), str(round(y))], check=True)
        self.pointer = (x, y)

    def sweeps(self, x, from_y, to_y):
        """Down; where the pointer was when ticks came, px."""
        self.moves_to(x, from_y)
        self.rests()
        places, before = [], len(self.motor.ticks())
        for y in range(round(from_y), round(to_y), STEP):
            self.moves_to(x, y)
            time.sleep(STEP_S)
            now = len(self.motor.ticks())
            places += [y] * (now - before)
            before = now
        return places

    def rests(self):
        """Until what the pointer's way has crossed is told; then there are no ticks."""
        time.sleep(0.5)
        before = len(self.motor.ticks())
        time.sleep(1.0)
        assert len(self.motor.ticks()) == before, "it ticks under a finger that rests"

    def crosses_the_lids(self):
        """Over the upper lid of an eye: nothing above it, and a tick on it."""
        x, y, width, _ = self.place_of(self.eye(), self.page.atspi.ROLE_PUSH_BUTTON)
        near = NEAR_MM * self.pixels_per_mm()
        for _ in range(TESTS):
            places = self.sweeps(x + width / 2, y - 5 * near, y + 2 * near)
            print("ticks at", [place - y for place in places], "px from the lid,", round(near), "are near")
            if places and all(abs(place - y) <= near for place in places):
                return
        raise AssertionError("it does not tick where a line is crossed, and there alone")

    def eye(self):
        return self.words("left eye", context="tp::FeatureLabels")

    def pixels_per_mm(self):
        surface = next(node for node in self.page.shown() if node.getRole() == self.page.atspi.ROLE_CANVAS)
        return surface.queryComponent().getExtents(self.page.atspi.DESKTOP_COORDS).width / SURFACE_MM

    def ticks_in(self, seconds):
        """Of a hand that rests, on a tour; what it has just passed apart."""
        time.sleep(0.5)
        before = len(self.motor.ticks())
        time.sleep(seconds)
        return self.motor.ticks()[before:]

    def hears_of_a_tour(self):
        self.page.press(self.words("Guided tour"))
        self.hears(self.words("Tour round the %1. Follow the ticks: they grow toward the line.", self.eye()))

    def ends_the_tour(self):
        self.keep_picture("tour")
        self.page.press(self.words("End the tour"))
        self.listener.listen(0.5)

    def goes_to_the_cheek(self):
        """Below the eye, which is chosen; where the eye ends, px."""
        x, y, width, height = self.place_of(self.eye(), self.page.atspi.ROLE_PUSH_BUTTON)
        self.page.press(self.eye())
        self.moves_to(x + width / 2, y + height + CHEEK_MM * self.pixels_per_mm())
        self.rests()
        return x + width / 2, y + height

    def follows_a_tour(self):
        scale, (column, end) = self.pixels_per_mm(), self.goes_to_the_cheek()
        before = len(self.motor.ticks())
        self.hears_of_a_tour()
        self.motor.awaits_tick(before)
        time.sleep(1.0)  # the place that leads is as far ahead as it goes, and waits
        self.moves_to(column, end + (CHEEK_MM + ASIDE_MM) * scale)
        away = self.ticks_in(1.5)
        for left in range(CHEEK_MM + ASIDE_MM, 4, -1):  # of the way
            self.moves_to(column, end + left * scale)
            time.sleep(STEP_S)
        toward = self.ticks_in(1.0)
        print("ticks of a hand that goes away:", away, "that comes after:", toward)
        assert away and toward and min(toward) > 1.5 * max(away), "they do not grow toward the place that leads"

    def loses_it_and_finds_it_again(self):
        words = self.words
        self.listener.listen(0.5)
        self.listener.heard.clear()
        self.motor.unplug()
        name, drawn = words("simulated motor"), words("drawn finger")
        gone = words("%1 is gone. Until it is there again, ticks come from: %2.", name[0].upper() + name[1:], drawn)
        self.listener.listen(4.0)
        heard = [sentence for sentence in self.listener.heard if sentence != self.eye()]  # where the finger lies
        assert heard == [gone], f"not \"{gone}\" alone, but {self.listener.heard}"
        print("heard:", gone)
        self.page.keys("w")
        desk.awaited(lambda: self.listener.listen() or len(self.listener.heard) > 1)  # words go on
        self.motor.plug_in()
        self.hears(words("Ticks: %1.", name))


def journey(program, album, folder, language, listener, screen):
    words, motor = Words(language), Motor(folder)
    motor.plug_in()
    desk.SAID = words("Last sentence") + ": "  # the listener knows it by that
    environment = preferences(folder, asked=True, voice="screen_reader", language=language, album_folders=[album.folder])
    running = subprocess.Popen([program, "--touch", motor.name], env=environment)
    try:
        person = Person(desk.Page(), listener, words, motor, screen, os.environ.get("TP_PICTURES"))
        person.opens_page(4)
        person.chooses_ticks()
        person.feels_one_tick()
        person.measures(os.path.join(environment["XDG_CONFIG_HOME"], "touchphoto", "preferences.json"))
        person.feels()
        person.keep_picture("explore")
        if language == LANGUAGES[0]:
            person.crosses_the_lids()
            person.follows_a_tour()
        else:
            person.goes_to_the_cheek()
            person.hears_of_a_tour()
        person.ends_the_tour()
        person.loses_it_and_finds_it_again()
        if language == LANGUAGES[0]:
            person.crosses_the_lids()
        assert running.poll() is None, "the program has ended"
    finally:
        running.terminate()
        ended = running.wait(timeout=20)
    assert ended == 0, f"asked to end, the program did not end in good order: {ended}"
    assert motor.lines()[-1] == ["closed"], f"the output was not given back: {motor.lines()[-3:]}"


def inner(program, lab, photo):
    with desk.Desk():
        listener, screen = desk.Listener(), Screen()
        for language in LANGUAGES:
            with tempfile.TemporaryDirectory() as folder:
                journey(program, Album(lab, [photo], folder), folder, language, listener, screen)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:]) if desk.is_at_a_desk() else desk.at_a_desk(__file__, "xdotool", seconds=580))
