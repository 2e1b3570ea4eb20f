# SPDX-License-Identifier: MIT OR Apache-2.0
"""How long things take, in seconds."""

import time


def best_of(rounds, work):
    """Least seconds of `rounds` calls, after one that is not counted."""
    return interleaved(rounds, {"": work})[""]


def interleaved(rounds, works):
    """Least seconds of each of `works`, called in turn so that what else the machine does meets all alike."""
    for work in works.values():
        work()
    least = dict.fromkeys(works, float("inf"))
    for _ in range(rounds):
        for name, work in works.items():
            start = time.perf_counter()
            work()
            least[name] = min(least[name], time.perf_counter() - start)
    return least
