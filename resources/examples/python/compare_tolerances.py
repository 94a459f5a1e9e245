"""Draws cycle time and contour error of an NC program over the contour tolerance: compare_tolerances.py PROGRAM PICTURE"""

import sys

import feedscope
import matplotlib

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt

program = feedscope.read(sys.argv[1])
tolerances = [0.005, 0.01, 0.02, 0.05, 0.1, 0.2]
runs = feedscope.sweep(program, "tolerance", tolerances)

figure, times = plt.subplots(figsize=(7, 4.2), layout="constrained")
times.plot(tolerances, [run.cycle_time for run in runs], "o-", color="#0072b2")
times.set(xscale="log", xlabel="contour tolerance [mm]", title=runs[0].summary["machine"]["name"])
times.set_ylabel("cycle time [s]", color="#0072b2")
errors = times.twinx()
errors.plot(tolerances, [1000 * run.max_contour_error for run in runs], "s--", color="#d55e00")
errors.set_ylabel("largest contour error [µm]", color="#d55e00")
times.set_xticks(tolerances, [f"{tolerance:g}" for tolerance in tolerances])
times.minorticks_off()
figure.savefig(sys.argv[2], dpi=150)
