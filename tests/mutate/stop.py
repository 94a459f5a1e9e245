#!/usr/bin/env python3
"""How long each command goes on after Ctrl-C.

    tests/mutate/stop.py FEEDSCOPE [--lines N] [--instants K] [--seed S] [--only CASE] [--stacks]

Runs every model and command on large programs (N lines, 300000) once to its end or for a minute, then K times (5) with a
SIGINT at a random instant of that time, and prints the largest time to the end of the process, of clock or processor, which
is less: the machine may be busy. An end takes at most a second.
One of more than 0.8 s means that a loop does not look for a stop and the program was ended with all its threads (app/watch.h):
then `own` is not "yes". With --stacks gdb says where it was. The exit code is 1 where a command took longer than a second or
did not say by its exit code that it was interrupted.
"""

import argparse
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time

PROJECT = pathlib.Path(__file__).resolve().parents[2]
LONGEST_RUN = 60
MOST_SECONDS = 1.0
OF_ITS_OWN = 0.8
INTERRUPTED = 130
MODELS = ["cam", "essid", "gassara", "tapie", "msaddek", "ward", "linuxcnc", "grbl", "klipper", "optimal"]
FIVE_AXIS = ["--machine", "five-axis-table-ac", "--set", "tool_length_mm=100", "--set", "part_zero_x_mm=150", "--set",
             "part_zero_y_mm=-120", "--set", "part_zero_z_mm=-300"]
DRIVES = [part for axis in "XYZ" for part in ("--set", f"{axis}.kv=60")]


def surface(lines):
    yield "G17 G21 G90 G94\nG0 X0 Y0 Z10\nG1 Z0 F6000\n"
    for i in range(lines):
        row, along = divmod(i, 500)
        x = 0.2 * (along if row % 2 == 0 else 499 - along)
        yield f"X{x:.3f} Y{0.2 * row + 0.05 * math.sin(x):.3f} Z{8 * math.sin(x / 13) * math.cos(row / 85) + 0.3 * math.sin(x / 1.7):.3f}\n"


def arcs(lines):
    yield "G17 G21 G90 G94\nG0 X0 Y0 Z0\nG1 X0.1 F6000\n"
    for i in range(lines // 2):
        x = 20 * (i % 50)
        yield f"G2 X{x + 10.1:.3f} Y{i // 50:.3f} R5.{i % 7}\nG1 X{x + 20.1:.3f} Y{(i + 1) // 50:.3f}\n"


def spiral(lines):
    """One smooth path without a stop."""
    yield "G17 G21 G90 G94\nG0 X10 Y0 Z0\nG1 X10.01 F6000\n"
    for i in range(1, lines):
        yield f"X{(10 + 1e-4 * i) * math.cos(0.01 * i):.5f} Y{(10 + 1e-4 * i) * math.sin(0.01 * i):.5f}\n"


def five_axes(lines):
    yield "G17 G21 G90 G94\nG0 X0 Y0 Z20\nG43.4 H1 Z0 A0 C0\nG1 F3000\n"
    for i in range(lines):
        yield f"X{40 * math.sin(i / 300):.3f} Y{0.001 * i:.3f} A{20 * math.sin(i / 170):.4f} C{90 * math.sin(i / 410):.4f}\n"


def splines(lines):
    yield "G17 G21 G90 G94 F3000\nG0 X0 Y0\n"
    for i in range(lines // 4):
        yield f"G5 X{10 * (i + 1) % 900} Y{i // 90} I3 J{2 + i % 5} P-3 Q-{1 + i % 3}\n"


def pecks(lines):
    yield "G17 G21 G90 G94 F300\nG0 X0 Y0 Z5\nG83 X0 Y0 Z-20 R2 Q1\n"
    for i in range(lines // 20):
        yield f"X{i % 300} Y{i // 300}\n"
    yield "G80\n"


def loop(lines):
    yield f"G17 G21 G90 G94 F3000\n#1=0\nWHILE [#1 LT {lines}] DO1\nG1 X[SIN[#1]*20] Y[#1/100]\n#1=#1+1\nEND1\nM30\n"


PROGRAMS = {"surface": surface, "arcs": arcs, "spiral": spiral, "five_axes": five_axes, "splines": splines, "pecks": pecks, "loop": loop}


def cases():
    """Names and arguments; a word PROGRAM.nc is the file of that program."""
    named = {f"check {program}": ["check", f"{program}.nc"] for program in PROGRAMS}
    for model in MODELS:
        for program in ("surface", "arcs", "spiral"):
            named[f"{model} {program}"] = ["simulate", f"{program}.nc", "--model", model]
    for model in ("essid", "gassara", "msaddek", "ward", "optimal", "linuxcnc"):
        named[f"{model} five_axes"] = ["simulate", "five_axes.nc", "--model", model, *FIVE_AXIS]
    named["check on a machine"] = ["check", "five_axes.nc", "--machine", "five-axis-table-ac"]
    for model in ("essid", "ward", "linuxcnc", "klipper"):
        named[f"{model} splines"] = ["simulate", "splines.nc", "--dialect", "linuxcnc", "--model", model]
    named["essid pecks"] = ["simulate", "pecks.nc", "--model", "essid"]
    for model in ("essid", "msaddek", "ward"):
        named[f"{model} compressor"] = ["simulate", "spiral.nc", "--model", model, "--set", "compressor=on"]
    named["optimal jerk"] = ["simulate", "surface.nc", "--model", "optimal", "--set", "jerk=on"]
    named["optimal of ward"] = ["simulate", "surface.nc", "--model", "optimal", "--set", "path=ward"]
    named["ward not enforced"] = ["simulate", "spiral.nc", "--model", "ward", "--set", "enforce=off"]
    named["drives"] = ["simulate", "surface.nc", "--model", "essid", *DRIVES, "--contour", "places.csv"]
    named["csv"] = ["simulate", "surface.nc", "--model", "essid", "--csv", "out.csv"]
    named["blends"] = ["simulate", "surface.nc", "--model", "ward", "--blends", "out.csv", "--json", "out.json"]
    named["explain"] = ["explain", "surface.nc", "--model", "essid"]
    named["explain five_axes"] = ["explain", "five_axes.nc", "--model", "essid", *FIVE_AXIS]
    named["compare"] = ["compare", "surface.nc", "--json", "out.json"]
    named["sweep"] = ["compare", "surface.nc", "--model", "essid", "--sweep", "tolerance=0.005:0.1:log6", "--png", "out.png"]
    named["versions"] = ["compare", "surface.nc", "arcs.nc", "--model", "essid"]
    named["circles"] = ["circular", "arcs.nc", "--model", "essid"]
    for view in ("3d", "charts", "window"):
        named[f"render {view}"] = ["render", "surface.nc", "--model", "essid", "--view", view, "--out", "out.png"]
    named["render five_axes"] = ["render", "five_axes.nc", "--model", "essid", *FIVE_AXIS, "--out", "out.png"]
    named["report"] = ["report", "surface.nc", "--model", "essid", "--out", "out.pdf"]
    named["report of drives"] = ["report", "surface.nc", "--model", "essid", *DRIVES, "--out", "out.html"]
    named["trace"] = ["trace", "trace.csv", "traced.nc", "--model", "essid"]
    named["report with trace"] = ["report", "traced.nc", "--model", "essid", "--trace", "trace.csv", "--out", "out.html"]
    named["identify"] = ["identify", "trace.csv", "--program", "traced.nc", "--model", "essid", "--out", "out.toml"]
    named["identify linuxcnc"] = ["identify", "trace.csv", "--program", "traced.nc", "--model", "linuxcnc", "--out", "out.toml"]
    named["identify drives"] = ["identify", "trace.csv", "--program", "traced.nc", "--model", "essid", "--fit", "X.kv,Y.kv", "--out",
                                "out.toml"]
    return named


def write_inputs(folder, feedscope, lines):
    for name, program in PROGRAMS.items():
        (folder / f"{name}.nc").write_text("".join(program(lines)))
    (folder / "traced.nc").write_text("".join(surface(lines // 30)))
    subprocess.run([feedscope, "simulate", "traced.nc", "--model", "essid", *DRIVES, "--csv", "trace.csv", "--step", "0.01"], cwd=folder,
                   check=True, capture_output=True)


def start(feedscope, arguments, folder):
    return subprocess.Popen([feedscope, *arguments], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                            stderr=subprocess.DEVNULL)


def time_of(feedscope, arguments, folder):
    """Of a whole run, LONGEST_RUN at most [s]."""
    begin = time.monotonic()
    process = start(feedscope, arguments, folder)
    try:
        process.wait(LONGEST_RUN)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    return time.monotonic() - begin


def processor_time(process):
    """Of a process that lives [s]."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def processor_time_of_ended():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def stack(process):
    """The functions of this project that the threads are in."""
    done = subprocess.run(["gdb", "-p", str(process.pid), "-batch", "-ex", "thread apply all bt 25"], capture_output=True, text=True,
                          check=False)
    lines = [line for line in done.stdout.splitlines() if line.startswith("#") and "Watch" not in line]
    return "\n".join("    " + line[:160] for line in lines)


def interrupted(feedscope, arguments, folder, instant, stacks):
    """Time to the end and exit code after a SIGINT at `instant`; None where it had ended before. And a stack, if it took long."""
    before = processor_time_of_ended()
    process = start(feedscope, arguments, folder)
    where = ""
    try:
        process.wait(instant)
        return None
    except subprocess.TimeoutExpired:
        used = processor_time(process)
        process.send_signal(signal.SIGINT)
    begin = time.monotonic()
    if stacks:
        try:
            process.wait(0.4)
        except subprocess.TimeoutExpired:
            where = stack(process)
    try:
        process.wait(30)
    except subprocess.TimeoutExpired:
        process.kill()
        process.wait()
    clock = time.monotonic() - begin
    return min(clock, processor_time_of_ended() - before - used), process.returncode, where


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("feedscope", type=pathlib.Path)
    options.add_argument("--lines", type=int, default=300_000)
    options.add_argument("--instants", type=int, default=5)
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--only", default="", help="cases that contain this")
    options.add_argument("--stacks", action="store_true")
    asked = options.parse_args()
    feedscope = asked.feedscope.resolve()
    late = 0
    with tempfile.TemporaryDirectory(prefix="feedscope-stop-") as name:
        folder = pathlib.Path(name)
        write_inputs(folder, feedscope, asked.lines)
        print(f"{'case':24} {'run [s]':>8} {'to the end [s]':>14}  own")
        for case, arguments in cases().items():
            if asked.only not in case:
                continue
            whole = time_of(feedscope, arguments, folder)
            rng = random.Random(f"{asked.seed} {case}")
            worst, right, where = 0.0, True, ""
            for _ in range(asked.instants):
                ended = interrupted(feedscope, arguments, folder, rng.uniform(0.02, whole), asked.stacks)
                if ended is None:
                    continue
                right = right and ended[1] in (INTERRUPTED, -signal.SIGINT)
                if ended[0] > worst:
                    worst, where = ended[0], ended[2]
            wrong = not right or worst > MOST_SECONDS
            late += wrong
            print(f"{case:24} {whole:8.1f} {worst:14.2f}  {'yes' if worst < OF_ITS_OWN else 'no'}{'  LATE' if wrong else ''}", flush=True)
            if where:
                print(where)
    sys.exit(1 if late else 0)


if __name__ == "__main__":
    main()
