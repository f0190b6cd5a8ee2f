# SPDX-License-Identifier: Apache-2.0
"""A sound server for tests: nothing of the machine's own is heard or recorded."""
import os
import socket
import subprocess
import time
import wave

import numpy as np

RATE = 48000
WAV_HEADER = 44  # bytes before the samples, as libsndfile writes 16-bit PCM
LONGEST = 60  # s that anything here may take before it counts as hanging


def wait_until(true):
    for _ in range(LONGEST * 10):
        if true():
            return
        time.sleep(0.1)
    raise AssertionError("it did not happen")


class Server:
    """A PulseAudio of our own: the loudspeaker `ear`, and the microphone `mic` that hears what is played to `mouth`."""

    def __init__(self, folder):
        self.socket = os.path.join(folder, "socket")
        os.environ.update(HOME=folder, XDG_RUNTIME_DIR=folder, XDG_CONFIG_HOME=folder, PULSE_RUNTIME_PATH=folder,
                          PULSE_STATE_PATH=folder, PULSE_SERVER="unix:" + self.socket)
        os.environ.pop("PULSE_COOKIE", None)
        command = ["pulseaudio", "-n", "--daemonize=no", "--use-pid-file=no", "--exit-idle-time=-1", "--disable-shm=yes",
                   "-L", f"module-native-protocol-unix socket={self.socket} auth-anonymous=1"]
        self.process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        try:
            wait_until(lambda: subprocess.run(["pactl", "info"], capture_output=True).returncode == 0)
        except AssertionError:
            self.end()
            raise
        self.mouth = self.load("module-null-sink", "sink_name=mouth", "norewinds=1", f"rate={RATE}")
        self.ear = self.loudspeaker("ear")
        self.mic = self.microphone()

    def load(self, *words):
        return subprocess.run(["pactl", "load-module", *words], check=True, capture_output=True, text=True).stdout.strip()

    def unload(self, module):
        subprocess.run(["pactl", "unload-module", module], check=True)

    def loudspeaker(self, name):
        module = self.load("module-null-sink", "sink_name=" + name, "norewinds=1", f"rate={RATE}")
        subprocess.run(["pactl", "set-default-sink", name], check=True)
        return module

    def microphone(self):
        module = self.load("module-remap-source", "master=mouth.monitor", "source_name=mic")
        subprocess.run(["pactl", "set-default-source", "mic"], check=True)
        return module

    def end(self):
        self.process.terminate()
        self.process.wait()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()


def read_wav(path):
    with wave.open(path) as file:
        samples = np.frombuffer(file.readframes(file.getnframes()), "<i2").reshape(-1, file.getnchannels())
        return samples[:, 0] / 32768.0, file.getframerate()


def envelope(samples, rate):
    """Root mean square of each 20 ms."""
    width = rate // 50
    blocks = samples[: len(samples) // width * width].reshape(-1, width)
    return np.sqrt((blocks**2).mean(axis=1))


class Ear:
    """Everything that a loudspeaker plays."""

    def __init__(self, folder, loudspeaker):
        self.path = os.path.join(folder, loudspeaker + ".wav")
        if os.path.exists(self.path):  # of an ear before this one
            os.remove(self.path)
        self.process = subprocess.Popen(["parec", "-d", loudspeaker + ".monitor", "--file-format=wav", "--format=s16le",
                                         f"--rate={RATE}", "--channels=1", self.path])
        wait_until(lambda: os.path.exists(self.path) and os.path.getsize(self.path) > 10000)

    def so_far(self):
        """What was heard until now; it goes on listening."""
        with open(self.path, "rb") as file:
            content = file.read()[WAV_HEADER:]
        return np.frombuffer(content[: len(content) // 2 * 2], "<i2") / 32768.0

    def heard(self):
        time.sleep(0.5)  # what is on its way
        self.process.terminate()
        self.process.wait()
        return read_wav(self.path)[0]


def listens(path):
    """Whether somebody answers at a socket; one that is left over stays in its folder."""
    with socket.socket(socket.AF_UNIX) as door:
        return door.connect_ex(path) == 0


class Speech:
    """A speech-dispatcher of our own, as a session has one: it speaks through the sound server of XDG_RUNTIME_DIR."""

    def __init__(self):
        path = os.path.join(os.environ["XDG_RUNTIME_DIR"], "speech-dispatcher", "speechd.sock")
        os.makedirs(os.path.dirname(path), mode=0o700, exist_ok=True)
        self.process = subprocess.Popen(["speech-dispatcher", "--run-single", "--timeout", "0", "--socket-path", path],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        wait_until(lambda: listens(path))

    def end(self):
        self.process.terminate()
        self.process.wait()
