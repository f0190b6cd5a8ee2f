# SPDX-License-Identifier: Apache-2.0
"""What the manual's pages say, out of the texts that the house has already: what the programs answer to --help, the page of
the verbs, the description for software centres, the tables of the README and the comments that the helpers begin with."""
import re
import xml.etree.ElementTree as ET

import roff

NAMES = {
    "touchphoto": "feel the face in a photograph, hear the memories that belong to it",
    "touchphoto-lab": "faces, contours, albums and force devices from a shell",
    "touchphoto-force-guard": "takes the force off a device when TouchPhoto cannot",
    "touchphoto-decoder": "decodes photographs and videos of strangers for TouchPhoto",
}
OPTION = re.compile(r"^  (-\S.*?)(?:  +(.*))?$")


def page(program, section, version, date, parts):
    """The page's text; parts are (heading, lines)."""
    lines = [f'.\\" Written by packaging/manual.', f'.TH {program.upper()} {section} {date} "TouchPhoto {version}"']
    lines += [".SH NAME", f"{roff.escaped(program)} \\- {NAMES[program]}"]
    for heading, of in parts:
        lines += [f".SH {heading}", *of]
    return "\n".join(lines) + "\n"


def sections(markdown, mark="## "):
    """(heading, text) of a page's sections at that depth; what stands before the first is left out."""
    parts = re.split(rf"^{mark}(.+)$", markdown, flags=re.M)[1:]
    return list(zip(parts[::2], parts[1::2]))


def see_also(*pages):
    """Where more stands."""
    return [", ".join(f"\\fB{roff.escaped(name)}\\fR({section})" for name, section in pages)]


def options(help_text):
    """The part "Options:" of an answer to --help: each option with what it does."""
    out = []
    for text in help_text.split("Options:\n", 1)[-1].split("\n\n", 1)[0].splitlines():
        found = OPTION.match(text)
        if found:
            out += [".TP", f"\\fB{roff.escaped(found[1])}\\fR", roff.line(roff.escaped(found[2] or ""))]
        elif text.strip():
            out.append(roff.line(roff.escaped(text.strip())))
    return [text for text in out if text]


def described(metainfo):
    """The English paragraphs for software centres."""
    for paragraph in ET.parse(metainfo).getroot().find("description"):
        if not paragraph.attrib:
            yield from [".PP", roff.prose(" ".join(paragraph.text.split()))]


def touchphoto(root, version, date, answer):
    readme = (root / "README.md").read_text(encoding="utf-8")
    keys = re.search(r"^\| key \| does \|\n(?:\|.*\n)+", readme, re.M)[0]
    parts = [
        ("SYNOPSIS", ["\\fBtouchphoto\\fR [\\fIoptions\\fR] [\\fIphotograph\\fR]", ".br",
                      "\\fBtouchphoto\\fR \\fIbundle\\fR.touchphoto"]),
        ("DESCRIPTION", [*described(root / "resources/desktop/org.touchphoto.TouchPhoto.metainfo.xml"), *roff.body(
            "With a photograph its faces are felt at once; with a bundle its photographs and recordings are brought into "
            "the album. Without either the start page opens; F1 says what can be done where one is.")]),
        ("OPTIONS", options(answer("touchphoto", "--help"))),
        ("KEYS", [".PP", "Where a face is felt:", *roff.body(keys)]),
        ("FILES", roff.body(
            "- `~/.config/touchphoto`: what was chosen, and where a device lies on the screen.\n"
            "- `~/.cache/touchphoto`: the album's index, which can be thrown away.\n"
            "- Photographs keep what belongs to them beside them: `PHOTO.xmp`, `PHOTO.contours.svg`, recordings as FLAC.")),
        ("SEE ALSO", see_also(("touchphoto-lab", 1), ("touchphoto-force-guard", 8))),
    ]
    return page("touchphoto", 1, version, date, parts)


def lab(root, version, date, answer):
    verbs = re.findall(r"^  ([a-z]+) +(.+)$", answer("touchphoto-lab", "--help"), re.M)
    told = dict(sections((root / "app/cli/VERBS.md").read_text(encoding="utf-8")))
    listed = [text for name, about in verbs for text in (".TP", f"\\fB{name}\\fR", roff.prose(about))]
    pages = []
    for heading in told:
        if heading == "For every verb":
            continue
        pages += [f".SS {heading}", *roff.body(told[heading])]
        for verb in heading.split(", "):
            said = answer("touchphoto-lab", verb, "--help")
            if "Options:\n" in said:
                pages += [".PP", f"Options of \\fB{verb}\\fR:", *options(said)]
    left_out = {name for name, _ in verbs} - {verb for heading in told for verb in heading.split(", ")}
    if left_out:
        raise ValueError(f"app/cli/VERBS.md has no section of {', '.join(sorted(left_out))}")
    parts = [
        ("SYNOPSIS", ["\\fBtouchphoto\\-lab\\fR \\fIverb\\fR [\\fIoptions\\fR] ..."]),
        ("DESCRIPTION", [".PP", "What TouchPhoto can do, from a shell. The verbs:", *listed,
                         *roff.body(told["For every verb"])]),
        ("VERBS", pages),
        ("SEE ALSO", see_also(("touchphoto", 1), ("touchphoto-force-guard", 8), ("touchphoto-decoder", 8))),
    ]
    return page("touchphoto-lab", 1, version, date, parts)


def helper(root, version, date, program, source):
    """A page of the comment that a helper's main.cpp begins with; indented lines are how it is called."""
    comment = re.findall(r"^//(.*)$", (root / source).read_text(encoding="utf-8"), re.M)[1:]
    comment = comment[:next((i for i, text in enumerate(comment) if text.startswith("/")), len(comment))]
    calls = [text.strip() for text in comment if text.startswith("     ")]
    text = "\n".join(text[1:] for text in comment if not text.startswith("     "))
    return page(program, 8, version, date, [
        ("SYNOPSIS", [f"\\fB{roff.escaped(program)}\\fR " + roff.escaped(call.split(" ", 1)[1]) + "\n.br" for call in calls]),
        ("DESCRIPTION", [*roff.body(text), *roff.body("Nobody starts it by hand: TouchPhoto finds it in its own folder.")]),
        ("SEE ALSO", see_also(("touchphoto", 1), ("touchphoto-lab", 1))),
    ])
