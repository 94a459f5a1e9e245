#!/usr/bin/env python3
"""Random programs on LinuxCNC and on its model: random_oracle.py FEEDSCOPE [COUNT] [SEED] [--record FILE] [--keep FOLDER]

Prints by kind of program how many last as long as on the control. The time of a program is the number of servo periods from the
first to the last one at whose end the planner moves, on both sides. --record writes programs with these numbers, for the test
that needs no control. --keep leaves programs, machines and traces in FOLDER and takes traces from there that exist already.
The control is no real-time system here and loses periods, many where the machine is busy or this runs at low priority:
where it differs the program is run again, up to three times, and the nearest time counts.
Exit code 77: there is no LinuxCNC; 1: a program of a kind that the model does not leave out
lasts longer or shorter by more than 1 ms, a servo period and 1e-4 of its time.
"""

import argparse
import concurrent.futures
import csv
import io
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

import random_programs

HERE = pathlib.Path(__file__).resolve().parent
BATCH = 65  # programs that one start of the control runs
REPEATS = 3  # of programs that differ
MOVING = 1e-3  # mm/s
NO_LINUXCNC = 77
LEFT_OUT = {"waits", "rotary alone"}  # of which core/models/linuxcnc/README.md says what the model leaves out


def batch_text(programs):
    """One program of all, each with its number in the analog output 0 while it runs, from a place of rest called zero."""
    parts = []
    for number, program in enumerate(programs, 1):
        parts += ["G21 G17 G90 G94 G40 G80 G61", "M5", "M9", "G92 X0 Y0 Z0 A0 C0", f"M68 E0 Q{number}", "G4 P0.03"]
        parts += program.lines + ["M68 E0 Q0"]
    return "\n".join(parts) + "\nM2\n"


def alone_text(program):
    return "\n".join(["G21 G17 G90 G94"] + program.lines + ["M2"]) + "\n"


def is_accepted(program, folder):
    """Whether the control's interpreter reads it without an error."""
    file = folder / "accepted.ngc"
    file.write_text(alone_text(program))
    done = subprocess.run(["rs274", "-g", file], capture_output=True, text=True, check=False, cwd=folder,
                          env=dict(os.environ, HOME=str(folder)))  # where it keeps a file of its own
    return done.returncode == 0 and "PROGRAM_END" in done.stdout


def periods_of_control(trace, count):
    """By program, the periods between the first and the last one that moves."""
    first, last = {}, {}
    for index, line in enumerate(trace.open()):
        words = line.split()
        if len(words) != 6:
            sys.exit(f"{trace}: periods were lost: {line}")
        part = int(float(words[5]))
        if part > 0 and float(words[3]) > MOVING:
            first.setdefault(part, index)
            last[part] = index
    return [last[part] - first[part] + 1 if part in first else 0 for part in range(1, count + 1)]


def run_control(folder, machine, programs):
    """The periods of the programs, which are run in one go."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "random.ini").write_text(machine.ini("./record.py", "random.hal"))
    shutil.copy(HERE / "random.hal", folder)
    (folder / "batch.ngc").write_text(batch_text(programs))
    trace = folder / "trace"
    for _ in range(1 if trace.exists() else 2):  # the control does not always start
        if not trace.exists():
            code = subprocess.run([HERE / "run_linuxcnc", folder / "random.ini", trace, folder / "batch.ngc"], check=False,
                                  env=dict(os.environ, FEEDSCOPE_LONGEST_S=str(5 * len(programs) + 60))).returncode
            if code == NO_LINUXCNC:
                sys.exit(code)
    if not trace.exists():
        sys.exit(f"{folder}: LinuxCNC does not run these programs")
    return periods_of_control(trace, len(programs))


def is_near(error, time, period):
    """Whether a difference [s] is one of rounding."""
    return abs(error) <= 1.001 * max(1e-3, period, 1e-4 * time)


def periods_of_model(feedscope, folder, program, number, period):
    file = folder / f"{number}.ngc"
    file.write_text(alone_text(program))
    places = [word for axis in "xyz" for word in ("--set", f"part_zero_{axis}_mm=0")]
    done = subprocess.run([feedscope, "simulate", file, "--dialect", "linuxcnc", "--machine", folder / "machine.toml", "--model",
                           "linuxcnc", *places, "--csv", "-", "--step", str(period)], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"{file}: {done.stderr or done.stdout}", file=sys.stderr)
        return None
    rows = list(csv.DictReader(io.StringIO(done.stdout)))[:-1]
    moving = [index for index, row in enumerate(rows) if float(row["feed_mm_min"]) / 60 > MOVING]
    return moving[-1] - moving[0] + 1 if moving else 0


def run_batch(feedscope, folder, seed, count):
    """Machine, programs and the periods of control and model."""
    folder.mkdir(parents=True, exist_ok=True)
    machine = random_programs.machine(seed)
    programs = [p for p in random_programs.programs(seed, count, machine) if is_accepted(p, folder)]
    control = run_control(folder, machine, programs)
    subprocess.run([feedscope, "machines", "import", folder / "random.ini", "--out", folder / "machine.toml"], check=True,
                   capture_output=True)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        period = machine.period_ns * 1e-9
        model = list(pool.map(lambda i: periods_of_model(feedscope, folder, programs[i], i + 1, period), range(len(programs))))
    for repeat in range(1, REPEATS + 1):
        differ = [i for i, ours in enumerate(model)
                  if ours is not None and not is_near((ours - control[i]) * period, control[i] * period, period)]
        if differ:
            for i, again in zip(differ, run_control(folder / f"again{repeat}", machine, [programs[i] for i in differ])):
                control[i] = min(control[i], again, key=lambda theirs: abs(theirs - model[i]))
    return machine, programs, control, model


class Table:
    """Counts by kind of program."""

    def __init__(self):
        self.rows = {}

    def add(self, kind, error, time, period):
        row = self.rows.setdefault(kind, [0, 0, 0, 0, 0.0])
        near = is_near(error, time, period)
        for column, holds in enumerate((True, abs(error) <= 1.001e-3, abs(error) <= 1e-4 * time, near)):
            row[column] += holds
        row[4] = max(row[4], abs(error))
        return near

    def text(self):
        lines = [f"{'kind':18} {'programs':>9} {'1 ms':>7} {'1e-4':>7} {'near':>7} {'largest':>11}"]
        total = [sum(row[i] for row in self.rows.values()) for i in range(4)] + [max(row[4] for row in self.rows.values())]
        for kind, row in [*self.rows.items(), ("all", total)]:
            lines.append(f"{kind:18} {row[0]:9} {row[1]:7} {row[2]:7} {row[3]:7} {1e3 * row[4]:8.1f} ms")
        return "\n".join(lines)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("feedscope", type=pathlib.Path)
    parser.add_argument("count", type=int, nargs="?", default=1000)
    parser.add_argument("seed", type=int, nargs="?", default=1)
    parser.add_argument("--record", type=argparse.FileType("w"))
    parser.add_argument("--keep", type=pathlib.Path)
    asked = parser.parse_args()
    if shutil.which("linuxcnc") is None:
        print("LinuxCNC is not installed: packaging/oracle installs it")
        sys.exit(NO_LINUXCNC)
    table, differ = Table(), []
    with tempfile.TemporaryDirectory() as scratch:
        for batch in range(0, asked.count, BATCH):
            seed = asked.seed + batch // BATCH
            folder = (asked.keep or pathlib.Path(scratch)).resolve() / str(seed)
            machine, programs, control, model = run_batch(asked.feedscope.resolve(), folder, seed, min(BATCH, asked.count - batch))
            period = machine.period_ns * 1e-9
            for number, (program, theirs, ours) in enumerate(zip(programs, control, model), 1):
                error = float("inf") if ours is None else (ours - theirs) * period
                if not table.add(program.kind, error, theirs * period, period) and program.kind not in LEFT_OUT:
                    differ.append(f"{seed}/{number} {program.kind}: {theirs * period:.4f} s, the model {1e3 * error:+.1f} ms")
            if asked.record:
                record(asked.record, machine, programs, control)
    print("\n".join(differ))
    print(table.text())
    sys.exit(1 if differ else 0)


def record(out, machine, programs, control):
    limits = [machine.period_ns * 1e-9, machine.max_velocity, machine.override]
    for axes in (machine.velocity, machine.acceleration):
        limits += [axes[axis] for axis in random_programs.LINEAR + random_programs.ROTARY]
    out.write("machine " + " ".join(f"{value:g}" for value in limits) + "\n")
    for program, periods in zip(programs, control):
        out.write(f"program {periods} {program.kind}\n" + "\n".join(program.lines) + "\n")


main()
