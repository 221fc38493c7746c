# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turns faults into reports."""

from __future__ import annotations

import functools

from ..core.exr import ExrError
from ..core.form import FormError
from ..core.manifest import ManifestError
from ..core.oso import OsoError
from ..core.probe import ProbeError
from ..core.stack import StackError
from ..output import OutputError

_EXPECTED = (
    ExrError,
    FormError,
    ManifestError,
    OsoError,
    OutputError,
    ProbeError,
    StackError,
    OSError,
    RuntimeError,
)


def reports_errors(execute):
    """For `execute`: an expected fault becomes an error report, and the operator cancels."""

    @functools.wraps(execute)
    def guarded(self, context):
        try:
            return execute(self, context)
        except _EXPECTED as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}

    return guarded
