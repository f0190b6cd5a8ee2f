# SPDX-License-Identifier: Apache-2.0
"""The Markdown that our pages are written in, as the macros of man(7): paragraphs, lists, tables, code, emphasis, links."""
import re

INLINE = re.compile(r"`([^`]+)`|\*\*([^*]+)\*\*|\[([^\]]*)\]\([^)]*\)")
ROW = re.compile(r"^\| (.*) \|$")


def escaped(text):
    """Text as roff prints it: a backslash stays one, a hyphen is the character that a person can search for and copy."""
    return text.replace("\\", "\\e").replace("-", "\\-")


def line(text):
    """A line of its own, which is no request whatever it begins with."""
    return "\\&" + text if text[:1] in (".", "'") else text


def prose(text):
    """`code` and **bold** become bold, a [link](place) its words."""
    def bold(match):
        code, strong, words = match.groups()
        return escaped(words) if words is not None else f"\\fB{escaped(code or strong)}\\fR"

    out, end = [], 0
    for match in INLINE.finditer(text):
        out += [escaped(text[end:match.start()]), bold(match)]
        end = match.end()
    return line("".join(out) + escaped(text[end:]))


def example(lines):
    """Lines as they are."""
    return [".PP", ".EX", *(line(escaped(text)) for text in lines), ".EE"]


def blocks(lines):
    """(kind, lines) of code, tables, items and paragraphs, in order."""
    found, code = [("gap", [])], False
    for text in lines:
        if text.startswith("```"):
            code = not code
            found.append(("code" if code else "gap", []))
            continue
        if code:
            found[-1][1].append(text)
            continue
        kind = "gap" if not text.strip() else "row" if ROW.match(text) else "item" if text.startswith("- ") else "text"
        last = found[-1][0]
        if kind == "item" or kind == "text" and last not in ("text", "item") or kind in ("row", "gap") and last != kind:
            found.append((kind, []))
        found[-1][1].append(text)
    return [(kind, of) for kind, of in found if kind != "gap" and of]


def table(rows):
    """A table's rows below its head, the first cell as what the others are about."""
    out = []
    for row in rows[2:]:
        cells = [cell.strip().replace("\\|", "|") for cell in ROW.match(row)[1].split(" | ")]
        first = cells[0] if cells[0] else "\\(em"
        out += [".TP", prose(first) if cells[0] else first, prose("; ".join(cell for cell in cells[1:] if cell)) or "\\&"]
    return out


def body(markdown):
    """Requests and text of a page's part without headings."""
    out = []
    for kind, lines in blocks(markdown.splitlines()):
        if kind == "code":
            out += example(lines)
        elif kind == "row":
            out += table(lines)
        elif kind == "item":
            out += [".IP \\(bu 2", prose(" ".join(text.strip() for text in [lines[0][2:], *lines[1:]]))]
        else:
            out += [".PP", prose(" ".join(text.strip() for text in lines))]
    return out
