# SPDX-License-Identifier: Apache-2.0
"""A hand and an eye on an X display: keys and pointer as the server gives them to a program, and when pixels have changed."""
import ctypes
import time

import numpy as np

Z_PIXMAP = 2
EVERY_PLANE = 0xFFFFFFFF


class Image(ctypes.Structure):
    _fields_ = [("width", ctypes.c_int), ("height", ctypes.c_int), ("offset", ctypes.c_int), ("format", ctypes.c_int),
                ("data", ctypes.c_void_p), ("byte_order", ctypes.c_int), ("unit", ctypes.c_int), ("bit_order", ctypes.c_int),
                ("pad", ctypes.c_int), ("depth", ctypes.c_int), ("bytes_per_line", ctypes.c_int)]


class Screen:
    def __init__(self):
        self.x = ctypes.CDLL("libX11.so.6")
        self.test = ctypes.CDLL("libXtst.so.6")
        self.x.XOpenDisplay.restype = self.x.XDefaultRootWindow.restype = self.x.XStringToKeysym.restype = ctypes.c_void_p
        self.x.XGetImage.restype = ctypes.POINTER(Image)
        self.display = ctypes.c_void_p(self.x.XOpenDisplay(None))
        self.root = ctypes.c_void_p(self.x.XDefaultRootWindow(self.display))

    def press(self, keys):
        """Such as "Alt_L+Home". Returns when, in the clock of time.monotonic."""
        codes = [self.x.XKeysymToKeycode(self.display, ctypes.c_void_p(self.x.XStringToKeysym(key.encode())))
                 for key in keys.split("+")]
        when = time.monotonic()
        for code in codes:
            self.test.XTestFakeKeyEvent(self.display, code, 1, ctypes.c_ulong(0))
        for code in reversed(codes):
            self.test.XTestFakeKeyEvent(self.display, code, 0, ctypes.c_ulong(0))
        self.x.XFlush(self.display)
        return when

    def point(self, x, y):
        when = time.monotonic()
        self.test.XTestFakeMotionEvent(self.display, -1, int(x), int(y), ctypes.c_ulong(0))
        self.x.XFlush(self.display)
        return when

    def pixels(self, x, y, width, height):
        image = self.x.XGetImage(self.display, self.root, int(x), int(y), width, height, ctypes.c_ulong(EVERY_PLANE), Z_PIXMAP)
        picture = image.contents
        count = picture.bytes_per_line * picture.height
        seen = np.frombuffer(ctypes.string_at(picture.data, count), np.uint8).reshape(height, -1, 4)[:, :width, :3]
        self.x.XFree(ctypes.c_void_p(picture.data))
        self.x.XFree(image)
        return seen

    def await_change(self, before, place, patience=20.0):
        """When the pixels at `place` were another than `before`; None where they stayed."""
        end = time.monotonic() + patience
        while time.monotonic() < end:
            if not np.array_equal(self.pixels(*place), before):
                return time.monotonic()
            time.sleep(0.001)
        return None

    def await_rest(self, place, seconds=0.4):
        """Until nothing has changed there for so long; the pixels then."""
        before, since = self.pixels(*place), time.monotonic()
        while time.monotonic() - since < seconds:
            time.sleep(0.02)
            now = self.pixels(*place)
            if not np.array_equal(now, before):
                before, since = now, time.monotonic()
        return before
