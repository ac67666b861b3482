"""The exceptions and warnings of gonio."""

from __future__ import annotations

TYPE_CHECKING = False  # type checkers take it as true; importing typing takes as long as all of gonio
if TYPE_CHECKING:
    from typing import List

    from ._gonio import Diagnostic


class Error(ValueError):
    """What failed, in the words of the command-line tool.

    `diagnostics` lists everything that was found up to the failure. Its last error is the reason, and `code`,
    `message`, `hint`, `file`, `line` and `column` are those of the reason.
    """

    def __init__(self, diagnostics: List[Diagnostic]) -> None:
        self.diagnostics: List[Diagnostic] = list(diagnostics)
        errors = [d for d in self.diagnostics if d.severity == "error"]
        reason = errors[-1] if errors else self.diagnostics[-1]
        super().__init__(str(reason))
        self.code: str = reason.code
        self.message: str = reason.message
        self.hint: str = reason.hint
        self.file: str = reason.file
        self.line: int = reason.line
        self.column: int = reason.column


class FileError(Error, OSError):
    """The system refused: no such file, no permission, a full disk."""


class UnsupportedError(Error, NotImplementedError):
    """The input is valid, but gonio cannot do this with it."""


class DiagnosticWarning(UserWarning):
    """A warning of a call that has no list of diagnostics in its result."""
