# SPDX-License-Identifier: Apache-2.0
"""What a camera sees and a microphone hears goes nowhere, and is kept only where the person keeps it."""
import os
import re
import shutil
import subprocess
import tempfile
import time
import unittest

import desk
import network_trace
from album import Album, preferences
from privacy_judge import TRIED, files_below, is_whole, judged, wait_until


class Camera(unittest.TestCase):
    """A camera looks, the microphone of the moment hears: what goes anywhere, and what is kept."""

    CALLS = network_trace.CALLS + ",open,openat,openat2,creat"
    # With the folder that a name is relative to, as strace -y tells it.
    WRITES = re.compile(r"(?:open|creat|openat2?)\((?:(?:AT_FDCWD|\d+)(?:<([^>]*)>)?, )?\"([^\"]*)\".*(?:O_WRONLY|O_RDWR|O_CREAT)")
    NO_PLACE_TO_KEEP = ("/dev/", "/proc/", "/sys/")
    # At the beginning of a file or anywhere in one, as in a row of the index.
    PICTURE_OR_SOUND = re.compile(rb"\xff\xd8\xff[\xdb\xe0-\xef]|\x89PNG\r\n|RIFF....(?:WAVE|WEBP|AVI )|fLaC\x00|OggS\x00|ftyp(?:mp4|iso|qt|hei|avi)", re.DOTALL)
    # What the program keeps in folders of its own.
    KEEPS = re.compile(r"(?:config/touchphoto/preferences\.json|cache/touchphoto/album\.(?:lock|sqlite))[^/]*")

    def setUp(self):
        self.folder = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.folder, True)
        self.album = Album(TRIED.lab, [TRIED.photo], self.folder)
        self.own = tuple(os.path.join(self.folder, name) for name in ("config", "cache"))

    def look(self, keys, until):
        """With the camera and the microphone on, until that is to be seen; what was opened to be written."""
        environment = preferences(self.folder, asked=True, voice="screen_reader", language="en", capture_told=True,
                                  shutter_by_itself=False, keep_moment=True, album_folders=[self.album.folder])
        trace = os.path.join(self.folder, "trace")
        command = [TRIED.program, "--camera", "simulated:" + TRIED.photo, "--page", "capture"]
        tracer, *rest = network_trace.traced(command, trace, self.CALLS)
        running = subprocess.Popen([tracer, "-y", *rest], env=environment)
        try:
            page = desk.Page()
            page.await_name("The microphone is on.")
            page.await_name("What to do: …")
            page.keys(*keys)
            page.await_name(until)
            time.sleep(2.0)  # twenty frames
            self.assertIsNone(running.poll(), "the program has ended")
        finally:
            running.terminate()
            running.wait(20)
        wait_until(lambda: is_whole(trace))
        self.assertEqual(judged(trace).offences, [])
        with open(trace, encoding="utf-8", errors="replace") as file:
            return {os.path.join(found[1] or "", found[2]) for line in file if (found := self.WRITES.search(line))}

    def assert_kept_nowhere_but(self, written, *places):
        """What was written lies in these places or in folders of the program's own, and there it is no picture and no sound."""
        self.assertTrue(any(path.startswith(self.own) for path in written), f"strace saw nothing of {written}")
        elsewhere = sorted(path for path in written if not path.startswith(self.own + self.NO_PLACE_TO_KEEP + places))
        self.assertEqual(elsewhere, [])
        inside = [os.path.relpath(path, self.folder) for path in written if "/touchphoto/" in path and path.startswith(self.own)]
        self.assertEqual([path for path in inside if not self.KEEPS.fullmatch(path)], [])
        for path in files_below(self.folder):
            if os.path.isfile(path) and path.startswith(self.own):
                with open(path, "rb") as file:
                    self.assertIsNone(self.PICTURE_OR_SOUND.search(file.read()), path)

    def test_the_judge_knows_a_picture_and_a_sound(self):
        for kept in (b"\xff\xd8\xff\xe0\0\x10JFIF", b"a row\xff\xd8\xff\xe1", b"RIFF\1\2\3\4WAVEfmt ", b"fLaC\0\0\0\x22", b"\0\0\0\x18ftypmp42"):
            self.assertIsNotNone(self.PICTURE_OR_SOUND.search(kept), kept)
        self.assertIsNotNone(self.KEEPS.fullmatch("cache/touchphoto/album.sqlite-wal"))
        for path in ("cache/touchphoto/frame.raw", "config/touchphoto/preferences.json/frame", "cache/touchphoto/moment.pcm"):
            self.assertIsNone(self.KEEPS.fullmatch(path), path)

    def test_without_the_shutter_nothing_is_kept(self):
        before = sorted(files_below(self.album.folder))
        written = self.look((), "Take the photograph")
        self.assert_kept_nowhere_but(written)
        self.assertEqual(sorted(files_below(self.album.folder)), before)

    def test_with_it_one_photograph_is_kept_in_the_album(self):
        before = set(files_below(self.album.folder))
        written = self.look(("space",), "Last photograph: Taken…")
        self.assert_kept_nowhere_but(written, self.album.folder + "/")
        kept = sorted(os.path.splitext(path)[1] for path in set(files_below(self.album.folder)) - before if os.path.isfile(path))
        self.assertEqual([ending for ending in kept if ending not in (".flac", ".part")], [".jpg", ".xmp"])
        self.assertLessEqual(len(kept), 3)  # and the sound of the moment, as far as it was over
