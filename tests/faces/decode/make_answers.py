#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the corpora of fuzz_picture_answer and fuzz_film_answer: answers as our decoder writes them, and ones that cannot be
true. The memory that comes with each is 10 by 10 pixels large. How an answer is written: core/processes/message.hpp.

    tests/faces/decode/make_answers.py    writes tests/faces/decode/answer_corpus and tests/audio/video/answer_corpus
"""
import struct
from pathlib import Path

HERE = Path(__file__).resolve().parent
PICTURES, FILMS = HERE / "answer_corpus", HERE.parents[1] / "audio/video/answer_corpus"
SIDE = 10  # px
HUGE = (1 << 63) - 1
UNSHOWN = "\u202e\x1b[2J".encode() + b"\xff"


def answer(*numbers: int, sentence: bytes = b"", length=None) -> bytes:
    length = len(sentence) if length is None else length
    return struct.pack("<q", length) + sentence + struct.pack(f"<{len(numbers)}q", *numbers)


def pictures():
    """Columns, rows, width and height of the whole, by how much it is shrunk, whether the whole is kept."""
    whole = (SIDE, SIDE, SIDE, SIDE, 1, 1)
    return {"whole": answer(*whole),
            "shrunk": answer(SIDE, SIDE, 8 * SIDE, 8 * SIDE, 8, 1),
            "sentence": answer(sentence=b"The JPEG file is damaged."),
            "sentence_that_cannot_be_shown": answer(sentence=UNSHOWN),
            "sentence_without_end": answer(sentence=b"x" * 5000),
            "sentence_longer_than_told": answer(sentence=b"x" * 100, length=3),
            "sentence_of_another_length": answer(sentence=b"x", length=HUGE),
            "sentence_of_less_than_nothing": answer(sentence=b"x", length=-1),
            "nothing": b"",
            "cut": answer(*whole)[:-3],
            "one_number_more": answer(*whole, 1),
            "more_pixels_than_memory": answer(SIDE + 1, SIDE, SIDE + 1, SIDE, 1, 1),
            "sides_whose_product_is_small": answer(1 << 31, 1 << 33, 1 << 31, 1 << 33, 1, 1),
            "no_pixels": answer(0, SIDE, 0, SIDE, 1, 1),
            "fewer_than_none": answer(-SIDE, -SIDE, -SIDE, -SIDE, 1, 1),
            "shrunk_by_nothing": answer(SIDE, SIDE, SIDE, SIDE, 0, 1),
            "shrunk_by_nine": answer(SIDE, SIDE, 9 * SIDE, 9 * SIDE, 9, 1),
            "a_whole_of_400_megapixels": answer(SIDE, SIDE, 20_000, 20_000, 2000, 1),
            "another_shape_than_the_whole": answer(SIDE, SIDE, 8 * SIDE, SIDE, 1, 1)}


def films():
    """The time in microseconds, width, height, by how many degrees it is turned."""
    picture = (1_500_000, SIDE, SIDE, 90)
    return {"picture": answer(*picture),
            "end": answer(),
            "sentence": answer(sentence=b"it is damaged."),
            "sentence_without_end": answer(sentence=b"x" * 5000),
            "sentence_that_cannot_be_shown": answer(sentence=UNSHOWN),
            "sentence_of_another_length": answer(sentence=b"x", length=HUGE),
            "nothing": b"",
            "cut": answer(*picture)[:-3],
            "one_number_more": answer(*picture, 1),
            "more_pixels_than_memory": answer(0, SIDE + 2, SIDE, 0),
            "sides_whose_product_is_small": answer(0, 1 << 32, 1 << 32, 0),
            "odd_sides": answer(0, SIDE - 1, SIDE - 1, 0),
            "no_pixels": answer(0, 0, 0, 0),
            "fewer_than_none": answer(0, -SIDE, -SIDE, 0),
            "turned_by_45_degrees": answer(0, SIDE, SIDE, 45),
            "turned_by_360_degrees": answer(0, SIDE, SIDE, 360),
            "after_the_end_of_time": answer(HUGE, SIDE, SIDE, 0),
            "before_its_beginning": answer(-HUGE, SIDE, SIDE, 0)}


def main():
    for folder, made in ((PICTURES, pictures()), (FILMS, films())):
        folder.mkdir(exist_ok=True)
        for name, content in made.items():
            (folder / name).write_bytes(content)


if __name__ == "__main__":
    main()
