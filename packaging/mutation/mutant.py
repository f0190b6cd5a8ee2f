# SPDX-License-Identifier: Apache-2.0
"""One small fault that can be put into one file."""

from __future__ import annotations

import dataclasses
import difflib
import hashlib


@dataclasses.dataclass(frozen=True, order=True)
class Mutant:
    file: str  # relative to the root
    begin: int  # bytes of the file that are replaced
    end: int
    replacement: str
    operator: str  # one of places.OPERATORS

    def applied(self, content: bytes) -> bytes:
        return content[:self.begin] + self.replacement.encode() + content[self.end:]

    def line(self, content: bytes) -> int:
        return content.count(b"\n", 0, self.begin) + 1

    def lines(self, content: bytes) -> range:
        """All the lines of the file that it replaces something in."""
        return range(self.line(content), content.count(b"\n", 0, max(self.begin, self.end - 1)) + 2)

    def difference(self, content: bytes) -> tuple[str, ...]:
        """The lines taken away, with "- " before them, then those put there, with "+ "; without indentation."""
        before = content.decode().splitlines()
        after = self.applied(content).decode().splitlines()
        return tuple(f"{line[0]} {line[1:].strip()}"
                     for line in difflib.unified_diff(before, after, n=0, lineterm="")
                     if line[0] in "-+" and line[1:].strip() and not line.startswith(("---", "+++")))

    def shown(self, content: bytes) -> dict:
        """What a person is shown of it."""
        return {"file": self.file, "line": self.line(content), "operator": self.operator,
                "difference": self.difference(content)}

    def key(self, content: bytes) -> str:
        """Names it for ever: the same fault in the same file."""
        place = f"{self.file}:{self.begin}:{self.end}:{self.replacement}:"
        return hashlib.sha256(place.encode() + content).hexdigest()[:24]
