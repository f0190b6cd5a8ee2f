# SPDX-License-Identifier: Apache-2.0
"""Where a file of C++ can be made wrong, by the syntax tree that libclang reads."""

from __future__ import annotations

import re
from collections.abc import Iterator

from clang.cindex import Cursor, CursorKind, Index, TypeKind

from mutant import Mutant

OPERATORS = ("boundary", "arithmetic", "constant", "condition", "statement", "return")

_BOUNDARY = {"<": "<=", "<=": "<", ">": ">=", ">=": ">", "==": "!=", "!=": "=="}
_ARITHMETIC = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "/", "+=": "-=", "-=": "+=", "*=": "/=", "/=": "*=",
               "&": "|", "|": "&", "<<": ">>", ">>": "<<", "&=": "|=", "|=": "&=", "<<=": ">>=", ">>=": "<<="}
_LOGIC = {"&&": "||", "||": "&&"}
_SWAPS = [("boundary", _BOUNDARY), ("arithmetic", _ARITHMETIC), ("condition", _LOGIC)]
_TEXTS = ("basic_string", "QString", "path", "QByteArray", "QStringBuilder")  # a sum of which has no difference

_NUMBER = re.compile(r"^(0[xXbB])?[0-9a-fA-F'.]+([eE][-+]?[0-9]+)?[uUlLfFzZ]*$")
_NOTHING = re.compile(r"^(\{\}|nullptr|std::nullopt|\"\"|[\w:]+\{\}|[\w:]+\(\)|(\w+)\(0(\.0)?\))$")
_ZERO = re.compile(r"^0+(\.0*)?[uUlLfF]*$")

_BODIES = {CursorKind.IF_STMT, CursorKind.FOR_STMT, CursorKind.WHILE_STMT, CursorKind.DO_STMT,
           CursorKind.CXX_FOR_RANGE_STMT, CursorKind.CASE_STMT, CursorKind.DEFAULT_STMT}
_FUNCTIONS = {CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.FUNCTION_TEMPLATE,
              CursorKind.CONVERSION_FUNCTION, CursorKind.CONSTRUCTOR, CursorKind.DESTRUCTOR}
_NO_PLACE = {CursorKind.STATIC_ASSERT}
_INTEGERS = {TypeKind.CHAR_S, TypeKind.SCHAR, TypeKind.UCHAR, TypeKind.SHORT, TypeKind.USHORT, TypeKind.INT,
             TypeKind.UINT, TypeKind.LONG, TypeKind.ULONG, TypeKind.LONGLONG, TypeKind.ULONGLONG}
_REALS = {TypeKind.FLOAT, TypeKind.DOUBLE, TypeKind.LONGDOUBLE}


def mutants_of(path: str, name: str, content: bytes, flags: list[str]) -> list[Mutant]:
    """All mutants of the file at `path`, which is called `name`, by their place. `flags` as for a compiler."""
    unit = Index.create().parse(path, args=["-x", "c++", "-w", *flags])
    finder = _Finder(name, content)
    for cursor in _children(unit.cursor):
        if cursor.location.file and cursor.location.file.name == path:
            finder.visit(cursor, None, None)
    return sorted(set(finder.found))


def _children(cursor: Cursor) -> Iterator[Cursor]:
    """Where Python's libclang knows no name of what is there, such as __builtin_bit_cast, what that holds."""
    for child in cursor.get_children():
        try:
            child.kind
        except ValueError:
            yield from _children(child)
        else:
            yield child


class _Finder:
    def __init__(self, name: str, content: bytes):
        self.name = name
        self.content = content
        self.found: list[Mutant] = []

    def visit(self, cursor: Cursor, parent: Cursor | None, function: Cursor | None) -> None:
        if cursor.kind in _NO_PLACE:
            return
        if cursor.kind in _FUNCTIONS or cursor.kind == CursorKind.LAMBDA_EXPR:
            function = cursor
        children = list(_children(cursor))
        kind = cursor.kind
        if kind in (CursorKind.BINARY_OPERATOR, CursorKind.COMPOUND_ASSIGNMENT_OPERATOR):
            self._between(cursor, children)
        elif kind == CursorKind.CALL_EXPR:
            self._overloaded(cursor, children)
        elif kind == CursorKind.UNARY_OPERATOR:
            self._unary(cursor)
        elif kind in (CursorKind.INTEGER_LITERAL, CursorKind.FLOATING_LITERAL, CursorKind.CXX_BOOL_LITERAL_EXPR):
            self._literal(cursor)
        elif kind == CursorKind.RETURN_STMT:
            self._returned(children, function)
        self._condition(cursor, children)
        self._statement(cursor, parent, children)
        for child in children:
            self.visit(child, cursor, function)

    def _text(self, cursor: Cursor) -> str:
        return self.content[cursor.extent.start.offset:cursor.extent.end.offset].decode(errors="replace")

    def _replace(self, operator: str, begin: int, end: int, replacement: str) -> None:
        self.found.append(Mutant(self.name, begin, end, replacement, operator))

    def _replace_cursor(self, operator: str, cursor: Cursor, replacement: str) -> None:
        self._replace(operator, cursor.extent.start.offset, cursor.extent.end.offset, replacement)

    def _swap(self, begin: int, end: int) -> None:
        token = self.content[begin:end].decode(errors="replace")
        for operator, swaps in _SWAPS:
            if token in swaps:
                self._replace(operator, begin, end, swaps[token])

    def _between(self, cursor: Cursor, children: list[Cursor]) -> None:
        """The sign of a built-in operator stands between its two sides."""
        if len(children) != 2:
            return
        begin = children[0].extent.end.offset
        between = self.content[begin:children[1].extent.start.offset].decode(errors="replace")
        between = re.sub(r"//[^\n]*|/\*.*?\*/", lambda m: " " * len(m.group()), between, flags=re.S)
        sign = re.search(r"[-+*/%<>=!&|^]+", between)
        if sign:
            self._swap(begin + len(between[:sign.start()].encode()), begin + len(between[:sign.end()].encode()))

    def _overloaded(self, cursor: Cursor, children: list[Cursor]) -> None:
        if not cursor.spelling.startswith("operator") or any(
                text in cursor.type.get_canonical().spelling for text in _TEXTS):
            return
        for child in children:
            sign = self._text(child)
            if child.spelling != f"operator{sign}" or sign in ("<<", ">>"):
                continue
            if child is children[0]:
                if sign == "-":  # of one side only
                    self._replace_cursor("arithmetic", child, "+")
            else:
                self._swap(child.extent.start.offset, child.extent.end.offset)

    def _unary(self, cursor: Cursor) -> None:
        begin = cursor.extent.start.offset
        sign = self.content[begin:begin + 1]
        if sign == b"-" and self.content[begin:begin + 2] != b"--":
            self._replace("arithmetic", begin, begin + 1, "+")
        elif sign == b"!":
            self._replace("condition", begin, begin + 1, "")

    def _literal(self, cursor: Cursor) -> None:
        text = self._text(cursor)
        if text in ("true", "false"):
            self._replace_cursor("constant", cursor, "false" if text == "true" else "true")
        elif _NUMBER.match(text):
            for change in ["+ 1"] if _ZERO.match(text) else ["* 2", "/ 2"]:
                self._replace_cursor("constant", cursor, f"({text} {change})")

    def _returned(self, children: list[Cursor], function: Cursor | None) -> None:
        if len(children) != 1:
            return
        text = self._text(children[0])
        of_lambda = function is None or function.kind == CursorKind.LAMBDA_EXPR
        returned = (children[0].type if of_lambda else function.result_type).get_canonical()
        if returned.kind == TypeKind.BOOL:
            if text not in ("true", "false") and not text.startswith("!"):  # else another mutant says the same
                self._replace_cursor("return", children[0], f"!({text})")
        elif returned.kind in _INTEGERS | _REALS:
            if not _NUMBER.match(text):
                self._replace_cursor("return", children[0], "0.0" if returned.kind in _REALS else "0")
        elif returned.kind == TypeKind.POINTER:
            if text != "nullptr":
                self._replace_cursor("return", children[0], "nullptr")
        elif returned.kind in (TypeKind.ENUM, TypeKind.RECORD, TypeKind.ELABORATED, TypeKind.UNEXPOSED):
            if not of_lambda and not _NOTHING.match(text):
                self._replace_cursor("return", children[0], "{}")

    def _condition(self, cursor: Cursor, children: list[Cursor]) -> None:
        condition = None
        if cursor.kind in (CursorKind.WHILE_STMT, CursorKind.CONDITIONAL_OPERATOR):
            condition = children[0] if children else None
        elif cursor.kind == CursorKind.IF_STMT:
            begins = [child for child in children if child.kind != CursorKind.DECL_STMT]
            condition = begins[0] if begins else None
        if condition is None or not (condition.kind.is_expression()):
            return
        text = self._text(condition)
        if not text.startswith("!") or condition.kind != CursorKind.UNARY_OPERATOR:
            self._replace_cursor("condition", condition, f"!({text})")

    def _statement(self, cursor: Cursor, parent: Cursor | None, children: list[Cursor]) -> None:
        if parent is None or not self._stands_alone(cursor, parent):
            return
        jumps = cursor.kind in (CursorKind.BREAK_STMT, CursorKind.CONTINUE_STMT)
        early = cursor.kind == CursorKind.RETURN_STMT and (
            not children or parent.kind in _BODIES)  # what follows then has its turn
        if (cursor.kind.is_expression() or jumps or early) and "static_cast<void>" not in self._text(cursor):
            self._replace_cursor("statement", cursor, "")

    @staticmethod
    def _stands_alone(cursor: Cursor, parent: Cursor) -> bool:
        """A statement, and not part of one."""
        if parent.kind == CursorKind.COMPOUND_STMT:
            return True
        if parent.kind not in _BODIES:
            return False
        children = list(_children(parent))
        if parent.kind == CursorKind.DO_STMT:
            return cursor == children[0]
        if parent.kind == CursorKind.IF_STMT:
            heads = [child for child in children if child.kind != CursorKind.DECL_STMT]
            return cursor in heads[1:]
        return cursor == children[-1]
