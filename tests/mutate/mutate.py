#!/usr/bin/env python3
"""Runs spoilt programs, machine files, sessions, lessons, traces and configurations through the commands.

    tests/mutate/mutate.py FEEDSCOPE [--seconds S] [--seed N] [--kinds KIND,...] [--only TRIAL] [--out FOLDER]

Every trial spoils one file of the project (of the shared corpus too, where it is there), drawn from the seed and the number
of the trial, and runs one command on it; KINDs are commands and files as the summary lists them. Each run has 40 s of processor time and 4 GB of memory. A run that crashes, reports
an internal error, runs out of its bounds, ends with a code that the handbook does not name, writes JSON that is none or
leaves a part of a file is a finding: its files stay in FOLDER (build/mutate) with the shell line that repeats it. The exit
code is 1 if there is one.
"""

import argparse
import collections
import json
import os
import pathlib
import random
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
import time

sys.dont_write_bytecode = True
import mutators

PROJECT = pathlib.Path(__file__).resolve().parents[2]
CPU_SECONDS = 40
MEMORY = 4 << 30
WALL_SECONDS = 300  # in which a run that does not wait for itself has a second of processor time, on a busy machine too
EXPECTED = (0, 1, 2)
MODELS = ["cam", "essid", "gassara", "tapie", "msaddek", "ward", "optimal", "linuxcnc", "grbl", "klipper"]
DIALECTS = ["iso", "fanuc", "linuxcnc", "grbl", "sinumerik", "heidenhain"]
SETTINGS = ["X.velocity", "Y.acceleration", "Z.jerk", "A.velocity", "C.acceleration", "contour_tolerance_mm", "lookahead_blocks",
            "interpolation_period_s", "feed_override", "compressor", "jerk", "filter_time_s", "junction_deviation_mm", "arc_tolerance_mm",
            "square_corner_velocity_mm_s", "naive_tolerance_mm", "servo_period_s", "tool_length_mm", "part_zero_z_mm", "X.kv",
            "X.backlash", "compaction_mm", "arc_resolution_mm", "max_linear_velocity_m_min", "tool_change_time_s"]
VALUES = ["0", "1e-9", "1e-6", "0.001", "0.5", "1", "3", "100", "1e5", "1e9", "-1", "on", "off"]
LINES_OF_A_PROGRAM = 250


def texts(folder, pattern="*"):
    """Files with their bytes, in the order of their names."""
    files = sorted(file for file in folder.glob(pattern) if file.is_file() and file.suffix != ".md")
    return [(file.name, file.read_bytes()) for file in files]


class Subjects:
    """The files that are spoilt, and how each is run: every method returns the arguments of a command."""

    def __init__(self, feedscope):
        self.programs = texts(PROJECT / "resources/programs")
        for folder in sorted((PROJECT / "../shared/corpus").glob("*/")):
            self.programs += texts(folder)
        self.machines = texts(PROJECT / "machines", "*.toml")
        self.lessons = texts(PROJECT / "resources/lessons", "*.toml")
        self.sessions = texts(PROJECT / "tests/ui/session/versions")
        self.loads = texts(PROJECT / "resources/examples", "*load.toml")
        self.seeds = {kind: texts(PROJECT / "tests/fuzz/seeds" / kind) for kind in ("import", "trace", "tools", "merge")}
        self.words = {file.stem: mutators.dictionary(file) for file in (PROJECT / "tests/fuzz/words").glob("*.dict")}
        self.seeds["trace"] += self.recorded(feedscope)

    @staticmethod
    def recorded(feedscope):
        """A trace as a control would write it, of the program that goes with traces."""
        with tempfile.TemporaryDirectory() as folder:
            trace = pathlib.Path(folder) / "recorded.csv"
            subprocess.run([feedscope, "simulate", PROJECT / "resources/programs/lesson_corners.nc", "--csv", trace, "--step", "0.01"],
                           check=True, capture_output=True)
            return [(trace.name, trace.read_bytes())]

    def spoil(self, folder, name, text, rng, words, others=()):
        (folder / name).write_bytes(mutators.mutated(text, rng, self.words[words], others))
        return name

    def spoilt_program(self, rng, folder):
        name, text = rng.choice(self.programs)
        others = [other for _, other in rng.sample(self.programs, 3)]
        return self.spoil(folder, name, mutators.piece(text, rng, LINES_OF_A_PROGRAM), rng, "program", others)

    def setup(self, rng, share=0.7):
        """A machine, a model and settings, each or not."""
        asked = []
        if rng.random() < share:
            asked += ["--machine", rng.choice(self.machines)[0].removesuffix(".toml")]
        if rng.random() < share:
            asked += ["--model", rng.choice(MODELS)]
        if rng.random() < 0.3:
            asked += ["--tolerance", rng.choice(["0", "1e-6", "0.01", "0.1", "10"])]
        if rng.random() < 0.2:
            asked += ["--set", f"{rng.choice(SETTINGS)}={rng.choice(VALUES)}"]
        if rng.random() < 0.2:
            asked += ["--dialect", rng.choice(DIALECTS)]
        return asked

    def check(self, rng, folder):
        return ["check", self.spoilt_program(rng, folder), "--json", "out.json"]

    def simulate(self, rng, folder):
        return ["simulate", self.spoilt_program(rng, folder), "--json", "out.json", "--blends", "out.csv", "--contour", "places.csv",
                *self.setup(rng)]

    def explain(self, rng, folder):
        return ["explain", self.spoilt_program(rng, folder), "--json", "out.json", *self.setup(rng)]

    def circles(self, rng, folder):
        return ["circular", self.spoilt_program(rng, folder), "--json", "out.json", *self.setup(rng)]

    def compare(self, rng, folder):
        sweep = ["--sweep", rng.choice(["tolerance=0.001:1:log4", "X.jerk=1:100:lin3"])] if rng.random() < 0.3 else []
        models = [part for model in rng.sample(MODELS, 2) for part in ("--model", model)]
        return ["compare", self.spoilt_program(rng, folder), "--json", "out.json", *models, *sweep]

    def versions(self, rng, folder):
        name, text = rng.choice(self.programs)
        text = mutators.piece(text, rng, LINES_OF_A_PROGRAM)
        (folder / f"old_{name}").write_bytes(text)
        return ["compare", f"old_{name}", self.spoil(folder, name, text, rng, "program"), "--json", "out.json", *self.setup(rng)]

    def render(self, rng, folder):
        view = rng.choice(["3d", "charts", "window", "sheet"])
        size = [] if view == "sheet" else ["--size", "640x400"]
        ending = "png" if view == "window" else rng.choice(["png", "svg", "pdf"])
        return ["render", self.spoilt_program(rng, folder), "--view", view, *size, "--out", f"out.{ending}", *self.setup(rng)]

    def report(self, rng, folder):
        return ["report", self.spoilt_program(rng, folder), "--out", rng.choice(["out.pdf", "out.html"]), *self.setup(rng)]

    def machine(self, rng, folder):
        name, text = rng.choice(self.machines)
        file = self.spoil(folder, name, text, rng, "machine")
        program = str(PROJECT / "resources/programs" / rng.choice(["essid_table1.nc", "lesson_singular.nc", "trochoidal_slot.nc"]))
        return rng.choice([["machines", file], ["simulate", program, "--machine", file, "--json", "out.json"]])

    def session(self, rng, folder):
        name, text = rng.choice(self.sessions)
        (folder / "part.nc").write_bytes(b"G21 G90 G1 X20 F3000\nY20\nG2 X40 Y40 I20 J0\nX0 Y0\nM30\n")
        session = json.loads(text)
        session["program"].pop("sha256", None)
        session["reading"].pop("tool_table", None)
        file = self.spoil(folder, "part.feedscope", json.dumps(session, indent=1).encode(), rng, "session")
        return rng.choice([["simulate", file, "--json", "out.json"], ["render", file, "--view", "window", "--out", "out.png"],
                           ["render", file, "--size", "400x300", "--out", "out.png"], ["report", file, "--out", "out.html"]])

    def lesson(self, rng, folder):
        name, text = rng.choice(self.lessons)
        file = self.spoil(folder, name, text.replace(b'program = "', b'program = "' + bytes(PROJECT / "resources/programs") + b"/"), rng,
                          "lesson")
        return rng.choice([["lessons", file], ["lessons", file, "--check"], ["lessons", file, "--out", "out.html"]])

    def configuration(self, rng, folder):
        name, text = rng.choice(self.seeds["import"])
        return ["machines", "import", self.spoil(folder, name, text, rng, "import"), "--out", "out.toml"]

    def spoilt_trace(self, rng, folder):
        name, text = rng.choice(self.seeds["trace"])
        columns = []
        if text.startswith(b"columns:"):
            first, text = text.split(b"\n", 1)
            columns = ["--columns", os.fsdecode(first.removeprefix(b"columns:").strip())]
        return [self.spoil(folder, name, text, rng, "trace"), *columns]

    def trace(self, rng, folder):
        program = [str(PROJECT / "resources/programs/lesson_corners.nc")] if rng.random() < 0.7 else []
        file, *columns = self.spoilt_trace(rng, folder)
        return ["trace", file, *program, *columns, "--json", "out.json"]

    def identify(self, rng, folder):
        file, *columns = self.spoilt_trace(rng, folder)
        program = str(PROJECT / "resources/programs/lesson_corners.nc")
        return ["identify", file, *columns, "--program", program, "--model", rng.choice(MODELS),
                "--out", "out.toml", "--json", "out.json"]

    def load(self, rng, folder):
        name, text = rng.choice(self.loads)
        file = self.spoil(folder, name, text, rng, "machine")
        return ["simulate", str(PROJECT / "resources/programs/trochoidal_slot.nc"), "--load", file, "--json", "out.json"]

    def tools(self, rng, folder):
        name, text = rng.choice(self.seeds["tools"])
        file = self.spoil(folder, f"tools_{name}", text, rng, "tools")
        return ["check", str(PROJECT / "resources/programs/fanuc_flange.nc"), "--tools", file, "--json", "out.json"]

    def merge(self, rng, folder):
        name, text = rng.choice(self.seeds["merge"])
        return ["compare", "--merge", self.spoil(folder, name, text, rng, "merge"), "--csv", "out.csv", "--json", "out.json"]


KINDS = {"check": 12, "simulate": 30, "explain": 10, "circles": 3, "compare": 8, "versions": 4, "render": 10, "report": 5, "machine": 8,
         "session": 8, "lesson": 6, "configuration": 5, "trace": 5, "identify": 3, "load": 3, "tools": 3, "merge": 2}


def bounded():
    resource.setrlimit(resource.RLIMIT_CPU, (CPU_SECONDS, CPU_SECONDS + 5))
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 30, 1 << 30))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def processor_time(pid):
    """Of a process that runs [s]."""
    words = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")


def run(command, folder):
    """Exit code, standard error and processor time [s]."""
    environment = dict(os.environ, LC_ALL="C.UTF-8", HOME=str(folder), XDG_CONFIG_HOME=str(folder / "config"))
    for display in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"):
        environment.pop(display, None)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    process = subprocess.Popen(command, cwd=folder, env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE, preexec_fn=bounded)
    code, err, seen = None, b"", 0
    while code is None:
        try:
            err = process.communicate(timeout=WALL_SECONDS)[1]
            code = process.returncode
        except subprocess.TimeoutExpired:
            seen, before_that = processor_time(process.pid), seen
            if seen < before_that + 1:
                process.kill()
                process.communicate()
                break
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return code, err.decode(errors="replace"), after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def verdict(code, err, used, folder):
    """What is wrong with how a run ended; "" if nothing is."""
    if code is None or used >= CPU_SECONDS:
        return "no end"
    if "internal error" in err:
        return "internal error"
    if "out of memory" in err:
        return "out of memory"
    if code not in EXPECTED:
        return f"signal {-code}" if code < 0 else f"exit code {code}"
    if code == 2 and not err.strip():
        return "refused without a message"
    if list(folder.glob("*.part")):
        return "part of a file left"
    written = folder / "out.json"
    if written.exists():
        try:
            json.loads(written.read_text(encoding="utf-8"))
        except ValueError as error:
            return f"no JSON: {error}"
    return ""


def shell_line(feedscope, arguments):
    return " ".join(shlex.quote(word) for word in [str(feedscope), *arguments])


def trial(feedscope, subjects, kinds, seed, number, folder):
    """Kind, arguments, verdict, standard error and processor time of one trial, whose files are then in `folder`."""
    rng = random.Random(f"{seed} {number}")
    kind = rng.choices(kinds, [KINDS[one] for one in kinds])[0]
    arguments = getattr(subjects, kind)(rng, folder)
    code, err, used = run([feedscope, *arguments], folder)
    return kind, arguments, verdict(code, err, used, folder), err, used


def keep(folder, out, name, line, wrong, err):
    shutil.rmtree(out / name, ignore_errors=True)
    shutil.copytree(folder, out / name)
    (out / name / "command").write_text(line + "\n")
    (out / name / "finding").write_text(f"{wrong}\n{err}")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("feedscope", type=pathlib.Path)
    options.add_argument("--seconds", type=float, default=3600)
    options.add_argument("--seed", type=int, default=int(time.time()))
    options.add_argument("--kinds", default=",".join(KINDS), help="of trials, by commas")
    options.add_argument("--only", type=int, help="this trial alone")
    options.add_argument("--out", type=pathlib.Path, default=PROJECT / "build/mutate")
    asked = options.parse_args()
    feedscope = asked.feedscope.resolve()
    subjects = Subjects(feedscope)
    print(f"seed {asked.seed}", flush=True)
    runs, findings, slowest, number = collections.Counter(), collections.Counter(), (0, ""), asked.only or 0
    end = time.monotonic() + asked.seconds
    while time.monotonic() < end:
        with tempfile.TemporaryDirectory(prefix="feedscope-mutate-") as name:
            folder = pathlib.Path(name)
            kind, arguments, wrong, err, used = trial(feedscope, subjects, asked.kinds.split(","), asked.seed, number, folder)
            runs[kind] += 1
            slowest = max(slowest, (used, f"trial {number}: {shell_line('feedscope', arguments)}"))
            if wrong:
                findings[kind] += 1
                keep(folder, asked.out, f"{asked.seed}-{number}", shell_line(feedscope, arguments), wrong, err)
                print(f"{wrong}: trial {number}: {shell_line('feedscope', arguments)}", flush=True)
        if asked.only is not None:
            break
        number += 1
    for kind in asked.kinds.split(","):
        print(f"{kind:14} {runs[kind]:6} runs {findings[kind]:4} findings")
    print(f"slowest: {slowest[0]:.1f} s of processor, {slowest[1]}")
    print(f"{sum(runs.values())} runs, {sum(findings.values())} findings" + (f" in {asked.out}" if findings else ""))
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
