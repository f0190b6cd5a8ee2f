#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A caregiver's evening, counted: photographs of a family are imported, everybody is named, recordings are made and
descriptions taken, by keys and presses only. Each key and each press is one action.

evening.py PROGRAM LAB PORTRAITS [PHOTOS PEOPLE RECORDINGS DESCRIPTIONS]
                                  ends in 77 where something that it needs is missing
PORTRAITS: files `NNN_03.jpg` (neutral) and `NNN_08.jpg` (smiling), a person each NNN, of which photographs of one to three
people are made: cut, turned, darkened, compressed. Without numbers 200 photographs of 12 people, 10 recordings and 5
descriptions.
"""
import os
import random
import subprocess
import sys
import tempfile
import time

import desk
import sound_server
from album import Album, preferences, tone

NAMES = ("Anna", "Ben", "Clara", "David", "Emma", "Felix", "Greta", "Hugo", "Ida", "Jonas", "Karl", "Lena")
MOST_A_FACE = 1.0  # actions to name one, in the mean
MOST_TO_NAME = 90  # actions to name everybody


def portrait_of(person, portraits, chance):
    import cv2
    import numpy as np

    picture = cv2.imread(os.path.join(portraits, person + chance.choice(["_03.jpg", "_08.jpg"])))
    height, width = picture.shape[:2]
    share = chance.uniform(0.75, 1.0)
    high, wide = int(height * share), int(width * share)
    x, y = int((width - wide) * chance.uniform(0.35, 0.65)), int((height - high) * chance.uniform(0.3, 0.6))
    picture = picture[y:y + high, x:x + wide]
    turn = cv2.getRotationMatrix2D((wide / 2, high / 2), chance.uniform(-8, 8), 1.0)
    picture = cv2.warpAffine(picture, turn, (wide, high), borderMode=cv2.BORDER_REPLICATE)
    picture = np.clip(picture.astype(np.float32) * chance.uniform(0.75, 1.2), 0, 255).astype(np.uint8)
    return cv2.resize(picture, (600, 600 * high // wide), interpolation=cv2.INTER_AREA)


def make_photos(folder, portraits, count, people):
    """Some are on more photographs than others. Who is on each."""
    import cv2
    import numpy as np

    chance = random.Random(5)
    known = sorted({name.split("_")[0] for name in os.listdir(portraits) if name.endswith("_03.jpg")})
    family = chance.sample(known, people)
    often = [1.0 / (1.0 + 0.3 * i) for i in range(people)]
    on_it = {}
    os.makedirs(folder)
    for number in range(count):
        shown = set()
        wanted = chance.choices([1, 2, 3], [5, 3, 2])[0]
        while len(shown) < wanted:
            shown.add(chance.choices(family, often)[0])
        pictures = [portrait_of(person, portraits, chance) for person in sorted(shown)]
        photo = np.full((max(each.shape[0] for each in pictures), 600 * len(pictures), 3), 125, np.uint8)
        for place, each in enumerate(pictures):
            photo[:each.shape[0], 600 * place:600 * place + 600] = each
        file = os.path.join(folder, f"IMG_{number:04}.jpg")
        cv2.imwrite(file, photo, [cv2.IMWRITE_JPEG_QUALITY, chance.choice([75, 85, 92])])
        os.utime(file, (1.6e9 + 86400 * number, 1.6e9 + 86400 * number))
        on_it[os.path.basename(file)] = {NAMES[family.index(person)] for person in shown}
    return on_it


class Counted(desk.Page):
    """Counts what hands do."""

    def __init__(self):
        super().__init__()
        self.actions = 0

    def press(self, name, role=None):
        super().press(name, role)
        self.actions += 1

    def keys(self, *names):
        super().keys(*names)
        self.actions += len(names)

    def type(self, text):
        super().type(text)
        self.actions += len(text)


class Evening:
    def __init__(self, folder, album, on_it, page, listener):
        self.folder, self.album, self.on_it, self.page, self.listener = folder, album, on_it, page, listener
        self.faces = sum(len(people) for people in on_it.values())
        self.rows = []
        self.named = set()

    def part(self, what, do, *words):
        """Does a part of the evening and counts it; what the program does meanwhile by itself is not waited for by hands."""
        before, begin = self.page.actions, time.monotonic()
        do(*words)
        self.rows.append((what, self.page.actions - before, time.monotonic() - begin))
        print(f"{what}: {self.rows[-1][1]} actions, {self.rows[-1][2]:.0f} s", flush=True)
        return self.rows[-1][1]

    def imports(self, count):
        self.page.await_name(desk.SAID + "TouchPhoto, start page. 1: Look after the album.…")
        self.page.keys("1")
        self.page.press("Import a folder…")
        self.page.press("Card…", self.page.atspi.ROLE_LIST_ITEM)
        self.listener.await_words(f"{count} photographs in this folder itself")
        self.page.press("Choose this folder")
        self.listener.await_words(f"{count} photographs imported.")

    def waits_for_people(self):
        self.page.press("People…")
        end = time.monotonic() + 30 * desk.PATIENCE
        quiet = 0  # how often in a row nothing was left to be looked at
        while quiet < 5:
            assert time.monotonic() < end, self.summary()
            time.sleep(1)
            quiet = quiet + 1 if "without a name" in self.summary() and "looked at" not in self.summary() else 0
        print(self.summary())
        self.page.press("Back to the photographs")  # so that the largest group comes first

    def summary(self):
        for node in self.page.everything():
            if "without a name" in node.name or "looked at" in node.name or "Everybody here" in node.name:
                return node.name
        return ""

    def names_everybody(self):
        self.page.press("People…")
        self.page.press("Who is this?…", self.page.atspi.ROLE_LIST_ITEM)
        groups, told = 0, ""
        while "Nobody is left without a name." not in told:
            self.page.await_name("Name", self.page.atspi.ROLE_TEXT)
            name = self.who_it_is()
            if self.page.find(f"Yes, this is {name}"):
                self.page.keys("y")
            else:
                self.page.type(name)
                self.page.keys("Return")
            self.listener.await_words(f"Saved: {name}, on ")
            told = self.page.find(desk.SAID + "…").name
            groups += 1
        print(f"{groups} groups. {self.summary()}")
        self.page.press("Back to the photographs")

    def who_it_is(self):
        """What a person sees on the pictures: who is on all photographs of the group."""
        everybody = set(NAMES)
        for node in self.page.shown():
            if node.getRole() == self.page.atspi.ROLE_LIST_ITEM and node.name.startswith("IMG_"):
                everybody &= self.on_it[node.name.split(",")[0]]
        assert everybody, "who is this?"
        offered = {name for name in everybody if self.page.find(f"Yes, this is {name}")}
        name = min(offered or (everybody - self.named) or everybody)  # of two who are always together either
        self.named.add(name)
        return name

    def opens_the_next_photo(self, number):
        self.page.press(f"IMG_{number:04}.jpg…", self.page.atspi.ROLE_LIST_ITEM)
        self.page.await_name(f"IMG_{number:04}.jpg", self.page.atspi.ROLE_HEADING)

    def records(self, numbers):
        sound = tone(os.path.join(self.folder, "memo.wav"), 500, 1.0)
        for number in numbers:
            self.opens_the_next_photo(number)
            self.page.press("Record")
            self.page.await_name("Recording …")  # as soon as the microphone is heard
            subprocess.run(["paplay", "-d", "mouth", sound], check=True)
            self.page.press("Finish the recording")
            self.listener.await_words("Saved.")
            self.page.press("Back to the photographs")

    def describes(self, numbers):
        for number in numbers:
            self.opens_the_next_photo(number)
            self.page.press("Use the suggestion")
            self.page.press("Save the description")
            self.listener.await_words("The description is saved")
            self.page.press("Back to the photographs")

    def judge(self, named, count):
        stored = [self.album.show(f"IMG_{number:04}.jpg") for number in range(count)]
        faces = sum(len(photo["faces"]) for photo in stored)
        right = sum(bool(face["name"]) for photo in stored for face in photo["faces"])
        recordings, described = sum(bool(photo["tags"]) for photo in stored), sum(bool(photo["alt_text"]) for photo in stored)
        print(f"on the disk: {right} names for {self.faces} faces, {recordings} photographs with a recording, "
              f"{described} described; {named / self.faces:.2f} actions a face")
        for number, photo in enumerate(stored):
            nameless = len(self.on_it[f"IMG_{number:04}.jpg"]) - len(photo["faces"])
            if nameless:
                print(f"IMG_{number:04}.jpg: {nameless} without a name, {len(photo['seen']['faces'])} faces seen, {photo['persons']}")
        wrong = sum(face["name"] not in self.on_it[f"IMG_{number:04}.jpg"] for number, photo in enumerate(stored)
                    for face in photo["faces"])
        assert wrong == 0, f"{wrong} wrong names"
        assert faces == right and right >= 0.98 * self.faces, (faces, right, self.faces)
        assert named <= MOST_TO_NAME and named <= MOST_A_FACE * self.faces, f"{named} actions for {self.faces} faces"
        return recordings, described


def inner(program, lab, portraits, count=200, people=12, recordings=10, descriptions=5):
    with tempfile.TemporaryDirectory() as folder, desk.Desk(), sound_server.Server(folder):
        album = Album(lab, [], folder)
        on_it = make_photos(os.path.join(folder, "Card"), portraits, count, people)
        print(f"{count} photographs, {sum(map(len, on_it.values()))} faces of {people} people")
        environment = preferences(folder, asked=True, user="caregiver", voice="screen_reader", language="en",
                                  album_folders=[album.folder])
        listener = desk.Listener()
        with desk.started([program], env=environment):
            evening = Evening(folder, album, on_it, Counted(), listener)
            evening.part("import", evening.imports, count)
            evening.part("the program looks", evening.waits_for_people)
            named = evening.part("naming everybody", evening.names_everybody)
            newest = range(count - 1, -1, -1)
            evening.part("recordings", evening.records, newest[:recordings])
            evening.part("descriptions", evening.describes, newest[recordings:recordings + descriptions])
            assert evening.judge(named, count) == (recordings, descriptions)


if __name__ == "__main__":
    if len(sys.argv) not in (4, 8):
        sys.exit(__doc__)
    if not os.path.isdir(sys.argv[3]):
        print(f"SKIP: needs ../shared: {sys.argv[3]}")
        sys.exit(77)
    sys.exit(desk.verdict(inner, *sys.argv[1:4], *map(int, sys.argv[4:])) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "paplay", seconds=1500))
