#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the corpus of fuzz_metadata_answer: answers as our decoder writes them, and ones that cannot be true. How an answer
is written: core/processes/message.hpp, faces/exiv2/metadata_messages.cpp.

    tests/faces/exiv2/make_answers.py    writes tests/faces/exiv2/answer_corpus
"""
import struct
from pathlib import Path

CORPUS = Path(__file__).resolve().parent / "answer_corpus"
HUGE = (1 << 63) - 1


def number(value: int) -> bytes:
    return struct.pack("<q", value)


def text(value: bytes) -> bytes:
    return number(len(value)) + value


def degrees(value) -> bytes:
    return number(value is not None) + struct.pack("<d", value or 0.0)


def texts(values) -> bytes:
    return number(len(values)) + b"".join(map(text, values))


def fields(width=0, height=0, orientation=0, latitude=None, longitude=None, six=(b"",) * 6, keywords=texts(()),
           places=texts(()), damaged=(0, 0, 0, 0)) -> bytes:
    return (number(width) + number(height) + number(orientation) + degrees(latitude) + degrees(longitude)
            + b"".join(map(text, six)) + keywords + places + b"".join(map(number, damaged)))


def answer(inner: bytes, told=None) -> bytes:
    """In a message; a longer one lies in memory."""
    return number(len(inner) if told is None else told) + text(inner)


SIX = (b"2026:05:01 10:15:00", b"+02:00", b"2026-05-01", b"10:15:00+02:00", b"Gr\xfc\xdfe", b"<x:xmpmeta/>")
ALL = fields(400, 300, 6, -48.5, 16.25, SIX, texts((b"sea", b"snow")), texts((b"Graz", b"Austria")), (0, 0, 1, 0))

ANSWERS = {
    "all": answer(ALL),
    "nothing_stated": answer(fields()),
    "an_orientation_of_nine": answer(fields(400, 300, 9)),
    "of_another_length": answer(ALL, told=len(ALL) + 1),
    "of_less_than_nothing": answer(ALL, told=-1),
    "nothing_carried": answer(b""),
    "cut": answer(ALL)[:-3],
    "cut_within": answer(ALL[:-3]),
    "one_number_more": answer(ALL + number(0)),
    "a_width_below_zero": answer(fields(-400, 300)),
    "a_text_without_end": answer(ALL[:56] + number(HUGE) + ALL[64:]),
    "a_text_of_less_than_nothing": answer(ALL[:56] + number(-1) + ALL[64:]),
    "more_keywords_than_there_are": answer(fields(keywords=number(9_999))),
    "a_list_without_end": answer(fields(keywords=number(HUGE))),
    "a_list_of_less_than_nothing": answer(fields(keywords=number(-1))),
    "four_places": answer(fields(places=texts((b"a", b"b", b"c", b"d")))),
    "bare": ALL,  # as memory has it
}


def main():
    CORPUS.mkdir(exist_ok=True)
    for name, content in ANSWERS.items():
        (CORPUS / name).write_bytes(content)


if __name__ == "__main__":
    main()
