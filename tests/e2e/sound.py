#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The real recorder and player on a real sound server of their own: speech that is played into the microphone is what
the file holds, a tone keeps its pitch at any speed, and devices come and go. Nothing is asked of the clock: what is
measured is the sound that arrived.

sound.py PROBE    ends in 77 where a program that it needs is missing"""

import os
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
import wave

import numpy as np

from sound_server import LONGEST, RATE, Ear, Server, envelope, read_wav


def write_wav(path, samples):
    with wave.open(path, "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(RATE)
        file.writeframes((samples * 32767).astype("<i2").tobytes())


def likeness(source, source_rate, heard):
    """Best correlation of the envelopes of a sound and of any piece of a longer one."""
    wanted = envelope(source, source_rate)
    best = 0.0
    for begin in range(0, RATE // 50, RATE // 200):
        all_of_it = envelope(heard[begin:], RATE)
        for shift in range(len(all_of_it) - len(wanted) + 1):
            piece = all_of_it[shift : shift + len(wanted)]
            if piece.std() > 0:
                best = max(best, np.corrcoef(wanted, piece)[0, 1])
    return best


def frequency(samples):
    """The strongest, to a tenth of a Hz."""
    window = samples * np.hanning(len(samples))
    return np.abs(np.fft.rfft(window, 10 * RATE)).argmax() / 10


def sounding_seconds(samples):
    """So much is not silence. Gaps count for nothing, so a machine that is busy does not fail the test."""
    return np.count_nonzero(envelope(samples, RATE) > 0.01) / 50


class Probe:
    """The program under test, and the lines it printed."""

    def __init__(self, *words):
        self.process = subprocess.Popen([PROBE, *words], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        self.lines = []

    def until(self, begin):
        """The rest of the next line that begins so."""
        for line in self.process.stdout:
            self.lines.append(line.strip())
            if line.startswith(begin):
                return line[len(begin):].strip()
        raise AssertionError(f"it ended without {begin!r}: {self.lines}")

    def finish(self):
        self.process.stdin.write("\n")
        self.process.stdin.flush()

    def end(self, kill=False):
        if kill:
            self.process.kill()
        status = self.process.wait(LONGEST)
        self.process.stdin.close()
        self.process.stdout.close()
        assert kill or status == 0, f"it ended in {status}"


class Sound(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.server = Server(self.folder)
        self.addCleanup(self.server.end)

    def path(self, name):
        return os.path.join(self.folder, name)

    def tone(self, seconds):
        write_wav(self.path("tone.wav"), 0.3 * np.sin(2 * np.pi * 440 * np.arange(int(seconds * RATE)) / RATE))
        return self.path("tone.wav")

    def speech(self):
        subprocess.run(["espeak-ng", "-w", self.path("speech.wav"),
                        "This is Anna, by the lake, in the summer of the year we met."], check=True)
        return self.path("speech.wav")

    def stored(self, done):
        seconds, _, file = done.split(" ", 2)
        subprocess.run(["flac", "-t", "-s", file], check=True)
        subprocess.run(["flac", "-d", "-s", "-o", self.path("stored.wav"), file], check=True)
        samples, rate = read_wav(self.path("stored.wav"))
        self.assertEqual(rate, RATE)
        self.assertAlmostEqual(len(samples) / RATE, float(seconds), 3)
        return samples

    def test_speech_is_recorded_as_it_was_spoken(self):
        speech = self.speech()
        probe = Probe("record", self.path("tags"))
        probe.until("state 2")
        subprocess.run(["paplay", "-d", "mouth", speech], check=True)
        time.sleep(0.5)
        probe.finish()
        samples = self.stored(probe.until("done"))
        probe.end()
        like = likeness(*read_wav(speech), samples)
        print(f"likeness of the envelopes: {like:.3f}")
        self.assertGreaterEqual(like, 0.9)
        self.assertEqual([name for name in os.listdir(self.path("tags")) if not name.endswith(".flac")], [])

    def test_a_microphone_goes_and_comes_back(self):
        probe = Probe("record", self.path("tags"))
        probe.until("state 2")
        subprocess.run(["paplay", "-d", "mouth", self.tone(1.0)], check=True)
        self.server.unload(self.server.mic)
        self.assertIn("microphone is gone", probe.until("said"))
        self.server.microphone()
        self.assertIn("goes on", probe.until("said"))
        subprocess.run(["paplay", "-d", "mouth", self.tone(1.0)], check=True)
        time.sleep(0.5)
        probe.finish()
        samples = self.stored(probe.until("done"))
        probe.end()
        print(f"of two tones of 1 s, {sounding_seconds(samples):.2f} s are in the file")
        self.assertGreater(sounding_seconds(samples), 1.9)

    def test_a_tone_keeps_its_pitch_at_any_speed(self):
        for speed in (1.0, 1.5):
            with self.subTest(speed=speed):
                ear = Ear(self.folder, "ear")
                Probe("play", str(speed), self.tone(3.0)).end()
                samples = ear.heard()
                seconds = sounding_seconds(samples)
                hz = frequency(samples)
                print(f"speed {speed}: {seconds:.2f} s of {hz:.1f} Hz")
                self.assertAlmostEqual(seconds, 3.0 / speed, delta=0.06)
                self.assertAlmostEqual(hz, 440, delta=4.4)

    def test_speech_is_played_as_it_was_spoken(self):
        speech = self.speech()
        ear = Ear(self.folder, "ear")
        Probe("play", "1", speech).end()
        like = likeness(*read_wav(speech), ear.heard())
        print(f"likeness of the envelopes: {like:.3f}")
        self.assertGreaterEqual(like, 0.9)

    def test_a_loudspeaker_goes_and_another_comes(self):
        self.server.unload(self.server.ear)
        self.server.unload(self.server.mouth)
        first = self.server.loudspeaker("first")
        ear = Ear(self.folder, "first")
        probe = Probe("play", "1", self.tone(6.0))
        probe.until("began")
        time.sleep(1.0)
        self.server.unload(first)
        self.assertIn("loudspeaker is gone", probe.until("said"))
        before = sounding_seconds(ear.heard())
        self.server.loudspeaker("second")
        ear = Ear(self.folder, "second")
        probe.end()
        after = sounding_seconds(ear.heard())
        print(f"of a tone of 6 s, {before:.2f} s were heard before and {after:.2f} s after")
        self.assertGreater(before, 0.3)
        self.assertGreater(before + after, 5.5)

    def test_a_sound_plays_that_is_begun_in_the_moment_in_which_another_ends(self):
        probe = Probe("hurry", "10")
        self.assertEqual(probe.until("rounds"), "10")
        probe.end()

    def test_without_any_server_it_says_so(self):
        self.server.end()
        probe = Probe("play", "1", self.tone(1.0))
        self.assertIn("no loudspeaker", probe.until("said"))
        probe.end(kill=True)
        probe = Probe("record", self.path("tags"))
        self.assertIn("no microphone", probe.until("said"))
        probe.finish()
        self.assertIn("Nothing was recorded", probe.until("failed"))
        probe.end(kill=True)


if __name__ == "__main__":
    missing = [name for name in ("pulseaudio", "pactl", "parec", "paplay", "espeak-ng", "flac") if not shutil.which(name)]
    if missing:
        print("SKIP: sound needs " + ", ".join(missing))
        sys.exit(77)
    PROBE = sys.argv.pop(1)
    unittest.main(verbosity=2)
