#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes what fuzz_finger_path_text and fuzz_finger_path begin from beside a path of two samples: paths of which something is wrong,
as lines and packed.

    tests/core/study_folder/make_corpus.py    writes tests/core/study_folder/path_text_corpus and path_corpus
"""
import gzip
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEAD = "time_s,x_mm,y_mm,fx_n,fy_n\n"
SAMPLE = "0.0100,0.000,100.000,0.0000,-1.0000\n"


def packed(text: str) -> bytes:
    return gzip.compress(text.encode(), mtime=0)


def main():
    texts = {"nothing": "",
             "no_samples": HEAD,
             "cut_in_its_columns": HEAD[:15],
             "cut_in_a_line": HEAD + SAMPLE + SAMPLE[:20],
             "older_columns": "time_s,x_mm,y_mm\n0.0100,0.000,100.000\n",
             "newer_columns": HEAD[:-1] + ",pressure_n\n" + SAMPLE[:-1] + ",0.5\n",
             "ends_of_another_system": (HEAD + SAMPLE).replace("\n", "\r\n"),
             "back_in_time": HEAD + SAMPLE + SAMPLE.replace("0.0100", "0.0000"),
             "numbers_too_far": HEAD + SAMPLE.replace("100.000", "1e300"),
             "no_numbers": HEAD + SAMPLE.replace("100.000", "nan").replace("-1.0000", "-inf"),
             "a_number_without_end": HEAD + SAMPLE.replace("100.000", "1" * 2000),
             "five_hundred_samples": HEAD + 500 * "0,0,0,0,0\n"}
    for name, text in texts.items():
        (HERE / "path_text_corpus" / name).write_bytes(text.encode())

    whole = packed(HEAD + SAMPLE)
    files = {"nothing": b"",
             "no_samples": packed(HEAD),
             "cut": whole[:-10],
             "without_its_sum": whole[:-8],
             "of_another_sum": whole[:-8] + b"\0\0\0\0" + whole[-4:],
             "one_behind_the_other": whole + whole,
             "something_behind_it": whole + b"x",
             "not_packed": (HEAD + SAMPLE).encode(),
             "packed_twice": gzip.compress(whole, mtime=0),
             "of_another_method": whole[:2] + b"\x07" + whole[3:],
             "a_name_without_end": whole[:3] + b"\x08" + whole[4:10] + b"x" * 200,
             "twenty_kilobytes_of_samples": packed(HEAD + 2_000 * "0,0,0,0,0\n"),
             "older_columns": packed(texts["older_columns"])}
    for name, content in files.items():
        (HERE / "path_corpus" / name).write_bytes(content)


if __name__ == "__main__":
    main()
