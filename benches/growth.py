# SPDX-License-Identifier: MIT OR Apache-2.0
"""Time and memory from a thousand vertices to a million, and how they grow from row to row.

Each size is measured in a process of its own, whose peak memory includes Python, numpy and the mesh's arrays.
"""

import json
import math
import os
import subprocess
import sys
import time

import boxmorph
import shapes

SIZES = (1_000, 10_000, 100_000, 300_000, 1_000_000)

#: What is measured: name, shape and whether a whole job is run.
SUBJECTS = (
    ("graph and field, chair", "grid_chair", False),
    ("graph and field, lamp", "lamp", False),
    ("whole job, chair", "grid_chair", True),
)


def measure(shape, size, whole, rounds):
    """Vertices, triangles, least seconds by the clock and of all cores together, and peak bytes."""
    vertices, triangles = getattr(shapes, shape)(size)
    mesh = boxmorph.Mesh(vertices, triangles)
    times, busy = [], []
    for _ in range(1 if whole else rounds):
        start, busy_before = time.perf_counter(), time.process_time()
        if whole:
            job = boxmorph.Job(mesh, "a bar stool", renderer="cpu")
            job.start()
            job.join()
        else:
            boxmorph.BoxDefGraph.build(mesh, splits=4)
        times.append(time.perf_counter() - start)
        busy.append(time.process_time() - busy_before)
    return len(vertices), len(triangles), min(times), min(busy), peak_memory()


def peak_memory():
    """Most bytes that this process has held."""
    if os.path.exists("/proc/self/status"):
        # `ru_maxrss` would count what the parent held when it started this process.
        with open("/proc/self/status", encoding="ascii") as status:
            return 1024 * next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def table(rounds):
    """The table as lines of Markdown; none on Windows, which does not tell the peak."""
    if sys.platform == "win32":
        return []
    lines = [
        "| what | vertices | triangles | time | of all cores | grows as n to the | peak memory |",
        "|---|---|---|---|---|---|---|",
    ]
    for name, shape, whole in SUBJECTS:
        before = None
        for size in SIZES:
            command = [sys.executable, __file__, shape, str(size), str(int(whole)), str(rounds)]
            done = subprocess.run(command, capture_output=True, text=True, check=True)
            vertices, triangles, seconds, busy, peak = json.loads(done.stdout)
            power = ""
            if before:
                power = f"{math.log(busy / before[1]) / math.log(vertices / before[0]):.2f}"
            before = vertices, busy
            times = f"{seconds:.2f} s | {busy:.2f} s | {power}"
            lines.append(f"| {name} | {vertices:,} | {triangles:,} | {times} | {peak / 1e6:.0f} MB |")
    return lines


if __name__ == "__main__":
    print(json.dumps(measure(sys.argv[1], int(sys.argv[2]), sys.argv[3] == "1", int(sys.argv[4]))))
