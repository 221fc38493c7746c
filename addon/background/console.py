# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The terminal side of a render: quiet standard output, progress, interruption."""

from __future__ import annotations

import contextlib
import ctypes
import os
import re
import shutil
import signal
import sys
import tempfile
import threading
from collections.abc import Callable, Iterator
from typing import TextIO

import bpy

_SHADER = re.compile(
    r"Failed parse of .*OSO|Unable to (?:parse|open).* shader|Could not find shader|OSL query error"
)
_REPORT = "NACRE_REPORT_FD"
_SAMPLES = re.compile(r"Sample (\d+)/(\d+)")


@contextlib.contextmanager
def own_stdout(verbose: bool) -> Iterator[TextIO]:
    """Yields the real standard output, or that which the tool has put aside, while Blender's own chatter
    goes elsewhere.

    Blender writes from C++, so the file descriptor itself is turned aside: to standard error when
    verbose, else to nowhere.
    """
    _flush()
    kept = os.dup(1)
    aside = os.dup(2) if verbose else os.open(os.devnull, os.O_WRONLY)
    os.dup2(aside, 1)
    os.close(aside)
    try:
        report = int(os.environ.pop(_REPORT, kept))  # not for what Blender starts in turn
        with os.fdopen(os.dup(report), "w", encoding="utf-8") as stream:
            yield stream
    finally:
        _flush()
        os.dup2(kept, 1)
        os.close(kept)


def _flush() -> None:
    """Python's buffer and that of C, which Blender prints through: into a pipe it writes late."""
    sys.stdout.flush()
    with contextlib.suppress(OSError, TypeError, AttributeError):  # where C's is not to be had so
        ctypes.CDLL(None).fflush(None)


def mute_removed_engine_noise() -> None:
    """Drops the harmless complaint of Cycles about its engine object when the interpreter ends."""
    previous = sys.unraisablehook

    def hook(report: sys.UnraisableHookArgs) -> None:
        if not isinstance(report.exc_value, ReferenceError):
            previous(report)

    sys.unraisablehook = hook


class Complaints:
    """What is written to standard error by C++ meanwhile; it is passed on when that has ended, if quiet
    only where it tells why there is no picture. Python's own goes on to be written at once."""

    def __init__(self, quiet: bool) -> None:
        self.text = ""
        self._quiet = quiet

    def __enter__(self) -> Complaints:
        _flush()
        sys.stderr.flush()
        self._kept = os.dup(2)
        self._python = sys.stderr
        sys.stderr = os.fdopen(os.dup(2), "w", encoding="utf-8", errors="backslashreplace")
        self._file = tempfile.TemporaryFile()
        os.dup2(self._file.fileno(), 2)
        return self

    @property
    def of_shaders(self) -> list[str]:
        """Shaders that Cycles could not load, after which it renders black and says that all is well."""
        lines = self.text.splitlines()
        return list(dict.fromkeys(" ".join(line.split()) for line in lines if _SHADER.search(line)))

    def __exit__(self, error: object, *_: object) -> None:
        _flush()
        sys.stderr.close()
        sys.stderr = self._python
        os.dup2(self._kept, 2)
        os.close(self._kept)
        self._file.seek(0)
        written = self._file.read()
        self._file.close()
        self.text = written.decode("utf-8", "replace")
        if error is not None or self.of_shaders or not self._quiet:
            with contextlib.suppress(OSError):
                os.write(2, written)


class Progress:
    """One line on a terminal, rewritten as samples come in; silent in a pipe."""

    def __init__(self, label: str, quiet: bool):
        self.label = label
        self._shown = not quiet and sys.stderr.isatty()

    def __enter__(self) -> Progress:
        if self._shown:
            bpy.app.handlers.render_stats.append(self._update)
        return self

    def __exit__(self, *_: object) -> None:
        if self._shown:
            bpy.app.handlers.render_stats.remove(self._update)
            print("\r\033[K", end="", file=sys.stderr, flush=True)

    def _update(self, stats: object, *_: object) -> None:
        match = _SAMPLES.search(str(stats))
        if match:
            done, total = map(int, match.groups())
            bar = "#" * (24 * done // max(total, 1))
            line = f"\r{self.label} [{bar:<24}] sample {done} of {total}\033[K"
            print(line, end="", file=sys.stderr, flush=True)


@contextlib.contextmanager
def stop_on_signals(clean_up: Callable[[], None]) -> Iterator[None]:
    """Ends the process at SIGINT and SIGTERM, even in the middle of a render.

    Python runs its handlers between two bytecodes of the main thread, which a render does not reach
    for minutes. So a thread waits for the signal's number on a pipe; Cycles lets go of the
    interpreter while it renders.
    """
    if threading.current_thread() is not threading.main_thread():
        yield
        return
    reading, writing = os.pipe()
    os.set_blocking(writing, False)

    def wait() -> None:
        number = os.read(reading, 1)
        if number in (bytes([signal.SIGINT]), bytes([signal.SIGTERM])):
            clean_up()
            shutil.rmtree(bpy.app.tempdir, ignore_errors=True)
            print(f"\nnacre render: stopped by {signal.Signals(number[0]).name}", file=sys.stderr)
            sys.stderr.flush()
            os._exit(128 + number[0])

    handlers = {n: signal.signal(n, lambda *_: None) for n in (signal.SIGINT, signal.SIGTERM)}
    previous_fd = signal.set_wakeup_fd(writing)
    watcher = threading.Thread(target=wait, name="nacre-signals", daemon=True)
    watcher.start()
    try:
        yield
    finally:
        signal.set_wakeup_fd(previous_fd)
        for number, handler in handlers.items():
            signal.signal(number, handler if handler is not None else signal.SIG_DFL)
        os.write(writing, b"\0")
        watcher.join()
        os.close(reading)
        os.close(writing)
