"""Simulate NC programs on published control models and machines.

    import feedscope

    program = feedscope.read("part.nc")
    run = program.simulate(machine="dmg-mori-evo40", tolerance=0.02)
    print(run.cycle_time, run.time_by_cause)
    motion = run.samples(step=0.001)          # columns of the CSV as numpy arrays
    runs = feedscope.sweep(program, "tolerance", [0.005, 0.01, 0.02])

Numbers carry their unit in the name, as in the files of the command line: mm, s, mm/min, m/s2, m/s3. What is wrong with a
call (unknown machine, value out of bounds, unreadable file) raises Error with the value, its bounds and the nearest valid
name; what is wrong with a program is in Program.diagnostics.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from . import _native
from ._native import Error

__all__ = ["Error", "Program", "Run", "machines", "models", "read", "read_text", "sweep"]
__version__: str = _native.version


def machines() -> list[str]:
    """Ids of the shipped machines."""
    return _native.machine_ids()


def models() -> list[str]:
    """Ids of the control models."""
    return _native.model_ids()


def read(
    file: str | os.PathLike[str],
    *,
    dialect: str | None = None,
    unit: str | None = None,
    skip_deleted: bool = False,
    radii: Mapping[str, float] | None = None,
    offsets: Mapping[str, Sequence[float]] | None = None,
) -> Program:
    """Read an NC program.

    dialect: iso, fanuc, linuxcnc, grbl, sinumerik, heidenhain or heidenhain-iso; recognised where it is not given.
    unit: mm or inch, of a program that does not say it.
    skip_deleted: leave out blocks that begin with "/".
    radii: cutter radius in mm by tool, as the program names it.
    offsets: zero point (x, y, z) in mm by work offset, as the program names it.
    """
    options = _native.read_options(dialect, unit, skip_deleted, dict(radii or {}), _zero_points(offsets))
    return Program(_native.read_file(os.fspath(file), options))


def read_text(text: str, name: str = "program", **options: Any) -> Program:
    """Read an NC program that is a text; `options` as of read()."""
    given = {"dialect": None, "unit": None, "skip_deleted": False, "radii": None, "offsets": None}
    unknown = set(options) - set(given)
    if unknown:
        raise TypeError(f"read_text() has no argument '{sorted(unknown)[0]}'")
    given.update(options)
    native = _native.read_options(
        given["dialect"], given["unit"], given["skip_deleted"], dict(given["radii"] or {}), _zero_points(given["offsets"])
    )
    return Program(_native.read_text(text, name, native))


class Program:
    """An NC program that was read; made by read() and read_text()."""

    def __init__(self, native: _native.Program) -> None:
        self._native = native
        self._facts: dict[str, Any] | None = None

    @property
    def facts(self) -> dict[str, Any]:
        """What `feedscope check --json` writes under "program": lines, blocks, path length, bounds, tools, ..."""
        return self._check()["program"]

    @property
    def diagnostics(self) -> list[dict[str, Any]]:
        """Messages of the reader: severity, line, column, code, message, hint."""
        return self._check()["diagnostics"]

    @property
    def has_errors(self) -> bool:
        """Whether something of the program was not understood; the rest is simulated all the same."""
        return any(entry["severity"] == "error" for entry in self.diagnostics)

    def simulate(
        self,
        machine: str | os.PathLike[str] = "",
        model: str = "",
        *,
        tolerance: float | None = None,
        settings: Mapping[str, float | str] | None = None,
    ) -> Run:
        """Run the program on a machine.

        machine: id or machine file; without it the one that goes with the program's dialect.
        model: id of a control model; without it the machine's own.
        tolerance: contour tolerance in mm instead of the program's and the machine's.
        settings: of the model ("alpha": 2) or limits of axes ("X.jerk": 20), as --set of the command line takes them.
        """
        setup = self._setup(machine, model, tolerance, settings)
        return Run(_native.simulate_all(self._native, [setup])[0])

    def _setup(
        self,
        machine: str | os.PathLike[str],
        model: str,
        tolerance: float | None,
        settings: Mapping[str, float | str] | None,
    ) -> _native.Setup:
        assignments = [f"{key}={_text(value)}" for key, value in (settings or {}).items()]
        return _native.setup(self._native, os.fspath(machine), model, tolerance, assignments)

    def _check(self) -> dict[str, Any]:
        if self._facts is None:
            self._facts = json.loads(self._native.json())
        return self._facts

    def __repr__(self) -> str:
        facts = self.facts
        return f"<feedscope.Program {facts['file']}: {facts['blocks']} blocks, {facts['dialect']}>"


class Run:
    """One program on one machine with one control model; made by Program.simulate() and sweep()."""

    def __init__(self, native: _native.Run) -> None:
        self._native = native
        self._summary: dict[str, Any] | None = None

    @property
    def summary(self) -> dict[str, Any]:
        """What `feedscope simulate --json` writes: machine, model, settings, times, peaks, contour error, ..."""
        if self._summary is None:
            self._summary = json.loads(self._native.json())
        return self._summary

    @property
    def cycle_time(self) -> float:
        """Cycle time in s; summary["not_counted"] says what it does not contain."""
        return self.summary["cycle_time_s"]

    @property
    def max_contour_error(self) -> float:
        """Largest distance of the executed from the programmed path in mm."""
        return self.summary["max_contour_error_mm"]

    @property
    def time_by_cause(self) -> dict[str, float]:
        """Seconds by limiting cause; they add up to the cycle time."""
        return self.summary["time_by_cause_s"]

    def samples(self, step: float = 0.001, *, times: Iterable[float] | None = None) -> dict[str, np.ndarray]:
        """The motion at instants: every `step` in s and the very end, or at `times` in s, which must not fall.

        The keys are the columns of `feedscope simulate --csv`; `cause` holds their keys as text.
        """
        instants = self._native.times(step) if times is None else np.array([*times], dtype=float)
        if (np.diff(instants) < 0).any():
            raise Error("times fall; sort them")
        return _with_causes(self._native.samples(instants))

    def pieces(self) -> dict[str, np.ndarray]:
        """The exact motion: parts of one law on one element of the executed path each, in order of time.

        time_s, duration_s, path_mm: start, duration, executed length at the start. law: "path_length" (q is the length from
        the start of the element in mm), "parameter" (q is the parameter of the corner blend) or "filtered" (the motion of
        filtered axes: only q holds, v, a and j are nan). q(t) = q + v t + a t^2 / 2 + j t^3 / 6. line: of the program.
        element: number of the element. cause: limiting cause.
        """
        table = _with_causes(self._native.pieces())
        table["law"] = np.array(["path_length", "ramp", "parameter", "filtered"])[table["law"]]
        return table

    def __repr__(self) -> str:
        summary = self.summary
        return f"<feedscope.Run {summary['machine']['id']}, {summary['model']['id']}: {summary['cycle_time_s']:.3f} s>"


def sweep(
    program: Program,
    key: str,
    values: Iterable[float | str],
    machine: str | os.PathLike[str] = "",
    model: str = "",
    *,
    tolerance: float | None = None,
    settings: Mapping[str, float | str] | None = None,
) -> list[Run]:
    """Simulate a program with each of `values` of a setting, in parallel; `key` is "tolerance" or as of `settings`."""
    setups = []
    for value in values:
        if key == "tolerance":
            setups.append(program._setup(machine, model, float(value), settings))
        else:
            setups.append(program._setup(machine, model, tolerance, {**(settings or {}), key: value}))
    return [Run(native) for native in _native.simulate_all(program._native, setups)]


def _zero_points(offsets: Mapping[str, Sequence[float]] | None) -> dict[str, list[float]]:
    points = {name: [float(value) for value in zero] for name, zero in (offsets or {}).items()}
    for name, zero in points.items():
        if len(zero) != 3:
            raise Error(f"zero point of {name} has {len(zero)} coordinates; it needs x, y and z")
    return points


def _text(value: float | str) -> str:
    return value if isinstance(value, str) else repr(float(value))


def _with_causes(table: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    table["cause"] = np.array(_native.cause_names())[table["cause"]]
    return table
