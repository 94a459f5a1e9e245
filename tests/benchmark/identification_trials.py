#!/usr/bin/env python3
"""How often identification is right: identification_trials.py FEEDSCOPE [TRIALS] [FIRST_SEED] [MODEL...]

Each trial simulates the test program of `feedscope identify --program` on a machine whose limits and tolerance are
drawn, makes a trace of it (positions with noise, rounded to 1 um, one sample each 4 ms with jitter, axes shifted), and
has the numbers found again from the shipped machine. A number counts as right within 2 % or its stated uncertainty, as
not told if identify says so, else as wrong; exit code 1 if any is.
"""

import csv
import json
import pathlib
import random
import subprocess
import sys
import tempfile

MACHINES = {
    "linuxcnc": ("linuxcnc-mill", {"X.velocity": 12, "Y.velocity": 12, "X.acceleration": 1, "Y.acceleration": 1,
                                   "Z.acceleration": 0.5, "blend_tolerance_mm": 0.03}, ["max_linear_velocity_m_min=60"]),
    "grbl": ("grbl-router", {"X.velocity": 6, "Y.velocity": 6, "X.acceleration": 0.5, "Y.acceleration": 0.5,
                             "junction_deviation_mm": 0.02}, []),
    "essid": ("spinner-mvc850", {"X.velocity": 14, "Y.velocity": 14, "X.acceleration": 1.5, "Y.acceleration": 1.5,
                                 "X.jerk": 20, "Y.jerk": 20, "contour_tolerance_mm": 0.05}, []),
}


def run(*arguments):
    return subprocess.run(list(map(str, arguments)), capture_output=True, text=True, check=False)


def record(motion, trace, rng):
    """A trace of the motion as a control would have it."""
    noise, jitter = 3e-4, 5e-5
    shift = [round(rng.uniform(-50, 50), 3) for _ in "xyz"]
    rows = list(csv.DictReader(motion.open()))
    with trace.open("w") as out:
        out.write("time_s,x_mm,y_mm,z_mm\n")
        for row in rows:
            time = float(row["time_s"]) + rng.uniform(-jitter, jitter)
            place = [round(float(row[f"{a}_mm"]) + s + rng.gauss(0, noise), 3) for a, s in zip("xyz", shift)]
            out.write(f"{time:.6f},{place[0]:.3f},{place[1]:.3f},{place[2]:.3f}\n")


def trial(feedscope, model, seed, folder):
    machine, middle, fixed = MACHINES[model]
    rng = random.Random(f"{model} {seed}")
    truth = {key: value * 2 ** rng.uniform(-1, 1) for key, value in middle.items()}
    program, motion, trace, result = (folder / name for name in ("test.nc", "motion.csv", "trace.csv", "found.json"))
    run(feedscope, "identify", "--program", "--dialect", "iso", "--size", 120, "--feed-max", 9000, "--out", program)
    settings = [part for key, value in truth.items() for part in ("--set", f"{key}={value:.9g}")]
    settings += [part for one in fixed for part in ("--set", one)]
    done = run(feedscope, "simulate", program, "--machine", machine, "--model", model, *settings, "--csv", motion, "--step",
               "0.004")
    if done.returncode != 0:
        raise SystemExit(done.stderr)
    record(motion, trace, rng)
    found = run(feedscope, "identify", trace, "--program", program, "--machine", machine, "--model", model, "--fit",
                ",".join(truth), "--json", result, *[part for one in fixed for part in ("--set", one)])
    if found.returncode not in (0, 1):
        raise SystemExit(found.stderr)
    counts = {}
    for key, value in truth.items():
        one = json.loads(result.read_text())["parameters"][key]
        off = abs(one["value"] - value)
        within = one["told"] and (off <= 0.02 * value or off <= one["uncertainty"])
        counts[key] = ("right" if within else "wrong" if one["told"] else "not told", one["value"] / value - 1)
    return counts


def main():
    feedscope = pathlib.Path(sys.argv[1]).resolve()
    trials = int(sys.argv[2]) if len(sys.argv) > 2 else 100
    first = int(sys.argv[3]) if len(sys.argv) > 3 else 1
    models = sys.argv[4:] or list(MACHINES)
    all_right = True
    print("| model | number | right | not told | wrong | largest deviation of the told |\n| --- | --- | --- | --- | --- | --- |")
    for model in models:
        table = {}
        for seed in range(first, first + trials):
            with tempfile.TemporaryDirectory() as folder:
                for key, (verdict, off) in trial(feedscope, model, seed, pathlib.Path(folder)).items():
                    table.setdefault(key, []).append((verdict, off))
                    if verdict == "wrong":
                        all_right = False
                        print(f"wrong: {model} seed {seed}: {key} {100 * off:+.2f} %", file=sys.stderr)
        for key, verdicts in table.items():
            count = {kind: sum(verdict == kind for verdict, _ in verdicts) for kind in ("right", "not told", "wrong")}
            told = [abs(off) for verdict, off in verdicts if verdict != "not told"]
            print(f"| {model} | `{key}` | {count['right']} | {count['not told']} | {count['wrong']} | "
                  f"{100 * max(told, default=0):.2f} % |", flush=True)
    return 0 if all_right else 1


if __name__ == "__main__":
    sys.exit(main())
