# SPDX-License-Identifier: Apache-2.0
"""Files of a stranger's that verbs read: what they say of themselves would like to be fetched from somewhere."""
import csv
import glob
import os
import subprocess


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
