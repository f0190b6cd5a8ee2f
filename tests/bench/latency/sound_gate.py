# SPDX-License-Identifier: Apache-2.0
"""A gate before a sound server: passes everything on, and notes when a program hands over its first sound after silence."""
import os
import socket
import struct
import threading
import time

CONTROL = 0xFFFFFFFF  # the channel of PulseAudio's commands; every other one carries samples
HEAD = struct.Struct(">IIIII")  # bytes that follow, channel, two words of offset, flags


class Line:
    """One client's connection. A thread of its own each way."""

    def __init__(self, gate, client):
        self.gate, self.client = gate, client
        self.server = socket.socket(socket.AF_UNIX)
        self.server.connect(gate.server)
        self.speech = False  # whether it is the speech server's
        threading.Thread(target=self.pass_on_samples, daemon=True).start()
        threading.Thread(target=self.pass_back, daemon=True).start()

    def pass_back(self):
        try:
            while data := self.server.recv(1 << 16):
                self.client.sendall(data)
            self.client.shutdown(socket.SHUT_RDWR)
        except OSError:
            pass

    def take(self, count):
        parts = bytearray()
        while len(parts) < count:
            part = self.client.recv(count - len(parts))
            if not part:
                raise OSError("the client has gone")
            parts += part
        return bytes(parts)

    def pass_on_samples(self):
        try:
            while True:
                head = self.take(HEAD.size)
                length, channel = HEAD.unpack(head)[:2]
                body = self.take(length)
                if channel == CONTROL:
                    self.speech = self.speech or b"speech-dispatcher" in body
                elif body.count(0) != length:
                    self.gate.note(self.speech)
                self.server.sendall(head + body)
        except OSError:
            self.server.close()


class Gate:
    def __init__(self, folder, server):
        self.server = server
        self.path = os.path.join(folder, "gate")
        self.changed = threading.Condition()
        self.last = {False: 0.0, True: 0.0}  # when sound was handed over last, of the program and of the speech server
        self.first = {False: None, True: None}  # and first since `listen`
        self.door = socket.socket(socket.AF_UNIX)
        self.door.bind(self.path)
        self.door.listen(20)
        threading.Thread(target=self.let_in, daemon=True).start()

    def let_in(self):
        while True:
            Line(self, self.door.accept()[0])

    def note(self, speech):
        with self.changed:
            self.last[speech] = time.monotonic()
            if self.first[speech] is None:
                self.first[speech] = self.last[speech]
                self.changed.notify_all()

    def listen(self):
        with self.changed:
            self.first = {False: None, True: None}

    def heard(self, speech=False, patience=20.0):
        """When sound was handed over first since `listen`; None where there was none in `patience` seconds."""
        with self.changed:
            self.changed.wait_for(lambda: self.first[speech] is not None, patience)
            return self.first[speech]

    def await_silence(self, seconds=0.5):
        while (left := max(self.last.values()) + seconds - time.monotonic()) > 0:
            time.sleep(left)
