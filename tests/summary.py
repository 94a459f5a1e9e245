#!/usr/bin/env python3
"""What the last test run of a build folder found, by single tests.

    tests/summary.py BUILD [SLOWEST]

Reads what ctest and the test executables left in BUILD/results. Prints the numbers of tests and processes, the SLOWEST
tests if that is given, and of each failed test how to run it again; ends with 1 if one failed.
"""
import collections
import json
import pathlib
import subprocess
import sys
import xml.etree.ElementTree as tree

build = pathlib.Path(sys.argv[1])
slowest = int(sys.argv[2]) if len(sys.argv) > 2 else 0
results = build / "results"

listed = json.loads(subprocess.run(["ctest", "--test-dir", build, "--show-only=json-v1"], capture_output=True, check=True).stdout)
commands = {test["name"]: test.get("command", []) for test in listed["tests"]}

Single = collections.namedtuple("Single", "name seconds again")
passed, skipped, failed = [], [], []
processes = 0
for run in sorted(results.glob("ctest-*.xml")):
    for process in tree.parse(run).getroot().iter("testcase"):
        processes += 1
        name = process.get("name")
        whole = Single(name, float(process.get("time")), f"ctest --test-dir {build} --output-on-failure -R '^{name}$'")
        report = results / f"{name}.xml"
        if not report.exists():  # no GoogleTest, or one that did not come to its end
            {"run": passed, "fail": failed}.get(process.get("status"), skipped).append(whole)
            continue
        wrong = 0
        for case in tree.parse(report).getroot().iter("testcase"):
            if case.get("status") == "notrun":
                continue
            full = f"{case.get('classname')}.{case.get('name')}"
            single = Single(full, float(case.get("time")), f"{commands[name][0]} --gtest_filter='{full}'")
            if case.find("failure") is not None:
                wrong += 1
                failed.append(single)
            else:
                (skipped if case.find("skipped") is not None else passed).append(single)
        if process.get("status") == "fail" and not wrong:
            failed.append(whole)

everything = passed + skipped + failed
print(f"{len(everything)} tests in {processes} processes: {len(passed)} passed, {len(skipped)} skipped, {len(failed)} failed")
for test in sorted(everything, key=lambda test: -test.seconds)[:slowest]:
    print(f"  {test.seconds:7.2f} s  {test.name}")
for test in skipped:
    print(f"  skipped: {test.name}")
for test in failed:
    print(f"  failed: {test.name}\n          {test.again}")
sys.exit(1 if failed else 0)
