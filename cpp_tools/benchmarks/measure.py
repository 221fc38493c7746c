# SPDX-FileCopyrightText: Nacre contributors
# SPDX-License-Identifier: Apache-2.0
"""What a benchmark is and how its time is taken."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import asdict, dataclass


@dataclass(frozen=True)
class Result:
    """Two costs of one job, measured in one run; less is better."""

    id: str
    what: str  # with the unit of both costs
    ours: float
    peer: float
    peer_version: str
    target: float  # least ratio

    @property
    def ratio(self) -> float:
        """How many times what we cost the peer costs."""
        return self.peer / self.ours

    def record(self) -> dict:
        met = self.ratio >= self.target
        return {**asdict(self), "ratio": self.ratio, "met": met}


def best_seconds(
    jobs: list[Callable[[], object]], repeats: int = 7, turn_seconds: float = 0.25
) -> list[float]:
    """Shortest wall time of each job.

    They take turns, so that a busy machine troubles all alike; a turn lasts `turn_seconds` or one
    run, so that a short job has as good a chance as a long one to meet a quiet moment.
    """
    best = [float("inf")] * len(jobs)
    for _ in range(repeats):
        for i, job in enumerate(jobs):
            turn = time.perf_counter()
            while True:
                start = time.perf_counter()
                job()
                now = time.perf_counter()
                best[i] = min(best[i], now - start)
                if now - turn >= turn_seconds:
                    break
    return best
