#!/usr/bin/env python3
"""Compares what two builds wrote: same_numbers.py ONE OTHER, folders with files of the same names.

Texts must be equal, numbers to 1e-9 of the larger one (or 1e-12), but for what a clock measured, and for times by cause: where two causes allow
the same feed to the last digits, as along dense lines, rounding decides which of them has the instant. Such a time may move by 1e-5 of the sum
over all causes, while the sum itself is equal to 1e-9. Prints a line a file with the largest differences; exits with 1 if a file differs or is
missing.
"""
import csv
import io
import json
import pathlib
import re
import sys

LARGEST = 1e-9
SMALLEST = 1e-12
MOVED = 1e-5  # of the sum over all causes
ELAPSED = re.compile(r'"(?:read|simulate|runs)_s": [\d.e+-]+')
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
CAUSES = ("time_by_cause_s", "ramp_down_by_slower_place_s")
CAUSE_COLUMN = re.compile(r"time_\w+_s")
CAUSE_ROWS = re.compile(r"(?<=Time by limiting cause\n)(?:  .*\n)+")


class Times:
    """Times by cause, taken out of what is compared to 1e-9: lists of names and seconds."""

    def __init__(self):
        self.lists = []

    def of_json(self, value):
        """`value` without them, but for their sums."""
        if isinstance(value, list):
            return [self.of_json(item) for item in value]
        if not isinstance(value, dict):
            return value
        rest = {}
        for key, item in value.items():
            if key in CAUSES and isinstance(item, dict):
                self.lists.append(item)
                rest[key] = {"sum": sum(item.values())}
            else:
                rest[key] = self.of_json(item)
        return rest

    def of_csv(self, text):
        rows = list(csv.reader(io.StringIO(text)))
        columns = [i for i, name in enumerate(rows[0]) if CAUSE_COLUMN.fullmatch(name)] if rows else []
        for row in rows[1:]:
            times = {rows[0][i]: float(row[i]) for i in columns if i < len(row) and row[i]}
            self.lists.append(times)
            for i in columns:
                row[i] = ""
            row.append(f"{sum(times.values()):.9g}")  # of eleven digits each
        return "\n".join(",".join(row) for row in rows)

    def of_text(self, text):
        """The table of causes, whose percentages follow from its times."""
        def take(rows):
            self.lists.append({f"row {i}": float(s) for i, s in enumerate(re.findall(r" (\d+\.\d+) s ", rows[0]))})
            return NUMBER.sub("0", rows[0])
        return CAUSE_ROWS.sub(take, text)

    def moved(self, other):
        """The largest part of a sum by which a time differs; None if the names differ."""
        if [sorted(times) for times in self.lists] != [sorted(times) for times in other.lists]:
            return None
        largest = 0.0
        for one, two in zip(self.lists, other.lists):
            total = max(sum(one.values()), SMALLEST)
            largest = max([largest] + [abs(one[name] - two[name]) / total for name in one])
        return largest


def without_times(name, text):
    """The text with its times by cause taken out, and these."""
    times = Times()
    text = ELAPSED.sub('"elapsed": 0', text)
    if name.endswith(".json"):
        text = json.dumps(times.of_json(json.loads(text)), indent=1, ensure_ascii=False)
    elif name.endswith(".csv"):
        text = times.of_csv(text)
    else:
        text = times.of_text(text)
    return text, times


def difference(one, other):
    """The largest relative difference of the numbers of two texts; None if the rest of them differs."""
    if NUMBER.sub("0", one) != NUMBER.sub("0", other):
        return None
    largest = 0.0
    for a, b in zip(NUMBER.findall(one), NUMBER.findall(other)):
        if a != b:
            x, y = float(a), float(b)
            if abs(x - y) > SMALLEST:
                largest = max(largest, abs(x - y) / max(abs(x), abs(y)))
    return largest


def main():
    one, other = map(pathlib.Path, sys.argv[1:])
    files = sorted(path.name for path in one.iterdir())
    failed = sorted(path.name for path in other.iterdir() if path.name not in files)
    for name in failed:
        print(f"  {name}: only in {other}")
    for name in files:
        if not (other / name).exists():
            print(f"  {name}: missing")
            failed.append(name)
            continue
        whole = [(folder / name).read_bytes().decode("utf-8") for folder in (one, other)]
        if whole[0] == whole[1]:
            print(f"  {name}: bytes equal")
            continue
        text, times = zip(*(without_times(name, part) for part in whole))
        found, moved = difference(*text), times[0].moved(times[1])
        if found is None or moved is None:
            shown = next((pair for pair in zip(text[0].splitlines(), text[1].splitlines())
                          if NUMBER.sub("0", pair[0]) != NUMBER.sub("0", pair[1])), ("", "more or fewer lines or causes"))
            print(f"  {name}: texts differ:\n    {shown[0][:200]}\n    {shown[1][:200]}")
        else:
            print(f"  {name}: {len(NUMBER.findall(text[0]))} numbers, largest difference {found:.1e}; times by cause {moved:.1e} of their sum")
        if found is None or moved is None or found > LARGEST or moved > MOVED:
            failed.append(name)
    sys.exit(1 if failed or not files else 0)


if __name__ == "__main__":
    main()
