# Copyright (c) 2026 The Geometric_continuity developers
#
# SPDX-License-Identifier: LGPL-3.0-or-later
"""Bad input, as an exception with its parts."""


class Error(ValueError):
    """Bad input. `code` is the name of the reason, as in C++ (`"zero_tangent"`, `"malformed_input"`, ...), `place` says where the
    input is wrong (a function, or FILE:LINE), `reason` what is wrong there."""

    def __init__(self, code: str, place: str, reason: str):
        super().__init__(code, place, reason)
        self.code = code
        self.place = place
        self.reason = reason

    def __str__(self) -> str:
        return f"{self.code}: {self.place}: {self.reason}"
