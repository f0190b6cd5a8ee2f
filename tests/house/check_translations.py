#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The catalogues of the languages are whole: check_translations.py ROOT fails where a text of the sources is in no catalogue,
where a translation is missing or lacks a placeholder, and where a catalogue holds a text that no source has."""
import collections
import os
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET

LUPDATE = "/usr/lib/qt6/bin/lupdate"
PLACES = re.compile(r"%(?:n|L?\d)")


def messages(file):
    for context in ET.parse(file).getroot().iter("context"):
        for message in context.iter("message"):
            comment = message.find("comment")
            key = (context.find("name").text, message.find("source").text, comment.text if comment is not None else "")
            yield key, message


def forms(message):
    translation = message.find("translation")
    plural = translation.findall("numerusform")
    return [form.text or "" for form in plural] if plural else [translation.text or ""]


def faults_in(file):
    for (context, source, _), message in messages(file):
        where = f"{os.path.basename(file)}: {context}: \"{source}\""
        if message.find("translation").get("type") == "unfinished":
            yield f"{where} is not translated"
            continue
        for form in forms(message):
            if not form.strip():
                yield f"{where} is translated by nothing"
            wanted, found = (collections.Counter(PLACES.findall(text)) for text in (source, form))
            if message.get("numerus"):  # a form for one may say "one" itself
                wanted.pop("%n", None)
                found.pop("%n", None)
            if wanted != found:
                yield f"{where} has other placeholders in \"{form}\""


def in_sources(root, folder, plurals_only):
    file = os.path.join(folder, "sources.ts")
    if os.path.exists(file):
        os.remove(file)
    subprocess.run([LUPDATE, "-silent", "-locations", "none", "-no-ui-lines", "-extensions", "cpp,hpp,qml", "-I", root,
                    os.path.join(root, "app"), os.path.join(root, "audio"), "-ts", file] + (["-pluralonly"] if plurals_only else []), check=True,
                   capture_output=True)
    return {key for key, _ in messages(file)}


def check(root):
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        for language in ("en", "de", "ko"):
            file = os.path.join(root, "resources", "translations", f"touchphoto_{language}.ts")
            faults += faults_in(file)
            wanted, there = in_sources(root, folder, language == "en"), {key for key, _ in messages(file)}
            faults += [f"{os.path.basename(file)} lacks {context}: \"{source}\"" for context, source, _ in wanted - there]
            faults += [f"{os.path.basename(file)} holds {context}: \"{source}\", which no source says any more"
                       for context, source, _ in there - wanted]
            print(f"{language}: {len(there)} texts")
    return faults


if __name__ == "__main__":
    found = check(sys.argv[1])
    print("\n".join(found[:40]))
    if found:
        print(f"{len(found)} faults. packaging/translate brings the catalogues up to date.")
    sys.exit(1 if found else 0)
