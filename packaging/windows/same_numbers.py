#!/usr/bin/env python3
"""Compares what two builds wrote: same_numbers.py ONE OTHER, folders with files of the same names.

Texts must be equal, numbers to 1e-9 of the larger one (or 1e-12), but for what a clock measured. Prints a line a file with the largest relative
difference; exits with 1 if a file differs or is missing.
"""
import pathlib
import re
import sys

LARGEST = 1e-9
SMALLEST = 1e-12
ELAPSED = re.compile(r'"(?:read|simulate|runs)_s": [\d.e+-]+')
NUMBER = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def difference(one, other):
    """The largest relative difference of the numbers of two texts; None if the rest of them differs."""
    one, other = ELAPSED.sub("", one), ELAPSED.sub("", other)
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
        text = [(folder / name).read_bytes().decode("utf-8") for folder in (one, other)]
        found = difference(*text)
        numbers = len(NUMBER.findall(text[0]))
        if found is None:
            shown = next((pair for pair in zip(text[0].splitlines(), text[1].splitlines())
                          if NUMBER.sub("0", pair[0]) != NUMBER.sub("0", pair[1])), ("", "more or fewer lines"))
            print(f"  {name}: texts differ:\n    {shown[0][:200]}\n    {shown[1][:200]}")
        else:
            equal = "bytes equal" if text[0] == text[1] else f"largest difference {found:.1e}"
            print(f"  {name}: {numbers} numbers, {equal}")
        if found is None or found > LARGEST:
            failed.append(name)
    sys.exit(1 if failed or not files else 0)


if __name__ == "__main__":
    main()
