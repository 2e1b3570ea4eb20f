# SPDX-License-Identifier: MIT OR Apache-2.0
"""The machine that is measured: what it is, and what its memory can do."""

import os
import platform

import boxmorph
import numpy as np
from timing import best_of


def description():
    """Processor, memory and versions in a line."""
    return (
        f"Machine: {processor()}, {os.cpu_count()} cores, {memory()}, {platform.system()}, "
        f"{platform.machine()}, boxmorph {boxmorph.__version__}, Python {platform.python_version()}, "
        f"numpy {np.__version__}"
    )


def processor():
    """Its name, as far as the system tells."""
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            return next(line.split(":", 1)[1].strip() for line in file if line.startswith("model name"))
    except (OSError, StopIteration):
        return platform.processor() or "unknown processor"


def memory():
    """Its size."""
    try:
        size = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")
    except (AttributeError, ValueError, OSError):
        return "memory unknown"
    return f"{size / 2**30:.0f} GiB"


def memory_bandwidth():
    """Bytes a second of a large copy, read and written."""
    source = np.ones(32_000_000, np.float32)
    target = np.empty_like(source)
    return 2 * source.nbytes / best_of(5, lambda: np.copyto(target, source))
