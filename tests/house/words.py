#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Texts keep to the program's words: words.py ROOT fails where a text that a person meets holds a word that the last table of
resources/translations/README.md forbids in its language.

Read are the English texts and the translations of the catalogues, as English the strings of the shell's verbs and options, and as "docs" the
Markdown files, but for what the scripts make. A word
matches whole, and in either case unless it begins with a capital; one that ends in "…" matches every word that begins so.
Korean, whose particles follow without a space, matches anywhere."""
import itertools
import pathlib
import re
import sys
import xml.etree.ElementTree as ET

from sentences import tokens

GLOSSARY = "resources/translations/README.md"
ROW = re.compile(r"^\| (en|docs|de|ko) \| (.+?) \| (.+?) \|$", re.M)
MADE = {"build", "out"}  # folders that the scripts make
SHELL = ("app/cli/**/*.cpp", "app/main.cpp")


def pattern(language, word):
    beginning = word.endswith("…")
    text = re.escape(word.removesuffix("…"))
    if language == "ko":
        return re.compile(text)
    case = "" if word[0].isupper() else "(?i)"
    return re.compile(rf"{case}(?<!\w){text}" + ("" if beginning else r"(?!\w)"))


def forbidden(root):
    """Of each language its forbidden words: pattern, word, what to say instead."""
    words = {}
    for language, never, instead in ROW.findall((root / GLOSSARY).read_text(encoding="utf-8")):
        words.setdefault(language, []).extend((pattern(language, word), word, instead) for word in never.split(", "))
    return words


def texts(root):
    """(where, language, text) of all that a person meets."""
    for language in ("de", "ko"):
        file = root / f"resources/translations/touchphoto_{language}.ts"
        for context in ET.parse(file).getroot().iter("context"):
            for message in context.iter("message"):
                where = f"{file.name}: {context.findtext('name')}"
                if language == "de":  # the same sources stand in all catalogues
                    yield where, "en", message.findtext("source")
                for form in message.find("translation").iter():
                    yield where, language, form.text or ""
    for file in sorted(file for place in SHELL for file in root.glob(place)):
        for token in tokens(file.read_text(encoding="utf-8")):
            if token.kind == "string" and " " in token.text:
                yield f"{file.relative_to(root)}:{token.line}", "en", token.text


def documentation(root):
    """(where, language, line) of the Markdown files, but for the glossary, which names the words."""
    for file in sorted(root.rglob("*.md")):
        name = file.relative_to(root)
        if name.parts[0] not in MADE and name.as_posix() != GLOSSARY:
            for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
                yield f"{name}:{number}", "docs", line


def faults(root):
    words = forbidden(root)
    for language in ("en", "docs", "de", "ko"):
        if language not in words:
            yield f"{GLOSSARY} forbids no word of {language}"
    for where, language, text in itertools.chain(texts(root), documentation(root)):
        for found, word, instead in words.get(language, []):
            if found.search(text):
                yield f"{where}: \"{text}\" says \"{word}\"; the glossary says {instead}"


if __name__ == "__main__":
    found = list(faults(pathlib.Path(sys.argv[1])))
    print("\n".join(found))
    sys.exit(1 if found else 0)
