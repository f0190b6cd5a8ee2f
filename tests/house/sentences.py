#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The sentences that rooms without languages make, read from their C++ sources: sentences.py ROOT fails where
audio/sentences/sentence_list.cpp is not what the sources say, or where a source makes a sentence in a way that cannot be
read; sentences.py ROOT --write writes that file.

Read is every string expression with words in it: literals joined by +, what stands between them as %1, %2, both ways of a
ternary as two sentences, and quoted(x) as "%1" in quotation marks. Not read is what goes through tr or translate, and SQL."""
import collections
import itertools
import os
import re
import sys

LIST = "audio/sentences/sentence_list.cpp"
ROOMS = ["core", "device", "faces", "audio", "app"]
NOT_ROOMS = [  # nothing of these reaches a page: tools, the shell's verbs, SQL
    "faces/evaluation", "faces/training", "faces/detect/yunet_detector.cpp", "core/experiment", "core/packing/zip.cpp", "core/statistics", "core/study",
    "core/study_folder/study_export.cpp", "core/study_folder/study_readme.cpp",
    "core/handheld", "app/cli", "app/figures/bench", "app/figures/simulated", "app/main.cpp",
    "app/figures/report/aim_report.cpp", "app/figures/report/continuity_cost.cpp", "app/figures/report/field_difference.cpp",
    "app/figures/report/hard_cases.cpp", "app/figures/report/loop_work.cpp", "app/figures/report/released_handle.cpp",
    "app/figures/report/stability_plots.cpp", "app/figures/report/test_scenes.cpp",
    "app/figures/study/published_results.cpp", "app/figures/study/study_page.cpp", "app/figures/study/study_plots.cpp", "app/figures/study/study_report.cpp",
    "app/album/check", "app/album/index/album_news.cpp", "app/album/index/album_queries.cpp", "app/album/index/index_dump.cpp",
    "app/album/index/known_faces.cpp",
    "app/album/index/photo_store.cpp", "app/album/index/schema.cpp", "app/album/index/search_words.cpp",
    "app/album/index/sql_connection.cpp", "app/album/metadata/conflict_name.cpp", "app/photo/scene/feature_words.cpp",
    "app/photo/words",
    "audio/sentences"]
NOT_SAID = {  # file: what of its texts is no sentence, or none that is heard on a page
    "app/album/grouping/album_faces.cpp": {"album faces"},
    "app/album/looking/album_looks.cpp": {"album looks"},
    "app/album/keeper/keeper_recordings.cpp": {"%1 of %2"},
    "app/pages/care/face_finder.cpp": {"care faces"},
    "app/pages/study/study_finger.cpp": {"at most", "cut: the study asks for", "drawn finger", "mouse or touchscreen or keys",
                                          "raised with the researcher's consent", "tone"},
    "app/pages/mend/mend_editing.cpp": {"nudge %1 %2 %3"},
    "app/pages/mend/mend_work.cpp": {"face %1 %2"},
    "app/photo/scene/corrections.cpp": {" removed", "face %1 %2", "face "},
    "app/photo/scene/scene_builder.cpp": {"face %1 %2"},
    "app/photo/tactile/tactile_pdf.cpp": {"DejaVu Sans"},
    "app/photo/tactile/tactile_sheet.cpp": {"orientation mark", "face %1 %2"},
    "app/photo/tactile/tactile_svg.cpp": {"Tactile sheet", "font-family:'DejaVu Sans',sans-serif;font-size:%1px;fill:%2"},
    "device/touch_output/force_feedback/motor_file.cpp": {"tick %ld %ld %d"},
    "audio/recordings/wav_layout.cpp": {"WAVEfmt ", "fmt "},
    "core/svg/path_pieces.cpp": {"reaches beyond what can be computed with", "has more pieces than a sheet may hold",
                                 "has path data that is broken"},
    "core/svg/shape_pieces.cpp": {"has a length \"%1\" that cannot be read", "has a list of points that is broken"},
    "core/svg/sheet_writer.cpp": {"TouchPhoto contours"},
    "faces/extract/face_extractor.cpp": {"There is no detector named \"%1\": choose \"embedded\" or \"yunet\".",
                                         "There is no model named \"%1\": choose \"embedded\" or \"mesh\"."},
    "faces/decode/jpeg_picture.cpp": {"Premature end of JPEG file", "premature end of data segment", "bad Huffman code",
                               "bad arithmetic code", "instead of RST"},
}
TRANSLATED = {"tr", "qsTr", "translate", "QT_TRANSLATE_NOOP", "QT_TR_NOOP", "QML_UNCREATABLE", "static_assert"}
WRAPPERS = {"string", "string_view", "Error"}
QUOTERS = {"quoted", "quoted_readable", "quoted_short"}
SQL = re.compile(r"\b(SELECT|INSERT INTO|UPDATE|DELETE FROM|CREATE|PRAGMA|BEGIN IMMEDIATE|ORDER BY|AND [a-z]+\.[a-z]+) ")
WORDS = re.compile(r"[A-Za-z]{2,}[,.;:]? +(?:[A-Za-z\"%<]|$)|[A-Za-z]{2,}\.(?: |$)|^[,.;:]? +[a-z]{2}")
LETTERS = re.compile(r"[A-Za-z]{2,}")
MOST_WAYS = 32

TOKEN = re.compile(r"""
  (?P<skip>//[^\n]*|/\*.*?\*/|^[ \t]*\#(?:[^\n\\]|\\.|\\\n)*|\s+)
 |(?P<raw>(?:u8|u|U|L)?R"(?P<fence>[^()\\ ]*)\((?P<text>.*?)\)(?P=fence)")
 |(?P<string>(?:u8|u|U|L)?"(?:[^"\\\n]|\\.)*")
 |(?P<char>'(?:[^'\\\n]|\\.)+')
 |(?P<number>\.?\d(?:[\w.']|[eEpP][+-])*)
 |(?P<name>[A-Za-z_]\w*)
 |(?P<sign>::|->|<<=|>>=|<<|>>|\+\+|--|\+=|-=|\*=|/=|%=|\|=|&=|\^=|==|!=|<=|>=|&&|\|\||\.\.\.|[-+*/%&|^~!<>=?:;,.(){}\[\]\\#])
""", re.X | re.S | re.M)
ESCAPES = {"n": "\n", "t": "\t", "r": "\r", "0": "\0"}

Token = collections.namedtuple("Token", "kind text line")
Group = collections.namedtuple("Group", "opens items line")


class Unreadable(Exception):
    pass


def unescaped(text):
    return re.sub(r"\\(x[0-9a-fA-F]+|[0-7]{1,3}|u[0-9a-fA-F]{4}|.)", lambda m: ESCAPES.get(m[1], m[1]), text)


def tokens(source):
    found, place, line = [], 0, 1
    while place < len(source):
        match = TOKEN.match(source, place)
        if not match:
            raise Unreadable(f"{line}: cannot be read from: {source[place:place + 30]!r}")
        kind = next(k for k in ("skip", "raw", "string", "char", "number", "name", "sign") if match[k] is not None)
        text = match[0]
        if kind == "raw":
            found.append(Token("string", match["text"], line))
        elif kind == "string":
            text = unescaped(text[text.index('"') + 1:-1])
            if found and found[-1].kind == "string":
                found[-1] = found[-1]._replace(text=found[-1].text + text)
            else:
                found.append(Token("string", text, line))
        elif kind == "char":
            found.append(Token("string" if len(unescaped(text[1:-1])) == 1 else "char", unescaped(text[1:-1]), line))
        elif kind != "skip":
            found.append(Token(kind, text, line))
        line += match[0].count("\n")
        place = match.end()
    return found


def tree(all_tokens):
    stack = [Group("", [], 1)]
    for token in all_tokens:
        if token.kind == "sign" and token.text in "([{":
            stack.append(Group(token.text, [], token.line))
        elif token.kind == "sign" and token.text in ")]}":
            group = stack.pop()
            if stack[-1].items and is_sign(stack[-1].items[-1], *TRANSLATED):
                group.items.clear()
            stack[-1].items.append(group)
        else:
            stack[-1].items.append(token)
    if len(stack) != 1:
        raise Unreadable(f"{stack[-1].line}: a bracket is open")
    return stack[0]


def is_sign(item, *signs):
    return isinstance(item, Token) and item.kind in ("sign", "name") and item.text in signs


def is_text(item):
    return isinstance(item, Token) and item.kind == "string"


def line_of(items):
    return items[0].line if items else 0


ENDS = (",", ";", "=", "+=", "<<", "&&", "||", "==", "!=", "<=", ">=", "return", "throw", "case", "else")


def expressions(items):
    """What stands between commas, semicolons, comparisons…, each with what it came after."""
    part, after = [], ""
    for item in items:
        block = isinstance(item, Group) and item.opens == "{" and (
            not part or not isinstance(part[-1], Token) or part[-1].kind != "name" or
            part[-1].text in ("const", "noexcept", "override", "try", "do"))
        if block or is_sign(item, *ENDS):
            if part:
                yield after, part
            part, after = [], "" if block else item.text
            if block:
                yield "{", [item]
        else:
            part.append(item)
    if part:
        yield after, part


def split(items, sign):
    parts = [[]]
    for item in items:
        if is_sign(item, sign):
            parts.append([])
        else:
            parts[-1].append(item)
    return parts


def ways(items):
    """Every way in which an expression may come out, each a list of texts and of None for what is not a literal; and the
    groups in it that were not looked into."""
    for i, item in enumerate(items):
        if is_sign(item, "?"):
            depth = 0
            for j in range(i + 1, len(items)):
                depth += is_sign(items[j], "?") - is_sign(items[j], ":")
                if depth < 0:
                    first, left = ways(items[i + 1:j])
                    second, also_left = ways(items[j + 1:])
                    return first + second, left + also_left + [g for g in items[:i] if isinstance(g, Group)]
    parts = split(items, "+")
    if len(parts) == 1:
        return operand(items)
    read = [operand(part) for part in parts]
    count = 1
    for one, _ in read:
        count *= len(one)
    if count > MOST_WAYS:
        raise Unreadable(f"{line_of(items)}: a sentence comes out in {count} ways; make it in fewer")
    return [sum(way, []) for way in itertools.product(*(one for one, _ in read))], sum((left for _, left in read), [])


def operand(items):
    last = items[-1] if items else None
    if len(items) == 1 and is_text(last):
        return [[last.text]], []
    if isinstance(last, Group) and not any(is_sign(i, ",", ";") for i in last.items) and last.items:
        before = items[:-1]
        if not before and last.opens == "(":
            return ways(last.items)
        if before and all(isinstance(b, Token) for b in before) and before[-1].text in WRAPPERS:
            return ways(last.items)
    if isinstance(last, Group) and len(items) > 1 and is_sign(items[-2], *QUOTERS):
        return [['"', None, '"']], [last]
    if any(is_text(i) for i in items) and all(is_text(i) or isinstance(i, Token) and i.kind == "name" for i in items):
        return [[i.text if is_text(i) else None for i in items]], []  # literals beside a macro
    return [[None]], [i for i in items if isinstance(i, Group)]


def pattern(way):
    text, number = "", 0
    for part in way:
        if part is not None:
            text += part
        else:
            number += 1
            text += f"%{number}"
    return text


def said(text):
    bare = re.sub(r"%\d", "", text)
    return (WORDS.search(text) and LETTERS.search(bare) and not SQL.search(text) and "\n" not in text) or text == "%1: %2"


def walk(items, found, faults):
    parts = list(expressions(items))
    texts = [way for _, part in parts if len(part) == 1 and is_text(part[0]) for way in [part[0].text]]
    a_list = len(texts) == len(parts) and any(said(text) for text in texts)
    for i, (after, part) in enumerate(parts):
        if after == "{":
            walk(part[0].items, found, faults)
            continue
        all_ways, left = ways(part)
        beside = a_list or any(said(pattern(way)) for way in all_ways)  # a word that takes the place of a sentence
        for way in all_ways:
            if not any(text is not None for text in way):
                continue
            text = pattern(way)
            if not said(text) and not (beside and LETTERS.search(text)):
                continue
            found.setdefault(text, line_of(part))
            faulty = lambda why: faults.append((line_of(part), text, why))
            if after == "+=":
                faulty("is put at the end of another text; make the sentence at once")
            if after == "<<":
                faulty("goes into a stream; make the sentence by +")
            if re.search(r"%\d%\d", text):
                faulty("has two parts without a word between them")
            if any(piece and re.search(r"%[\dnL]", piece) for piece in way):
                faulty("holds the sign of a placeholder")
        for item, group in zip(part, part[1:]):
            if is_sign(item, "append") and isinstance(group, Group):
                for way in ways(group.items)[0]:
                    if any(text and said(text) for text in way):
                        faults.append((item.line, pattern(way), "is made by append; make it by +"))
        for group in left:
            walk(group.items, found, faults)


def sentences_of(source):
    """The sentences of a source as a map to their lines, and what in it cannot be read."""
    found, faults = {}, []
    try:
        walk(tree(tokens(source)).items, found, faults)
    except Unreadable as trouble:
        faults.append((0, "", str(trouble)))
    return found, faults


def sources(root):
    for room in ROOMS:
        for folder, _, names in sorted(os.walk(os.path.join(root, room))):
            for name in sorted(names):
                file = os.path.relpath(os.path.join(folder, name), root)
                if name.endswith((".cpp", ".hpp")) and not any((file + "/").startswith(no + "/") for no in NOT_ROOMS):
                    yield file


def read_all(root):
    everything, faults = {}, []
    for file in sources(root):
        with open(os.path.join(root, file), encoding="utf-8") as source:
            found, trouble = sentences_of(source.read())
        silent = NOT_SAID.get(file, set())
        faults += [f"{file}:{line}: \"{text}\" {why}" for line, text, why in trouble if text not in silent]
        faults += [f"{file}: \"{text}\" is not there any more, but in NOT_SAID" for text in silent - set(found)]
        for text, line in found.items():
            if text not in silent:
                everything.setdefault(text, f"{file}:{line}")
    return everything, faults


def literal(text):
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"').replace("\n", "\\n") + '"'


def list_of(everything):
    lines = "".join(f"    QT_TRANSLATE_NOOP(\"Sentence\", {literal(text)}),\n" for text in sorted(everything))
    return ("// SPDX-License-Identifier: Apache-2.0\n"
            "// Written by tests/house/sentences.py from the sources of the rooms that make these sentences.\n"
            "#include \"audio/sentences/sentence_list.hpp\"\n\n"
            "#include <QtGlobal>\n\n#include <span>\n\n"
            "namespace tp {\n\n"
            "// clang-format off\n"
            "namespace {\n"
            "constexpr const char* all_sentences[] = {\n" + lines + "};\n"
            "} // namespace\n"
            "// clang-format on\n\n"
            "std::span<const char* const> sentence_list() { return all_sentences; }\n\n"
            "} // namespace tp\n")


def main(root, write):
    everything, faults = read_all(root)
    wanted, file = list_of(everything), os.path.join(root, LIST)
    there = open(file, encoding="utf-8").read() if os.path.exists(file) else ""
    if write and there != wanted:
        with open(file, "w", encoding="utf-8") as out:
            out.write(wanted)
    elif there != wanted:
        noted = set(re.findall(r'QT_TRANSLATE_NOOP\("Sentence", (".*")\)', there))
        faults += [f"{place}: {text!r} is not in {LIST}" for text, place in everything.items() if literal(text) not in noted]
        faults += [f"{LIST} is not what the sources say; packaging/translate writes it"]
    print("\n".join(faults))
    print(f"{len(everything)} sentences")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], "--write" in sys.argv[2:]))
