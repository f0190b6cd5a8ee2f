# SPDX-License-Identifier: Apache-2.0
"""A small album for the journeys, made by the program's own verbs."""
import json
import math
import os
import shutil
import struct
import subprocess
import wave


def tone(path, hz, seconds, rate=48000):
    """A sine of a pitch that can be told again in what the loudspeaker played."""
    with wave.open(path, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(rate)
        samples = (int(12000 * math.sin(2 * math.pi * hz * i / rate)) for i in range(int(seconds * rate)))
        file.writeframes(b"".join(struct.pack("<h", sample) for sample in samples))
    return path


class Album:
    """A folder with copies of `photos`; `lab` is touchphoto-lab."""

    def __init__(self, lab, photos, folder, name="Family"):
        self.lab = lab
        self.folder = os.path.join(folder, name)
        os.makedirs(self.folder)
        for day, photo in enumerate(photos):  # a day apart, so that they have an order
            taken = 1_750_000_000 + 86_400 * day
            os.utime(shutil.copy(photo, self.folder), (taken, taken))
        self.photos = [os.path.join(self.folder, os.path.basename(photo)) for photo in photos]

    def run(self, *words):
        done = subprocess.run([self.lab, "album", *words], capture_output=True, text=True)
        assert done.returncode == 0, f"album {' '.join(words)}: {done.stderr}"
        return done.stdout

    def photo(self, name):
        return os.path.join(self.folder, name)

    def names_the_face(self, photo, name):
        """The largest one, by where the program finds it."""
        found = json.loads(subprocess.run([self.lab, "faces", photo, "--json"], capture_output=True, check=True).stdout)
        left, top, wide, high = found["faces"][0]["box"]
        place = ((left + wide / 2) / found["width"], (top + high / 2) / found["height"],
                 wide / found["width"], high / found["height"])
        self.run("person", "name", "--face", ",".join(f"{share:.4f}" for share in place),
                 self.photo(os.path.basename(photo)), name)

    def show(self, photo):
        return json.loads(self.run("show", "--json", self.photo(photo)))

    def tags(self, photo):
        return self.show(photo)["tags"]


def preferences(folder, **choices):
    """Writes what a person chose into the place where the program keeps it; the environment that leads there."""
    config = os.path.join(folder, "config")
    os.makedirs(os.path.join(config, "touchphoto"), exist_ok=True)
    with open(os.path.join(config, "touchphoto", "preferences.json"), "w", encoding="utf-8") as file:
        json.dump(choices, file)
    return dict(os.environ, XDG_CONFIG_HOME=config, XDG_CACHE_HOME=os.path.join(folder, "cache"), HOME=folder)
