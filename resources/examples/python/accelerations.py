"""Draws how long each axis has which acceleration, as a share of its limit: accelerations.py PROGRAM PICTURE"""

import sys

import feedscope
import matplotlib
import numpy as np

matplotlib.use("Agg")  # no display is needed
import matplotlib.pyplot as plt

run = feedscope.read(sys.argv[1]).simulate()
limits = run.summary["limits"]["axes"]
motion = run.samples(step=0.001)

figure, axes = plt.subplots(figsize=(7, 4.2), layout="constrained")
edges = np.linspace(0, 1.05, 43)
for axis, colour in zip("XYZ", ("#0072b2", "#d55e00", "#009e73")):
    share = np.abs(motion[f"a{axis.lower()}_m_s2"]) / limits[axis]["acceleration_m_s2"]
    seconds, _ = np.histogram(share[share > 1e-3], edges)
    axes.stairs(seconds * 0.001, edges * 100, label=f"{axis} ({limits[axis]['acceleration_m_s2']:g} m/s²)", color=colour)
axes.set_yscale("log")  # few seconds near the limit are as telling as many far below it
axes.set(xlabel="acceleration [% of the axis limit]", ylabel="time [s]", title=f"{run.cycle_time:.2f} s in all")
axes.legend()
figure.savefig(sys.argv[2], dpi=150)
