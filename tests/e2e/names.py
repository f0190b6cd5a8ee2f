#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A name is heard in its own language, whatever the person's is: what the loudspeaker plays while the program tells who
is on a photograph is the name as the speech server says it in that language, and not as it says it in the other.

names.py PROGRAM LAB PHOTO    ends in 77 where something that it needs is missing
"""
import os
import subprocess
import sys
import tempfile

import numpy as np

import desk
import sound_server
from album import Album, preferences

PERSONS_LANGUAGE = "de"
NAME, CHOSEN = "Geneviève Beauchamp", "fr"  # without a choice, it is read as the text around it
QUIET_S = 2.5  # of silence after speech: that was all
LOUD = 0.01
ALIKE, APART = 0.7, 0.15  # correlations; the same name in the two languages has 0.5
AGREED = 0.9  # of two recordings of the same words; a busy machine may lose something of one
SILENT = 1.5 / 32768  # the least that is no silence
GAP_S = 0.004  # longer silence is left out
TRIES = 5


def sounding(samples):
    """The blocks of 20 ms that are no silence, from the first to the last."""
    loud = np.flatnonzero(sound_server.envelope(samples, sound_server.RATE) > LOUD)
    return (int(loud[0]), int(loud[-1]) + 1) if loud.size else None


def has_spoken(ear, at_least_s):
    samples = ear.so_far()
    spoken = sounding(samples)
    return (spoken is not None and spoken[1] - spoken[0] > 50 * at_least_s
            and len(samples) / sound_server.RATE - spoken[1] / 50 > QUIET_S)


def without_gaps(samples):
    """The sounds without the silence between them: of that, a busy machine puts more between."""
    silent = np.concatenate(([False], np.abs(samples) < SILENT, [False]))
    turns = np.flatnonzero(silent[1:] != silent[:-1])
    stays = np.ones(len(samples), dtype=bool)
    for begin, end in zip(turns[::2], turns[1::2]):
        stays[begin:end] = end - begin < GAP_S * sound_server.RATE
    return samples[stays]


def heard_while(folder, deed, at_least_s=0.5):
    """What the loudspeaker plays, without its gaps, until it has been quiet for a while."""
    ear = sound_server.Ear(folder, "ear")
    deed()
    sound_server.wait_until(lambda: has_spoken(ear, at_least_s))
    samples = ear.heard()
    begin, end = sounding(samples)
    return without_gaps(samples[begin * sound_server.RATE // 50 : end * sound_server.RATE // 50])


def likeness(piece, samples):
    """The best correlation of a sound's spectrogram with any stretch of another one."""
    wanted, there = spectrogram(piece), spectrogram(np.pad(samples, len(piece) // 2))
    stretches = (there[begin : begin + len(wanted)] for begin in range(len(there) - len(wanted) + 1))
    return max(np.corrcoef(wanted.ravel(), one.ravel())[0, 1] for one in stretches if one.std() > 0)


def spectrogram(samples, width=960, bands=24):
    """Loudness in dB of 24 bands up to 6 kHz, each 10 ms."""
    window = np.hanning(width)
    starts = range(0, len(samples) - width, width // 2)
    power = np.array([np.abs(np.fft.rfft(samples[s : s + width] * window))[: 6000 * width // sound_server.RATE] ** 2 for s in starts])
    power = power[:, : power.shape[1] // bands * bands].reshape(len(power), bands, -1).sum(axis=2)
    return 10 * np.log10(power + 1e-3)


def said_by_the_server(folder, language, words):
    """One of two recordings that agree."""
    recordings = []
    for _ in range(TRIES):
        again = heard_while(folder, lambda: subprocess.run(["spd-say", "-w", "-l", language, words], check=True))
        if any(min(likeness(before, again), likeness(again, before)) > AGREED for before in recordings):
            return again
        recordings.append(again)
    raise AssertionError(f"no two recordings of the same {language} words agree")


def told_by_the_program(program, album, folder):
    """What is heard of the photograph's first detail, who is on it."""
    environment = preferences(folder, asked=True, language=PERSONS_LANGUAGE, album_folders=[album.folder],
                              last_photo=album.photos[0])
    running = []
    try:
        heard_while(folder, lambda: running.append(subprocess.Popen([program, "--page", "browse"], env=environment)), at_least_s=4.0)
        return heard_while(folder, lambda: desk.Page().keys("Down"))
    finally:
        running[0].terminate()
        running[0].wait(timeout=20)


def chosen_for_a_name(album, language):
    """As the care page keeps it; app/album/keeper."""
    people = os.path.join(album.folder, ".touchphoto", "people")
    os.makedirs(people, mode=0o700, exist_ok=True)
    with open(os.path.join(people, NAME + ".language"), "w", encoding="utf-8") as file:
        file.write(f"{language}\n{NAME}\n")


def inner(program, lab, photo):
    with tempfile.TemporaryDirectory() as folder, desk.Desk():
        server = sound_server.Server(folder)
        speech = sound_server.Speech()
        try:
            as_said = {language: said_by_the_server(folder, language, NAME) for language in (PERSONS_LANGUAGE, CHOSEN)}
            for language in (PERSONS_LANGUAGE, CHOSEN):
                album = Album(lab, [photo], folder, name=language)
                album.run("person", "name", "--face", "0.5,0.4,0.4,0.5", album.photos[0], NAME)
                if language == CHOSEN:
                    chosen_for_a_name(album, language)
                for _ in range(TRIES):
                    told = told_by_the_program(program, album, folder)
                    like = {one: likeness(said, told) for one, said in as_said.items()}
                    print(f"{len(told) / sound_server.RATE:.1f} s told, the name to be in {language}: like " +
                          ", ".join(f"{one} {value:.3f}" for one, value in like.items()))
                    if max(like.values()) > ALIKE:  # like neither: something was lost
                        break
                other = PERSONS_LANGUAGE if language == CHOSEN else CHOSEN
                assert like[language] > ALIKE, like
                assert like[other] < like[language] - APART, like
        finally:
            speech.end()
            server.end()


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    sys.exit(desk.verdict(inner, *sys.argv[1:4]) if desk.is_at_a_desk()
             else desk.at_a_desk(__file__, "xdotool", "pulseaudio", "pactl", "parec", "speech-dispatcher", "spd-say"))
