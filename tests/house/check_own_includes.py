#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Finds forgotten includes: names of Qt and of the standard library that a file uses and that no header reaches it with.

The release build reads Qt's headers once for all (cmake/WholeBuild.cmake); a precompiled header also gives a file what
it forgot to include, and another version of Qt or of the library then fails to build. A name counts as reached where the
file, or one of our own headers that it includes, includes the name's header; Qt's classes also where they are declared
forward. Usage: check_own_includes.py ROOT
"""

import pathlib
import re
import sys

ROOMS = ("core", "device", "faces", "audio", "app", "tests")
STAND_IN = "tests/windows/stand_in/"  # what it has the names of Qt for it declares itself

# A header of the standard library: the names that ask for it (ISO C++20, the synopses of the headers).
STANDARD = {
    "algorithm": "sort stable_sort find find_if any_of all_of none_of clamp copy_if transform lower_bound upper_bound"
                 " min_element max_element remove_if reverse rotate nth_element shuffle",
    "array": "array", "atomic": "atomic atomic_flag", "charconv": "from_chars to_chars",
    "chrono": "chrono", "cmath": "sqrt hypot sin cos atan2 floor ceil round lround isfinite isnan exp log pow",
    "condition_variable": "condition_variable", "cstdint": "uint8_t uint16_t uint32_t uint64_t int16_t int32_t int64_t",
    "filesystem": "filesystem", "fstream": "ifstream ofstream fstream", "functional": "function",
    "future": "future promise async", "limits": "numeric_limits", "map": "map multimap",
    "memory": "unique_ptr shared_ptr weak_ptr make_unique make_shared", "mutex": "mutex lock_guard scoped_lock unique_lock",
    "numbers": "numbers", "numeric": "accumulate iota", "optional": "optional nullopt",
    "random": "mt19937 mt19937_64 uniform_int_distribution uniform_real_distribution normal_distribution",
    "set": "set multiset", "span": "span", "sstream": "ostringstream istringstream stringstream",
    "string": "string to_string", "string_view": "string_view", "thread": "thread jthread this_thread",
    "tuple": "tuple tie", "unordered_map": "unordered_map", "unordered_set": "unordered_set",
    "variant": "variant", "vector": "vector",
}
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}
# Headers that the standard, or every implementation of it, makes another header bring along.
BRINGS = {"string": ["string_view"], "filesystem": ["string", "string_view", "chrono"], "map": ["tuple"],
          "thread": ["chrono"], "future": ["thread", "mutex", "memory", "chrono"], "condition_variable": ["mutex", "chrono"],
          "memory": ["tuple"], "fstream": ["string", "string_view"], "sstream": ["string", "string_view"],
          "iostream": ["string", "string_view"], "functional": ["tuple"], "mutex": ["chrono"]}

# What every header of Qt that we include brings along (qobject.h and qstring.h reach them all).
QT_BASICS = {"QString", "QStringLiteral", "QChar", "QLatin1Char", "QLatin1String", "QLatin1StringView", "QStringView",
             "QByteArray", "QByteArrayList", "QByteArrayLiteral", "QByteArrayView", "QList", "QStringList"}
# Names without a header of their own, or that a header must bring along, since it takes or gives them by value.
QT_CARRIES = {
    "QObject": ["QMetaObject"], "QTest": ["QObject", "QMetaObject"], "QTimer": ["QObject", "QMetaObject"],
    "QThread": ["QObject", "QMetaObject"], "QGuiApplication": ["QCoreApplication"],
    "QProcess": ["QProcessEnvironment"], "QCommandLineParser": ["QCommandLineOption"],
    "QJsonObject": ["QJsonValue"], "QJsonArray": ["QJsonValue"], "QVariant": ["QVariantList", "QVariantMap"],
    "QRect": ["QPoint", "QSize"], "QRectF": ["QPointF", "QSizeF", "QPoint", "QSize"], "QPointF": ["QPoint"],
    "QSizeF": ["QSize"], "QImage": ["QSize", "QPaintDevice"], "QPainter": ["QPen", "QBrush", "QColor", "QFont"],
    "QPen": ["QColor"], "QtGlobal": ["QMessageLogContext"], "QAudioSink": ["QAudio"], "QAudioSource": ["QAudio"],
    "QAudioDevice": ["QAudioFormat"], "QAccessible": ["QAccessibleInterface", "QAccessibleActionInterface",
                                                      "QAccessibleValueInterface"],
    "QQuickView": ["QQuickWindow"], "QQuickPaintedItem": ["QQuickItem"], "QNetworkReply": ["QNetworkRequest"],
}
QT_NAME = re.compile(r"(?<![\w:\"<])(Q[A-Z][a-z][A-Za-z0-9]*)\b(?!\s*/)")
STD_NAME = re.compile(r"\bstd::(\w+)")
INCLUDE = re.compile(r"^\s*#\s*include\s+[<\"]([^>\"]+)[>\"]", re.M)
FORWARD = re.compile(r"^\s*(?:class|struct)\s+(Q\w+)\s*;", re.M)


def without_comments_and_strings(text):
    """The code alone: what stands in comments, strings and raw strings is not used."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.S)
    text = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    return re.sub(r'"(?:[^"\\\n]|\\.)*"', '""', re.sub(r"#\s*include[^\n]*", "", text))


class House:
    def __init__(self, root):
        self.root = root
        self.texts = {path.relative_to(root).as_posix(): path.read_text(encoding="utf-8")
                      for room in ROOMS for path in sorted((root / room).rglob("*")) if path.suffix in (".cpp", ".hpp")}
        self.reached = {}

    def own_header(self, name, includer):
        """Where the file that `includer` includes as `name` lies; None for a header that is not ours."""
        beside = (pathlib.PurePosixPath(includer).parent / name).as_posix()
        for path in (name, beside, f"tests/support/{name}"):
            if path in self.texts:
                return path
        return None

    def headers(self, path):
        """(foreign headers, Qt classes declared forward) that reach `path`."""
        if path not in self.reached:
            self.reached[path] = (set(), set())  # a ring of includes ends here
            foreign, declared = set(), set(FORWARD.findall(self.texts[path]))
            for name in INCLUDE.findall(self.texts[path]):
                own = self.own_header(name, path)
                if own:
                    more, names = self.headers(own)
                    foreign |= more
                    declared |= names
                else:
                    foreign.add(name)
                    foreign.update(BRINGS.get(name, []))
            self.reached[path] = (foreign, declared)
        return self.reached[path]

    def forgotten(self, path):
        """The headers that `path` uses names of and is not reached by: {header: a name}."""
        foreign, declared = self.headers(path)
        included = {header.split("/")[-1] for header in foreign}
        carried = {name for header in included for name in QT_CARRIES.get(header, [])}
        known = included | carried | declared | (QT_BASICS if any(name[:1] == "Q" for name in included) else set())
        code = without_comments_and_strings(self.texts[path])
        faults = {}
        for name in set(STD_NAME.findall(code)):
            header = HEADER_OF.get(name)
            if header and header not in foreign:
                faults[f"<{header}>"] = f"std::{name}"
        for name in set(QT_NAME.findall(code)):
            if name not in known:
                faults[f"<{name}>"] = name
        return faults


def main():
    house = House(pathlib.Path(sys.argv[1]))
    count = 0
    for path in house.texts:
        if path.startswith(STAND_IN):
            continue
        for header, name in sorted(house.forgotten(path).items()):
            print(f"{path}: uses {name}: include {header}")
            count += 1
    print(f"{len(house.texts)} files, {count} forgotten includes")
    return 1 if count or not house.texts else 0


if __name__ == "__main__":
    sys.exit(main())
