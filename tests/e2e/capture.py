#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A blind person takes a photograph, by keys and by what the program says: from the start page to the camera, which looks
into a photograph and is moved by keys, as it is told; the photograph is taken by itself, who is on it is told by the name that
the album knows, a memo is spoken for it, and it is found in Browse and felt in Explore. In each language.

capture.py PROGRAM LAB FACE PHOTOS...    FACE is what the camera looks at; ends in 77 where something is missing
"""
import os
import re
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

import desk
import sound_server
from album import Album, preferences, tone

LANGUAGES = ("en", "de", "ko")
CATALOGUES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "resources", "translations")
KEYS = {"left": ("Left",), "right": ("Right",), "up": ("Up",), "down": ("Down",), "closer": ("Prior",), "back": ("Next",),
        "clockwise": ("shift+Right",), "anticlockwise": ("shift+Left",)}
STEPS = {"a little {}": 2, "{}": 4, "far {}": 8, "much {}": 8}
PATIENT_FOR = 10.0  # s, without a word
MOST_SENTENCES = 60  # until the photograph is taken
NAME = "Clara Muster"  # of whom FACE shows, who is in the album


class Words:
    """What the pages say in a language, by what their sources say."""

    def __init__(self, language):
        self.known = {}
        if language == "en":
            return
        for message in xml.etree.ElementTree.parse(os.path.join(CATALOGUES, f"touchphoto_{language}.ts")).iter("message"):
            translation = message.find("translation")
            forms = translation.findall("numerusform")
            self.known.setdefault(message.find("source").text, forms[0].text if forms else translation.text)

    def __call__(self, source):
        return self.known.get(source, source)

    def beginning(self, source):
        """Until the first thing that varies."""
        return re.split("%", self(source))[0].strip()


def hand(words):
    """What is said of a way to go, and the keys that go it."""
    ways = {}
    for way, keys in KEYS.items():
        for pattern, steps in STEPS.items():
            said = words(pattern.format(way))
            if said != pattern.format(way) or not words.known:
                ways[said[0].upper() + said[1:] + "."] = keys * steps
                ways[words("Move the tablet: %1.").replace("%1", said)] = keys * steps
    return ways


class Photographer:
    def __init__(self, page, listener, words, album):
        self.page, self.listener, self.words, self.album = page, listener, words, album
        self.ways = hand(words)

    def hears(self, *sources):
        for source in sources:
            self.listener.await_words(self.words.beginning(source))
            print("heard:", self.words.beginning(source))

    def has_the_keyboard(self):
        return any(node.getState().contains(self.page.atspi.STATE_FOCUSED) for node in self.page.shown()
                   if node.getRole() != self.page.atspi.ROLE_FRAME)

    def photographs(self):
        return sorted(name for name in os.listdir(self.album.folder) if name.endswith(".jpg"))

    def aims(self, before):
        """Does what is said until there is a new photograph; how often something was said that is to be done. Who waits in
        vain, on a machine that is too busy to see many frames a second, presses Space."""
        end = time.monotonic() + desk.PATIENCE
        heard_at = time.monotonic()
        done = 0
        while len(self.photographs()) == before:
            assert time.monotonic() < end and done < MOST_SENTENCES, f"not taken; said last: {self.listener.heard[-8:]}"
            self.listener.listen(0.1)
            if time.monotonic() > heard_at + PATIENT_FOR:
                heard_at = time.monotonic()
                self.page.keys("space")
            if not self.listener.heard:
                continue
            heard_at = time.monotonic()
            said = self.listener.heard.pop()
            self.listener.heard.clear()
            for words, keys in self.ways.items():
                if said.endswith(words) and (said == words or said[-len(words) - 1] == " "):
                    print("aimed:", said)
                    self.page.keys(*keys)
                    done += 1
                    break
        return done

    def speaks_a_memo(self, voice):
        self.page.await_name(self.words("Record a memo"))
        self.page.keys("m")
        self.page.await_name(self.words("Finish the memo"))
        subprocess.run(["paplay", "--device=mouth", voice], check=True)
        self.page.keys("m")
        self.listener.await_words(self.words("%1 Saved.").replace("%1", "").strip())

    def finds_it_and_feels_it(self, number):
        self.page.keys("Escape", "Escape")
        self.listener.await_words("1: " + self.words("Listen to photographs"))
        self.page.keys("1")
        self.listener.listen(1.0)
        self.page.keys("End")
        desk.awaited(lambda: self.is_shown_last(number))
        self.page.keys("e")
        self.listener.await_words(self.words("%1 can be felt.").replace("%1.", "").replace("%1", "").strip(". "))

    def is_shown_last(self, number):
        """Browse shows the photograph that has this number of as many."""
        return any(node.getRole() == self.page.atspi.ROLE_IMAGE and re.findall(r"\d+", node.name)[-2:] == [str(number)] * 2
                   for node in self.page.shown())


def album_is_looked_at(program, album, folder):
    """Until the program knows whose face it is that has a name."""
    environment = preferences(folder, asked=True, voice="off", language="en", album_folders=[album.folder])
    with desk.started([program, "--page", "care"], env=environment):
        page = desk.Page()
        page.press("People…")
        page.await_name(NAME + ", 1 photograph…", page.atspi.ROLE_LIST_ITEM, 3 * desk.PATIENCE)


def journey(program, album, face, folder, language, voice, listener):
    words = Words(language)
    desk.SAID = words("Last sentence") + ": "  # the listener knows it by that
    environment = preferences(folder, asked=True, voice="screen_reader", language=language, capture_told=True,
                              album_folders=[album.folder])
    with desk.started([program, "--camera", "simulated:" + face], env=environment):
        person = Photographer(desk.Page(), listener, words, album)
        before = person.photographs()
        person.page.await_name("6: " + words("Take a photograph") + "…")
        desk.awaited(person.has_the_keyboard)
        person.page.keys("6")
        person.hears("Take a photograph. %1.")
        sentences = person.aims(len(before))
        taken = (set(person.photographs()) - set(before)).pop()
        print(f"{language}: {taken} after {sentences} moves")
        person.listener.await_words(NAME)
        print("heard:", NAME)
        person.speaks_a_memo(voice)
        tags = album.tags(taken)
        assert [tag["kind"] for tag in tags] == ["memo"], tags
        person.finds_it_and_feels_it(len(before) + 1)


def inner(program, lab, face, photos):
    with tempfile.TemporaryDirectory() as folder, desk.Desk(), sound_server.Server(folder):
        album = Album(lab, [*photos, face], folder)
        album.names_the_face(face, NAME)
        voice = tone(os.path.join(folder, "voice.wav"), 440, 2.0)
        listener = desk.Listener()
        album_is_looked_at(program, album, folder)
        for language in LANGUAGES:
            journey(program, album, face, folder, language, voice, listener)


if __name__ == "__main__":
    if len(sys.argv) < 5:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:4], sys.argv[4:]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "paplay"))
