import csv
import io
import json
import os
import signal
import subprocess
import threading
import time
import unittest

import feedscope
import numpy as np

SAMPLES = os.environ["SAMPLES"]


def sample(name):
    return os.path.join(SAMPLES, name)


def command(*arguments):
    return subprocess.run([os.environ["FEEDSCOPE"], *arguments], capture_output=True, text=True, check=True).stdout


class Reading(unittest.TestCase):
    def test_facts_are_those_of_check(self):
        program = feedscope.read(sample("heidenhain_plate.h"))
        told = json.loads(command("check", sample("heidenhain_plate.h"), "--json", "-"))["program"]
        self.assertEqual(program.facts, told)

    def test_text_is_read_as_a_file_is(self):
        program = feedscope.read_text("G21 G1 X10 F600\nfoo\n")
        self.assertTrue(program.has_errors)
        self.assertEqual([entry["line"] for entry in program.diagnostics if entry["severity"] == "error"], [2])

    def test_unit_and_offsets_are_followed(self):
        program = feedscope.read_text("G54 G1 X1 F100\n", unit="inch", offsets={"G54": (10, 0, 0)})
        self.assertEqual(program.facts["unit"], {"name": "inch", "said_by": "option"})
        self.assertAlmostEqual(program.facts["bounds"]["max"][0], 35.4)

    def test_wrong_calls_say_what_is_wrong(self):
        with self.assertRaisesRegex(feedscope.Error, "nothere.nc"):
            feedscope.read("nothere.nc")
        with self.assertRaisesRegex(feedscope.Error, "mm or inch"):
            feedscope.read_text("G1 X1", unit="foot")
        with self.assertRaisesRegex(feedscope.Error, "x, y and z"):
            feedscope.read_text("G1 X1", offsets={"G54": (1, 2)})
        with self.assertRaisesRegex(TypeError, "colour"):
            feedscope.read_text("G1 X1", colour="red")


class Simulation(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.program = feedscope.read(sample("essid_table1.nc"))
        cls.run_ = cls.program.simulate()

    def test_summary_is_that_of_the_command_line(self):
        told = json.loads(command("simulate", sample("essid_table1.nc"), "--json", "-"))
        told.pop("elapsed")
        summary = dict(self.run_.summary)
        summary.pop("elapsed")
        self.assertEqual(summary, told)
        self.assertAlmostEqual(sum(self.run_.time_by_cause.values()), self.run_.cycle_time, places=6)

    def test_samples_are_the_rows_of_the_csv(self):
        rows = list(csv.DictReader(io.StringIO(command("simulate", sample("essid_table1.nc"), "--step", "0.01", "--csv", "-"))))
        motion = self.run_.samples(0.01)
        self.assertEqual(set(motion), set(rows[0]))
        self.assertEqual(len(motion["time_s"]), len(rows))
        for name, values in motion.items():
            if name == "cause":
                self.assertEqual(list(values), [row[name] for row in rows])
            else:
                written = np.array([float(row[name]) for row in rows])
                np.testing.assert_allclose(values, written, rtol=1e-9, atol=1e-6)

    def test_samples_of_drives_are_the_columns_of_the_csv_too(self):
        settings = {"X.kv": 60, "Y.kv": 50}
        motion = self.program.simulate(model="essid", settings=settings).samples(0.01)
        np.testing.assert_allclose(
            motion["x_mm"] - motion["actual_x_mm"], motion["following_error_x_um"] / 1000, atol=1e-9)
        self.assertGreater(motion["actual_contour_error_um"].max(), 1)
        self.assertNotIn("actual_x_mm", self.run_.samples(0.01))

    def test_samples_at_given_times(self):
        motion = self.run_.samples(times=[0.0, 0.1, 0.1])
        self.assertEqual(list(motion["time_s"]), [0.0, 0.1, 0.1])
        with self.assertRaisesRegex(feedscope.Error, "sort"):
            self.run_.samples(times=[0.2, 0.1])
        with self.assertRaisesRegex(feedscope.Error, "step"):
            self.run_.samples(0)

    def test_pieces_follow_each_other_and_are_the_motion(self):
        pieces = self.run_.pieces()
        ends = pieces["time_s"] + pieces["duration_s"]
        np.testing.assert_allclose(pieces["time_s"][1:], ends[:-1], atol=1e-9)
        self.assertAlmostEqual(ends[-1], self.run_.cycle_time, places=9)
        along = pieces["law"] == "path_length"
        feed = self.run_.samples(times=pieces["time_s"])["feed_mm_min"]
        np.testing.assert_allclose(feed[along], 60 * pieces["v"][along], atol=1e-3)

    def test_filtered_motion_has_pieces_too(self):
        pieces = self.program.simulate(machine="dmg-mori-evo40", model="ward").pieces()
        filtered = pieces["law"] == "filtered"
        self.assertTrue(filtered.any())
        self.assertTrue(np.isnan(pieces["v"][filtered]).all())

    def test_settings_and_tolerance_hold(self):
        run = self.program.simulate("spinner-mvc850", "essid", tolerance=0.05, settings={"X.jerk": 20})
        self.assertEqual(run.summary["settings"]["contour_tolerance_mm"], 0.05)
        self.assertEqual(run.summary["limits"]["axes"]["X"]["jerk_m_s3"], 20)
        with self.assertRaisesRegex(feedscope.Error, "did you mean|nearest|spinner"):
            self.program.simulate("spiner-mvc850")
        with self.assertRaises(feedscope.Error):
            self.program.simulate(settings={"X.jerk": -1})

    def test_sweep_is_the_single_runs(self):
        runs = feedscope.sweep(self.program, "tolerance", [0.01, 0.05])
        self.assertEqual([run.cycle_time for run in runs],
                         [self.program.simulate(tolerance=value).cycle_time for value in (0.01, 0.05)])
        faster = feedscope.sweep(self.program, "X.jerk", [10, 40])
        self.assertGreater(faster[0].cycle_time, faster[1].cycle_time)

    def test_lists(self):
        self.assertIn("hermle-c800u", feedscope.machines())
        self.assertIn("optimal", feedscope.models())
        self.assertRegex(feedscope.__version__, r"^\d+\.\d+\.\d+$")


class LongWork(unittest.TestCase):
    def test_interrupt_ends_it(self):
        lines = "\n".join(f"G1 X{i % 97} Y{(i * 7) % 89} F9000" for i in range(400000))
        program = feedscope.read_text("G21\n" + lines)
        threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
        start = time.monotonic()
        with self.assertRaises(KeyboardInterrupt):
            feedscope.sweep(program, "tolerance", [0.01 + 0.001 * i for i in range(40)], model="optimal")
        self.assertLess(time.monotonic() - start, 60)


if __name__ == "__main__":
    unittest.main()
