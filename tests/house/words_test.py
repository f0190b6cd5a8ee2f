#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The check of words finds those that the glossary forbids, and only them."""

import pathlib
import tempfile
import unittest

from words import faults

GLOSSARY = """# Words
| language | never | but |
| --- | --- | --- |
| en | shall, Return | should, Enter |
| docs | anew | again |
| de | vorig…, du | vorherig…, Sie |
| ko | 십시오, 을(를) | 세요 |
"""


def found(source="Save", german="Speichern", korean="저장", shell="", docs="", glossary=GLOSSARY):
    """What is wrong of a house with one text in three languages and one verb, whose texts are `shell`, and a page."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        page = root / "resources/translations"
        page.mkdir(parents=True)
        (page / "README.md").write_text(glossary, encoding="utf-8")
        for language, text in (("de", german), ("ko", korean)):
            (page / f"touchphoto_{language}.ts").write_text(
                f"<TS><context><name>Page</name><message><source>{source}</source>"
                f"<translation>{text}</translation></message></context></TS>", encoding="utf-8")
        (root / "app/cli/album").mkdir(parents=True)
        (root / "app/cli/album/verb.cpp").write_text(f"// shall\nsay(\"{shell}\");\n", encoding="utf-8")
        (root / "room").mkdir()
        (root / "room/README.md").write_text(docs, encoding="utf-8")
        (root / "build").mkdir()
        (root / "build/made.md").write_text("Anew.", encoding="utf-8")
        return list(faults(root))


class Words(unittest.TestCase):
    def test_texts_that_keep_to_the_words_have_no_faults(self):
        self.assertEqual(found(), [])

    def test_a_word_is_found_in_every_language(self):
        self.assertEqual(found(source="What shall it say?"),
                         ['touchphoto_de.ts: Page: "What shall it say?" says "shall"; the glossary says should, Enter'])
        self.assertEqual(len(found(german="Das kannst du")), 1)
        self.assertEqual(len(found(korean="누르십시오")), 1)

    def test_documentation_is_read_line_by_line(self):
        self.assertEqual(found(docs="# Title\nIt begins anew.\n"),
                         ['room/README.md:2: "It begins anew." says "anew"; the glossary says again'])
        self.assertEqual(found(docs="It begins again; What shall we do?"), [])

    def test_forms_of_a_plural_are_texts(self):
        self.assertEqual(len(found(german="<numerusform>Foto</numerusform><numerusform>vorige Fotos</numerusform>")), 1)

    def test_the_shell_is_read_and_its_comments_are_not(self):
        self.assertEqual(len(found(shell="It shall be")), 1)
        self.assertEqual(found(shell="It should be"), [])

    def test_a_word_is_whole_unless_only_its_beginning_is_given(self):
        self.assertEqual(found(source="marshall", german="Dudelsack"), [])
        self.assertEqual(len(found(german="Vorige Frage")), 1)
        self.assertEqual(found(german="Vorherige Frage"), [])

    def test_what_begins_with_a_capital_is_so_alone(self):
        self.assertEqual(len(found(source="Press Return")), 1)
        self.assertEqual(found(source="Many happy returns, and return"), [])

    def test_signs_are_taken_as_they_are(self):
        self.assertEqual(len(found(korean="%1을(를) 찾을 수 없음")), 1)

    def test_a_glossary_that_forbids_nothing_is_a_fault(self):
        self.assertEqual(len(found(glossary="# Words\n")), 4)


if __name__ == "__main__":
    unittest.main()
