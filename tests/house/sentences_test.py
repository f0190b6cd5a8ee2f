#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""sentences.py reads the sentences of a source, and says where it cannot."""

import unittest

from sentences import list_of, sentences_of


def read(source):
    found, faults = sentences_of(source)
    return sorted(found), [why for _, _, why in faults]


class Sentences(unittest.TestCase):
    def holds(self, source, *sentences):
        self.assertEqual(read(source), (sorted(sentences), []))

    def fails(self, source, part):
        faults = read(source)[1]
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(part, faults[0])

    def test_literals_and_what_stands_between_them(self):
        self.holds('return Error{"The file cannot be read."};', "The file cannot be read.")
        self.holds('x = "It has " + std::to_string(n + 1) + " of " + f("a b", 2) + ".";', "It has %1 of %2.")
        self.holds('f("The file is " /* so */ "empty."\n  " Now.");', "The file is empty. Now.")
        self.holds('Error{std::string("The plot ") + a.b->c().string() + " is gone."}', "The plot %1 is gone.")
        self.holds('f(R"(It is "so".)");', 'It is "so".')

    def test_quoted_names_stand_in_quotation_marks(self):
        self.holds('return "No file " + quoted(a / b) + "." + c;', 'No file "%1".%2')
        self.holds('f(quoted_readable(name) + " is gone.")', '"%1" is gone.')
        self.holds('f("No \\"" + name + "\\" here.")', 'No "%1" here.')

    def test_both_ways_of_a_ternary(self):
        self.holds('return a == b ? "it is gone." : c ? "it is empty." : "";', "it is gone.", "it is empty.")
        self.holds('f("The " + (big ? "big" : "small " + kind) + " file is gone.");',
                   "The big file is gone.", "The small %1 file is gone.")
        self.holds('return a ? "the memo" : "the memo about " + who;', "the memo", "the memo about %1")
        self.holds('r = ok ? Result(x) : Error{"It is over."};', "It is over.")

    def test_a_list_with_a_sentence_in_it_is_read_whole(self):
        self.holds('const char* all[] = {"right eye", "mouth"};', "right eye", "mouth")
        self.holds('const char* all[] = {"eye", "mouth"};')

    def test_literals_beside_a_macro(self):
        self.holds('f("It needs the library " NAME ", which is not here.");', "It needs the library %1, which is not here.")

    def test_expressions_within_expressions(self):
        self.holds('g([&] { return "There is nothing here."; }, "Say it." + h("And then that."));',
                   "There is nothing here.", "Say it.%1", "And then that.")
        self.holds('switch (a) { case A: return "It is one."; default: break; }', "It is one.")

    def test_what_is_no_sentence_or_is_translated_there(self):
        self.holds('tr("The file is gone."); QCoreApplication::translate("A", "The file is gone.");')
        self.holds('run("SELECT a, b FROM c WHERE d = ?"); f("id", "max-width", "a", ": "); // "A file is gone."')
        self.holds('#define A "The file is gone."\nstatic_assert(x, "that is so."); f("one two\\n");')
        self.holds("f('\"', '.', 'a');")

    def test_what_cannot_be_read_is_told(self):
        self.fails('text += "and then it ends.";', "at the end of another text")
        self.fails('out << "The file is gone.";', "stream")
        self.fails('text.append("The file is gone.");', "append")
        self.fails('f("The file " + a + b + " is gone.");', "two parts")
        self.fails('f("The %1 is gone.");', "placeholder")
        self.fails("f(" + " + ".join('(a ? "one " : "two ")' for _ in range(6)) + ' + "is gone.");', "64 ways")
        self.fails('f("The file is gone.";', "bracket")

    def test_the_list_holds_each_once_and_is_a_source(self):
        text = list_of({'No "%1".': "", "A \\ b.": ""})
        self.assertIn('    QT_TRANSLATE_NOOP("Sentence", "A \\\\ b."),\n'
                      '    QT_TRANSLATE_NOOP("Sentence", "No \\"%1\\"."),\n', text)


if __name__ == "__main__":
    unittest.main()
