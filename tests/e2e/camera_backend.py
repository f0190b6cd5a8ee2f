#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Through what the program reaches cameras: FFmpeg's back end of Qt, or the one that a person has set. Needs no display and no
camera; read is what the running program has loaded.

camera_backend.py PROGRAM    ends in 77 where this system does not show what a program has loaded
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest

PATIENCE = 120  # s, until the page has asked for a camera
BACKEND = re.compile(r"/lib(\w+)mediaplugin\.so")


def loaded(process):
    with open(f"/proc/{process}/maps", encoding="utf-8", errors="replace") as maps:
        return set(BACKEND.findall(maps.read()))


def backends(**more):
    """What the program has loaded once its camera page has asked for a camera."""
    with tempfile.TemporaryDirectory() as home:
        os.makedirs(os.path.join(home, "config", "touchphoto"))
        with open(os.path.join(home, "config", "touchphoto", "preferences.json"), "w", encoding="utf-8") as file:
            json.dump({"asked": True}, file)
        environment = {name: value for name, value in os.environ.items() if name != "QT_MEDIA_BACKEND"}
        environment |= {"HOME": home, "XDG_CONFIG_HOME": os.path.join(home, "config"), "XDG_CACHE_HOME": os.path.join(home, "cache"),
                        "XDG_RUNTIME_DIR": home, "QT_QPA_PLATFORM": "offscreen", "QT_QUICK_BACKEND": "software"} | more
        running = subprocess.Popen([PROGRAM, "--voice", "off", "--page", "capture"], env=environment, stderr=subprocess.DEVNULL)
        try:
            end = time.monotonic() + PATIENCE
            while not (found := loaded(running.pid)):
                if running.poll() is not None or time.monotonic() > end:
                    raise AssertionError("the program reached for no camera")
                time.sleep(0.05)
            return found
        finally:
            running.terminate()
            running.wait(20)


class CameraBackend(unittest.TestCase):
    def test_it_is_the_one_that_lets_a_camera_off_again(self):
        self.assertEqual(backends(), {"ffmpeg"})

    def test_a_person_may_set_another(self):
        self.assertEqual(backends(QT_MEDIA_BACKEND="gstreamer"), {"gstreamer"})


if __name__ == "__main__":
    if not os.path.exists("/proc/self/maps"):
        print("SKIP: this system has no /proc/self/maps")
        sys.exit(77)
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    PROGRAM = sys.argv.pop()
    unittest.main(verbosity=2)
