#!/usr/bin/env python3
"""Random contours with cutter compensation, read by LinuxCNC's interpreter and by Feedscope: random_contours.py FEEDSCOPE [COUNT] [FIRST]

Both must refuse the contour, or have the same path of the tool: the same length, and the same places along it within what the four
decimals of rs274 leave. Prints how many do and each that does not; exit code 77: there is no rs274, 1: a contour differs.
"""

import argparse
import collections
import concurrent.futures
import csv
import io
import json
import math
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

import random_programs

NO_LINUXCNC = 77
SAME_MM = 5e-3
FEED = 100  # mm/s


def contour(seed):
    """Lines and arcs, some smaller than the tool; half of them have joints as tangential as three decimals allow."""
    rng = random.Random(f"contour {seed}")
    diameter = random_programs.rounded(random_programs.logarithmic(rng, 0.5, 6), 3)
    pen = random_programs.Pen(rng, random_programs.machine(1))
    pen.feed, smooth = FEED, rng.random() < 0.5
    pen.line(2 * diameter)
    entry = pen.lines.pop()
    for _ in range(rng.randint(3, 8)):
        if not smooth or rng.random() < 0.2:
            pen.turn(2, 150)
        if rng.random() < 0.5:
            least = 0.1 if rng.random() < 0.15 else 0.55
            pen.arc(diameter * random_programs.logarithmic(rng, least, 4), rng.choice([-1, 1]) * math.radians(rng.uniform(10, 300)))
        else:
            pen.line(diameter * random_programs.logarithmic(rng, 0.3, 6))
    pen.lines.append("G40")
    pen.line(2 * diameter)
    lines = ["G21 G17 G90 G94 G64", f"{rng.choice(['G41.1', 'G42.1'])} D{diameter}", entry] + pen.lines + ["M2"]
    if smooth:
        lines = [re.sub(r"([XYIJ])(-?\d+\.\d+)", lambda word: word[1] + f"{float(word[2]):.3f}", line) for line in lines]
    return "\n".join(lines) + "\n"


def path_of_control(text):
    """Lines (from, to) and arcs (from, to, centre, sweep) of what rs274 prints."""
    place, path = (0.0, 0.0), []
    for name, words in re.findall(r"(STRAIGHT_FEED|STRAIGHT_TRAVERSE|ARC_FEED)\((.*)\)", text):
        values = [float(word) for word in words.split(",")]
        end = (values[0], values[1])
        if name != "ARC_FEED":
            path.append((place, end))
        else:
            center, turn = (values[2], values[3]), values[4]
            angles = [math.atan2(p[1] - center[1], p[0] - center[0]) for p in (place, end)]
            sweep = math.copysign((math.copysign(1, turn) * (angles[1] - angles[0])) % (2 * math.pi), turn)
            path.append((place, end, center, sweep))
        place = end
    return path


def length(element):
    if len(element) == 2:
        return math.dist(*element)
    radii = [math.dist(point, element[2]) for point in element[:2]]
    return math.hypot(sum(radii) / 2 * element[3], radii[1] - radii[0])


def place_at(path, way):
    for element in path[:-1]:
        if way <= length(element):
            break
        way -= length(element)
    else:
        element = path[-1]
    share = min(way / length(element), 1) if length(element) > 0 else 1
    start, end = element[:2]
    if len(element) == 2:
        return tuple(a + share * (b - a) for a, b in zip(start, end))
    center, sweep = element[2:]
    radii = [math.dist(point, center) for point in (start, end)]
    angle = math.atan2(start[1] - center[1], start[0] - center[0]) + share * sweep
    radius = radii[0] + share * (radii[1] - radii[0])
    return center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)


def compare(feedscope, seed, folder):
    """A word for the outcome, and details where it is a difference."""
    home = folder / str(seed)  # rs274 keeps a file of its own there
    home.mkdir(exist_ok=True)
    file = home / "contour.ngc"
    file.write_text(contour(seed))
    control = subprocess.run(["rs274", "-g", file], capture_output=True, text=True, check=False, cwd=home,
                             env=dict(os.environ, HOME=str(home)))
    refused = "PROGRAM_END" not in control.stdout
    arguments = ["--dialect", "linuxcnc", "--machine", "linuxcnc-mill", "--model", "cam"]
    arguments += [word for axis in "xyz" for word in ("--set", f"part_zero_{axis}_mm=0")]
    details = home / "details.json"
    ours = subprocess.run([feedscope, "simulate", file, *arguments, "--csv", "-", "--step", "0.01", "--json", details],
                          capture_output=True, text=True, check=False)
    wrong = [d["message"] for d in json.loads(details.read_text())["diagnostics"] if d["severity"] == "error"]
    if refused or wrong:
        reason = control.stderr.strip().splitlines()[-2:] if refused else ""
        return ("refused by both", "") if refused and wrong else ("refused by one", f"control {reason}, Feedscope {wrong}")
    path = path_of_control(control.stdout)
    rows = list(csv.DictReader(io.StringIO(ours.stdout)))
    excess = float(rows[-1]["path_mm"]) - sum(map(length, path))
    off = max(math.dist(place_at(path, float(row["path_mm"])), (float(row["x_mm"]), float(row["y_mm"]))) for row in rows)
    same = abs(excess) < SAME_MM and off < SAME_MM
    return ("same path", "") if same else ("other path", f"{excess:+.4f} mm longer, {off:.4f} mm away")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("feedscope", type=pathlib.Path)
    parser.add_argument("count", type=int, nargs="?", default=1000)
    parser.add_argument("first", type=int, nargs="?", default=0)
    parser.add_argument("--keep", type=pathlib.Path)
    asked = parser.parse_args()
    if shutil.which("rs274") is None:
        print("LinuxCNC is not installed: packaging/oracle installs it")
        sys.exit(NO_LINUXCNC)
    counts = collections.Counter()
    with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = (asked.keep or pathlib.Path(scratch)).resolve()
        folder.mkdir(exist_ok=True)
        seeds = range(asked.first, asked.first + asked.count)
        for seed, (outcome, text) in zip(seeds, pool.map(lambda s: compare(asked.feedscope.resolve(), s, folder), seeds)):
            counts[outcome] += 1
            if text:
                print(f"contour {seed}: {outcome}, {text}")
    print("\n".join(f"{outcome:16} {count:6}" for outcome, count in sorted(counts.items())))
    sys.exit(1 if counts["refused by one"] + counts["other path"] > 0 else 0)


main()
