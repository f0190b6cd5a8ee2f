#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What CONTRIBUTING.md and docs name is there: check_places.py ROOT fails where they name a file, a folder or a name of the
API that does not exist, and where a thread is made in a file that docs/threads.md does not name."""
import os
import re
import sys

PLACES = re.compile(r"`([\w.+-]+(?:/[\w.+-]+)*/?)`")
LINKS = re.compile(r"\]\(([^)#:]+)\)")
NAMES = re.compile(r"\btp::(\w+)")
STANDS_FOR = re.compile(r"NAME|FOLDER|LANGUAGE|Name|name_|^\.\w+$|/all$")  # a word for another, an ending, a target
ENDINGS = (".md", ".txt", ".cpp", ".hpp", ".qml", ".cmake", ".json", ".py", ".ts")
TOPS = ("app", "audio", "cmake", "core", "device", "docs", "faces", "packaging", "resources", "tests")
THREADS = re.compile(r"std::j?thread\s*[>{(]|std::(?:j?thread|vector<std::j?thread>) \w+|std::async\(|"
                     r"^\s*(?:QThread\*?|QThreadPool) \w+;|\bnew QThread\b", re.M)


def text_of(file):
    with open(file, encoding="utf-8") as opened:
        return opened.read()


def sources(root, folders, endings):
    for top in folders:
        for folder, _, files in os.walk(os.path.join(root, top)):
            yield from (os.path.relpath(os.path.join(folder, file), root) for file in files if file.endswith(endings))


def is_place(word):
    return "/" in word and word.split("/")[0] in TOPS or word.endswith(ENDINGS) and "/" not in word


def missing_places(root, page, text):
    base = os.path.dirname(os.path.join(root, page))
    bare = {os.path.basename(file) for file in sources(root, TOPS, ENDINGS)} | set(os.listdir(root))
    for word in PLACES.findall(text):
        if not is_place(word) or STANDS_FOR.search(word):
            continue
        if not (os.path.exists(os.path.join(root, word)) or "/" not in word and word in bare):
            yield f"{page} names {word}, which is not there"
    for target in LINKS.findall(text):
        if not os.path.exists(os.path.join(base, target)):
            yield f"{page} links to {target}, which is not there"


def missing_names(root, page, text):
    headers = "\n".join(text_of(os.path.join(root, file)) for file in sources(root, ("core", "device", "faces"), ".hpp"))
    for name in sorted(set(NAMES.findall(text))):
        if not re.search(rf"(?:class|struct|enum class|using) {name}\b|\b{name}\(", headers):
            yield f"{page} names tp::{name}, which no header declares"


def unknown_threads(root, table):
    for file in sources(root, ("app", "audio", "core", "device", "faces"), (".cpp", ".hpp")):
        stem = os.path.splitext(os.path.basename(file))[0]
        if THREADS.search(text_of(os.path.join(root, file))) and not re.search(rf"\b{stem}\b", table):
            yield f"{file} makes a thread, and docs/threads.md does not name {stem}"


def faults(root):
    pages = ["CONTRIBUTING.md"] + sorted(os.path.join("docs", file) for file in os.listdir(os.path.join(root, "docs"))
                                         if file.endswith(".md"))
    for page in pages:
        text = text_of(os.path.join(root, page))
        yield from missing_places(root, page, text)
        yield from missing_names(root, page, text)
    yield from unknown_threads(root, text_of(os.path.join(root, "docs", "threads.md")))


if __name__ == "__main__":
    found = list(faults(sys.argv[1]))
    print("\n".join(found))
    sys.exit(1 if found else 0)
