# SPDX-License-Identifier: Apache-2.0
"""Files of a stranger's that verbs read: what they say of themselves would like to be fetched from somewhere."""
import csv
import glob
import os
import subprocess


def number(value):
    """As protobuf writes it: seven bits at a time, the lowest first."""
    some = b""
    while value > 0x7F:
        some += bytes([value & 0x7F | 0x80])
        value >>= 7
    return some + bytes([value])


def field(which, content):
    """One of protobuf's: text or bytes, or a number."""
    if isinstance(content, int):
        return number(which << 3) + number(content)
    content = content.encode() if isinstance(content, str) else content
    return number(which << 3 | 2) + number(len(content)) + content


def model(of, words, elsewhere, file):
    """The ONNX file `of` with words wherever a model tells of itself (protobuf takes the last of two), and one tensor more whose
    numbers lie `elsewhere`, as ONNX allows."""
    tensor = (field(1, 1) + field(2, 1) + field(8, words) + field(12, words) + field(14, 1) +
              field(13, field(1, "location") + field(2, elsewhere)))
    with open(of, "rb") as source, open(file, "wb") as hostile:
        hostile.write(source.read() + field(2, words) + field(3, words) + field(4, words) + field(6, words) +
                      field(14, field(1, words) + field(2, words)) + field(7, field(2, words) + field(10, words) + field(5, tensor)))
    return file


def cascade(words, elsewhere, file):
    """A Haar cascade that is an entity of XML, which lies elsewhere."""
    with open(file, "w", encoding="utf-8") as hostile:
        hostile.write(f'<?xml version="1.0"?>\n<!DOCTYPE a [<!ENTITY b SYSTEM "file://{elsewhere}">]>\n'
                      f"<!-- {words} -->\n<opencv_storage>&b;</opencv_storage>\n")
    return file


def study(lab, experiment, device, folder):
    """What simulated people did of an experiment, on a device of that name."""
    subprocess.run([lab, "study", "simulate", experiment, "--participants", "2", "--out", folder], check=True, capture_output=True)
    sittings = os.path.join(folder, "sittings.csv")
    with open(sittings, encoding="utf-8", newline="") as file:
        columns, *rows = csv.reader(file)
    with open(sittings, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([device if column == "device" else cell for column, cell in zip(columns, row)] for row in rows)
    return folder


def pages_in(folder):
    """What a browser would open: each file's name and its text."""
    for name in sorted(glob.glob(os.path.join(folder, "*.html")) + glob.glob(os.path.join(folder, "*.svg"))):
        with open(name, encoding="utf-8") as file:
            yield name, file.read()
