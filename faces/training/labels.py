# SPDX-License-Identifier: Apache-2.0
"""What the teacher says about every portrait that may train, kept in the work folder: it takes minutes to ask."""
import numpy as np

from photos import read_photo, training_names
from teacher import Seen, Teacher


def teacher_labels(faces, work, log):
    """name → `Seen` in px of the photo, for every portrait in which the teacher is sure of a face."""
    kept = work / "teacher_labels.npz"
    if not kept.exists():
        ask_teacher(faces, kept, log)
    with np.load(kept) as file:
        return {name: Seen(points.astype(float), skin.astype(float))
                for name, points, skin in zip(file["names"].tolist(), file["points"], file["skins"])}


def ask_teacher(faces, kept, log):
    teacher = Teacher(faces)
    names, labels = training_names(faces), {}
    for i, name in enumerate(names):
        found = teacher.locate(read_photo(faces / "photos", name))
        if found is not None:
            labels[name] = found
        if (i + 1) % 100 == 0:
            log(f"teacher: {i + 1} of {len(names)} portraits, {len(labels)} labelled")
    np.savez(kept, names=np.array(list(labels)),
             points=np.array([seen.points for seen in labels.values()], np.float32),
             skins=np.array([seen.skin for seen in labels.values()], np.float32))
