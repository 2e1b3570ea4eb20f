# SPDX-License-Identifier: MIT OR Apache-2.0
"""Measures the stages of a search in one run, each beside a limit or a peer, and how time and memory
grow with the mesh; prints both tables.

Usage: python benches/bench.py [--rounds N] [--record]
"""

import argparse
import json
import pathlib
import subprocess

import growth
import machine
import results
import stages

ROOT = pathlib.Path(__file__).resolve().parent.parent
#: Where `make bench` puts the peers.
PEERS = ROOT / "benches" / ".venv" / "bin" / "python"
#: CLIP's architecture with random weights, made on first use.
CLIP = ROOT / "build" / "clip-vit-b-32"


def peer_rows(rounds):
    """Rows that set ours beside pycma and PyTorch; where they are missing or fail, a row that says so."""
    if not PEERS.exists():
        yield "peers", "not measured", "PyTorch and pycma are not installed: `make benches/.venv/.wheel`", ""
        return
    commands = [["benches/cmaes.py", "--time"], ["benches/peers.py", str(CLIP), "--rounds", str(rounds)]]
    if not (CLIP / "config.json").exists():
        commands.insert(1, ["tests/python/random_clip.py", str(CLIP)])
    for command in commands:
        done = subprocess.run([str(PEERS), *command], cwd=ROOT, capture_output=True, text=True)
        yield from (json.loads(line) for line in done.stdout.splitlines() if line.startswith("["))
        if done.returncode:
            why = (done.stderr.strip().splitlines() or ["no message"])[-1]
            yield command[0], "not measured", why.replace("|", "/"), ""


def stage_table(rounds):
    """The table of stages as lines of Markdown, printed as it grows."""
    lines = [machine.description(), "", "| stage | figure | beside | ratio |", "|---|---|---|---|"]
    print("\n".join(lines), flush=True)
    for rows in (stages.rows(rounds), peer_rows(max(1, rounds // 2))):
        for row in rows:
            lines.append("| " + " | ".join(row) + " |")
            print(lines[-1], flush=True)
    return lines


def main():
    """Prints the tables, and keeps them where asked to."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--record", action="store_true", help="write the tables into benches/RESULTS.md")
    arguments = parser.parse_args()
    stage_lines = stage_table(arguments.rounds)
    growth_lines = growth.table(min(3, arguments.rounds))
    print("\n".join(["", *growth_lines]))
    if arguments.record:
        results.write("Stages and peers", "make bench", stage_lines)
        results.write("Growth", "make bench", growth_lines)


if __name__ == "__main__":
    main()
