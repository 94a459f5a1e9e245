"""Simulates every NC program of a folder with several tolerances and writes a table: study_folder.py FOLDER TABLE.csv"""

import pathlib
import sys

import feedscope
import pandas

rows = []
for file in sorted(pathlib.Path(sys.argv[1]).iterdir()):
    try:
        program = feedscope.read(file)
        if program.facts["segments"] == 0:
            print(f"{file.name}: no motion, skipped", file=sys.stderr)
            continue
        for tolerance, run in zip((0.01, 0.05), feedscope.sweep(program, "tolerance", (0.01, 0.05))):
            causes = run.time_by_cause
            rows.append(
                {
                    "program": file.name,
                    "has_errors": program.has_errors,
                    "tolerance_mm": tolerance,
                    "cycle_time_s": run.cycle_time,
                    "max_contour_error_mm": run.max_contour_error,
                    "limiting_cause": max(causes, key=causes.get, default=""),
                }
            )
    except feedscope.Error as error:
        print(f"{file.name}: {error}", file=sys.stderr)

table = pandas.DataFrame(rows)
table.to_csv(sys.argv[2], index=False)
print(table.pivot_table(index="program", columns="tolerance_mm", values="cycle_time_s").round(2))
