#!/usr/bin/env python3
"""Times of random programs by the models grbl and klipper, beside those of a second, independent program of the same rules.

  compare.py FEEDSCOPE [--control grbl|klipper]... [--programs COUNT] [--first SEED] [--keep FOLDER]
  compare.py --record FOLDER [--control ...]... [--programs COUNT] [--first SEED]

Lists programs whose times differ by more than 1 ms or 1e-4, and ends with 1 where there are any. --keep: FOLDER gets their files.
--record: writes grbl.json and klipper.json with programs and the second program's times, for tests/core/models.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

import grbl_witness
import klipper_witness
from random_programs import random_case

WITNESSES = {"grbl": grbl_witness, "klipper": klipper_witness}
UNLIMITED = 1000  # what the control does not limit [m/min, m/s2, m/s3]


def machine_file(control, configuration):
    """The machine file of a configuration."""
    lines = ['id = "machine"', 'name = "machine"', f'control = "{control}"', 'reference = "random"', f'model = "{control}"']
    assumed = '"random"'
    for axis, letter in enumerate("XYZ"):
        values = {key: UNLIMITED for key in ("velocity_m_min", "acceleration_m_s2", "jerk_m_s3", "blend_jerk_m_s3")}
        if control == "grbl":
            settings = configuration["settings"]
            values["velocity_m_min"] = settings[f"${110 + axis}"] / 1000
            values["acceleration_m_s2"] = settings[f"${120 + axis}"] / 1000
            values["steps_per_mm"] = settings[f"${100 + axis}"]
        lines.append(f"[axes.{letter}]")
        lines += [f"{key} = {{ value = {value!r}, assumed = {assumed} }}" for key, value in values.items()]
    if control == "grbl":
        own = {"junction_deviation_mm": settings["$11"], "arc_tolerance_mm": settings["$12"], "idle_delay_ms": settings["$1"]}
    else:
        printer = configuration["[printer]"]
        own = {
            "max_velocity_m_min": printer["max_velocity"] * 60 / 1000,
            "max_acceleration_m_s2": printer["max_accel"] / 1000,
            "max_z_velocity_m_min": printer["max_z_velocity"] * 60 / 1000,
            "max_z_acceleration_m_s2": printer["max_z_accel"] / 1000,
            "square_corner_velocity_mm_s": printer["square_corner_velocity"],
            "minimum_cruise_ratio": printer["minimum_cruise_ratio"],
            "arc_resolution_mm": configuration["[gcode_arcs]"]["resolution"],
        }
    lines.append("[settings]")
    lines += [f"{key} = {{ value = {value!r}, assumed = {assumed} }}" for key, value in own.items()]
    return "\n".join(lines) + "\n"


def model_seconds(feedscope, control, configuration, program):
    with tempfile.TemporaryDirectory() as folder:
        files = {name: pathlib.Path(folder) / name for name in ("machine.toml", "program.nc", "run.csv")}
        files["machine.toml"].write_text(machine_file(control, configuration))
        files["program.nc"].write_text(program)
        command = [feedscope, "simulate", files["program.nc"], "--machine", files["machine.toml"], "--dialect", "grbl"]
        run = subprocess.run(command + ["--csv", files["run.csv"], "--step", "1e6"], capture_output=True, text=True)
        if run.returncode not in (0, 1):
            return None, run.stderr
        return float(files["run.csv"].read_text().splitlines()[-1].split(",")[0]), run.stderr


def compare(feedscope, control, seed):
    configuration, program = random_case(control, seed)
    own = WITNESSES[control].seconds(program, configuration)
    model, messages = model_seconds(feedscope, control, configuration, program)
    return seed, own, model, messages


def record(file, control, seeds):
    rows = []
    for seed in seeds:
        configuration, program = random_case(control, seed)
        seconds = round(WITNESSES[control].seconds(program, configuration), 7)
        rows.append({"configuration": configuration, "program": program, "seconds": seconds})
    file.write_text("[\n" + ",\n".join(json.dumps(row) for row in rows) + "\n]\n")


def differs(own, model):
    return model is None or not abs(model - own) <= min(1e-3, 1e-4 * own) + 1e-9


def main():
    options = argparse.ArgumentParser()
    options.add_argument("feedscope", nargs="?")
    options.add_argument("--control", action="append", choices=sorted(WITNESSES))
    options.add_argument("--programs", type=int, default=200)
    options.add_argument("--first", type=int, default=1)
    options.add_argument("--keep", type=pathlib.Path)
    options.add_argument("--record", type=pathlib.Path)
    asked = options.parse_args()
    found = 0
    for control in asked.control or sorted(WITNESSES):
        seeds = range(asked.first, asked.first + asked.programs)
        if asked.record:
            record(asked.record / f"{control}.json", control, seeds)
            continue
        with ThreadPoolExecutor(2) as pool:
            results = list(pool.map(lambda seed: compare(asked.feedscope, control, seed), seeds))
        off = [result for result in results if differs(*result[1:3])]
        largest = max((abs(model / own - 1) for _, own, model, _ in results if model and own), default=0)
        print(f"{control}: {len(results)} programs, {len(results) - len(off)} within 1 ms and 1e-4, largest {largest:.2g}")
        for seed, own, model, messages in off:
            print(f"  seed {seed}: {own:.6f} s here, model {model}: {messages.strip()[:200]}")
            if asked.keep:
                configuration, program = random_case(control, seed)
                asked.keep.mkdir(parents=True, exist_ok=True)
                (asked.keep / f"{control}_{seed}.nc").write_text(program)
                (asked.keep / f"{control}_{seed}.toml").write_text(machine_file(control, configuration))
        found += len(off)
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
