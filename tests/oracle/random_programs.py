"""Small random programs for LinuxCNC and machines to run them on.

Every program begins at zero, with G21 G17 G90 G94 in force, and ends at rest after 0.3 to 3 s. Programs and machines follow from
a seed alone. A program uses one kind of motion (KINDS), so that a difference of the model points at a rule; "rotary alone" has
blocks in which rotary axes turn alone.
"""

import dataclasses
import math
import random
import re

LINEAR = "XYZ"
ROTARY = "AC"
PLANES = {"G17": (0, 1, 2), "G18": (2, 0, 1), "G19": (1, 2, 0)}  # axes of the plane, then the one across it
SHORTEST_MM = 0.2
LONGEST_S = 0.9  # about, of one program


@dataclasses.dataclass
class Machine:
    """Limits as an INI file has them: mm/s and mm/s2, for A and C deg/s and deg/s2."""

    period_ns: int
    velocity: dict
    acceleration: dict
    max_velocity: float
    override: float

    @property
    def slowest(self):
        """Least acceleration of the linear axes [mm/s2]."""
        return min(self.acceleration[axis] for axis in LINEAR)

    @property
    def slowest_velocity(self):
        """Least velocity of the linear axes [mm/s], at most that of the path."""
        return min(self.max_velocity, *(self.velocity[axis] for axis in LINEAR))

    def ini(self, display, hal):
        """Text of the INI file; `display` and `hal` are the files that it names."""
        joints = LINEAR + ROTARY
        lines = ["[EMC]", "VERSION = 1.1", "MACHINE = Oracle", "DEBUG = 0", "[DISPLAY]", f"DISPLAY = {display}",
                 f"MAX_FEED_OVERRIDE = {self.override}", "[RS274NGC]", "PARAMETER_FILE = linuxcnc.var", "[EMCMOT]",
                 "EMCMOT = motmod", "COMM_TIMEOUT = 5", f"SERVO_PERIOD = {self.period_ns}", "[TASK]", "TASK = milltask",
                 f"CYCLE_TIME = {self.period_ns * 1e-9 / 2:.6f}", "[HAL]", f"HALFILE = {hal}", "[EMCIO]", "EMCIO = io",
                 "CYCLE_TIME = 0.001", "[TRAJ]", "COORDINATES = " + " ".join(joints), "LINEAR_UNITS = mm",
                 "ANGULAR_UNITS = degree", "DEFAULT_LINEAR_VELOCITY = 50", f"MAX_LINEAR_VELOCITY = {self.max_velocity}",
                 "NO_FORCE_HOMING = 1", "[KINS]", "KINEMATICS = xyzac-trt-kins", f"JOINTS = {len(joints)}"]
        for joint, axis in enumerate(joints):
            limits = ["MIN_LIMIT = -1000000", "MAX_LIMIT = 1000000", f"MAX_VELOCITY = {self.velocity[axis]}",
                      f"MAX_ACCELERATION = {self.acceleration[axis]}"]
            lines += [f"[AXIS_{axis}]"] + limits + [f"[JOINT_{joint}]", "TYPE = " + ("LINEAR" if axis in LINEAR else "ANGULAR")]
            lines += limits + ["HOME = 0", "HOME_SEQUENCE = 0"]
        return "\n".join(lines) + "\n"


@dataclasses.dataclass
class Program:
    kind: str
    lines: list


def logarithmic(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def rounded(value, digits):
    """To significant digits, as people write limits."""
    return float(f"{value:.{digits}g}")


def machine(seed):
    rng = random.Random(f"machine {seed}")
    acceleration = {axis: rounded(logarithmic(rng, 100, 5000), 3) for axis in LINEAR}
    if rng.random() < 0.3:
        acceleration = dict.fromkeys(LINEAR, acceleration["X"])
    velocity = {axis: rounded(logarithmic(rng, 50, 400), 3) for axis in LINEAR}
    for axis in ROTARY:
        acceleration[axis] = rounded(logarithmic(rng, 200, 5000), 3)
        velocity[axis] = rounded(logarithmic(rng, 20, 300), 3)
    return Machine(rng.choice([500000, 1000000, 1000000, 2000000]), velocity, acceleration,
                   rounded(logarithmic(rng, 50, 400), 3), rng.choice([1, 1, 1.2, 1.5]))


def number(value):
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def mode(rng, chains=0.5):
    """A G64 or G61; with probability `chains` one that joins blocks."""
    if rng.random() < 0.1:
        return "G64"
    words = f"G64 P{number(logarithmic(rng, 0.001, 0.5))}"
    if rng.random() < chains:
        return words if rng.random() < 0.3 else words + f" Q{number(logarithmic(rng, 0.001, 0.2))}"
    return words + " Q0"


class Pen:
    """Writes moves of a plane with a heading in it, until the time of a program is used up."""

    def __init__(self, rng, machine_, plane="G17"):
        self.rng, self.machine, self.plane = rng, machine_, plane
        self.place = [0.0, 0.0, 0.0]
        self.heading = rng.uniform(0, 2 * math.pi)
        self.feed = rounded(logarithmic(rng, 10, 250), 4)
        self.lines = [] if plane == "G17" else [plane]
        self.time = 0.0
        self.feed_due = True

    def note_time(self, length, radius=math.inf):
        fastest = min(self.feed, self.machine.slowest_velocity, math.sqrt(self.machine.slowest * min(radius, 1e9) / 2))
        self.time += max(length / fastest, math.sqrt(2 * length / self.machine.slowest))

    def is_done(self):
        return self.time > LONGEST_S

    def length(self, low=SHORTEST_MM, high=20.0):
        reached = min(self.feed * LONGEST_S / 3, self.machine.slowest * LONGEST_S ** 2 / 8)
        return logarithmic(self.rng, low, max(2 * low, min(high, reached)))

    def turn(self, low=0.1, high=170.0):
        """A kink [deg], either way."""
        self.heading += math.radians(logarithmic(self.rng, low, high)) * self.rng.choice([-1, 1])

    def change_feed(self, probability=0.15):
        if self.rng.random() < probability:
            self.feed = rounded(logarithmic(self.rng, 10, 250), 4)
            self.feed_due = True

    def feed_word(self):
        due, self.feed_due = self.feed_due, False
        return f" F{number(self.feed * 60)}" if due else ""

    def words(self, old):
        return "".join(f" {letter}{number(new)}" for letter, new, before in zip(LINEAR, self.place, old) if new != before)

    def line(self, length, rise=0.0, word="G1"):
        u, v, w = PLANES[self.plane]
        old = list(self.place)
        self.place[u] = round(self.place[u] + length * math.cos(self.heading), 6)
        self.place[v] = round(self.place[v] + length * math.sin(self.heading), 6)
        self.place[w] = round(self.place[w] + rise, 6)
        if self.place == old:
            return
        self.note_time(math.dist(old, self.place))
        self.lines.append(word + self.words(old) + (self.feed_word() if word == "G1" else ""))

    def arc(self, radius, sweep, rise=0.0):
        """`sweep` [rad], counter-clockwise where it is above 0."""
        u, v, w = PLANES[self.plane]
        side = math.copysign(1, sweep)
        center = (-side * radius * math.sin(self.heading), side * radius * math.cos(self.heading))
        self.heading += sweep
        old = list(self.place)
        self.place[u] = round(old[u] + center[0] + side * radius * math.sin(self.heading), 6)
        self.place[v] = round(old[v] + center[1] - side * radius * math.cos(self.heading), 6)
        self.place[w] = round(old[w] + rise, 6)
        self.note_time(math.hypot(radius * sweep, rise), radius)
        letters = "IJK"
        ends = "".join(f" {LINEAR[i]}{number(self.place[i])}" for i in sorted((u, v)))
        ends += f" {LINEAR[w]}{number(self.place[w])}" if rise else ""
        offsets = f" {letters[u]}{number(center[0])} {letters[v]}{number(center[1])}"
        self.lines.append(("G3" if sweep > 0 else "G2") + ends + offsets + self.feed_word())

    def random_arc(self, rise=0.0, high_turn=340.0):
        radius = logarithmic(self.rng, 0.3, 50)
        sweep = math.radians(logarithmic(self.rng, 3, high_turn))
        sweep = min(sweep, min(self.feed, math.sqrt(self.machine.slowest * radius / 2)) * LONGEST_S / 2 / radius)
        self.arc(radius, self.rng.choice([-1, 1]) * sweep, rise)


def any_plane(rng):
    return rng.choice(["G17", "G17", "G18", "G19"])


def lines(rng, machine_):
    pen = Pen(rng, machine_, any_plane(rng))
    in_space = rng.random() < 0.5
    while not pen.is_done():
        pen.change_feed()
        length = pen.length()
        pen.line(length, rng.uniform(-1, 1) * length if in_space else 0)
        pen.turn()
    return [mode(rng, 0.3)] + pen.lines


def short_lines(rng, machine_):
    """As of a smooth curve: some become one block, some do not."""
    pen = Pen(rng, machine_)
    length = logarithmic(rng, 0.03, 1.5)
    while not pen.is_done() and len(pen.lines) < 150:
        pen.line(length * rng.uniform(0.5, 1.5), rng.choice([0, 0, 0.05]) * length)
        pen.turn(0.1, 20)
    return [mode(rng, 0.7)] + pen.lines


def arcs_and_lines(rng, machine_):
    """Half of the joints tangential."""
    pen = Pen(rng, machine_, any_plane(rng))
    while not pen.is_done():
        pen.change_feed()
        if rng.random() < 0.5:
            pen.line(pen.length())
        else:
            pen.random_arc()
        if rng.random() < 0.5:
            pen.turn()
    return [mode(rng, 0.3)] + pen.lines


def arcs(rng, machine_):
    """Arc meets arc."""
    pen = Pen(rng, machine_, any_plane(rng))
    small = rng.random() < 0.5
    while not pen.is_done():
        pen.random_arc()
        pen.turn(0.1, 5 if small else 170)
    return [mode(rng, 0.2)] + pen.lines


def shallow_arcs(rng, machine_):
    """Their height is around Q, with and without a rise, in every plane."""
    pen = Pen(rng, machine_, any_plane(rng))
    naive = logarithmic(rng, 0.002, 0.1)
    rises = rng.random() < 0.6
    while not pen.is_done():
        radius = logarithmic(rng, 5, 300)
        height = naive * logarithmic(rng, 0.2, 3)
        sweep = 2 * math.acos(1 - min(height / radius, 1))
        pen.arc(radius, rng.choice([-1, 1]) * sweep, rng.uniform(-0.5, 0.5) * radius * sweep if rises else 0)
        if rng.random() < 0.3:
            pen.line(pen.length(0.1, 3))
        pen.turn(0.1, 30)
    return [f"G64 P{number(logarithmic(rng, 0.002, 0.2))} Q{number(naive)}"] + pen.lines


def helices(rng, machine_):
    pen = Pen(rng, machine_, any_plane(rng))
    while not pen.is_done():
        radius = logarithmic(rng, 0.5, 30)
        sweep = min(math.radians(logarithmic(rng, 20, 355)), pen.feed * LONGEST_S / 2 / radius)
        pen.arc(radius, rng.choice([-1, 1]) * sweep, rng.uniform(-1, 1) * radius * min(sweep, 1))
        if rng.random() < 0.4:
            pen.turn()
        if rng.random() < 0.3:
            pen.line(pen.length())
    return [mode(rng, 0.2)] + pen.lines


def exact(rng, machine_):
    pen = Pen(rng, machine_)
    while not pen.is_done():
        pen.change_feed()
        if rng.random() < 0.7:
            pen.line(pen.length())
        else:
            pen.random_arc()
        if rng.random() < 0.7:
            pen.turn()
    return [rng.choice(["G61", "G61", "G61.1"])] + pen.lines


def modes(rng, machine_):
    """The path control changes on the way."""
    pen = Pen(rng, machine_)
    pen.lines.append(mode(rng))
    while not pen.is_done():
        if rng.random() < 0.35:
            pen.lines.append(rng.choice(["G61", "G61.1", mode(rng), mode(rng), mode(rng)]))
        pen.line(pen.length(high=8))
        pen.turn()
    return pen.lines


def waits(rng, machine_):
    """Dwells, spindle and coolant between blocks."""
    pen = Pen(rng, machine_)
    while not pen.is_done():
        pen.line(pen.length())
        pen.turn()
        if rng.random() < 0.4:
            pen.lines.append(rng.choice([f"G4 P{number(round(rng.uniform(0.01, 0.2), 3))}", "M8", "M9", "S1000 M3", "S900", "M5"]))
    pen.line(pen.length())
    return [mode(rng)] + pen.lines


def rapids(rng, machine_):
    pen = Pen(rng, machine_)
    while not pen.is_done():
        pen.line(pen.length(), rng.choice([0, 1, -1]) * rng.uniform(0, 3), rng.choice(["G0", "G0", "G1"]))
        pen.turn()
    return [mode(rng)] + pen.lines


def cycles(rng, machine_):
    """Drilling; some return to the first height, some to the retract plane."""
    feed = rounded(logarithmic(rng, 10, 100), 3) * 60
    depth = -rng.uniform(0.5, 3)
    word = rng.choice(["G81", "G82", "G83", "G73", "G85", "G89"])
    more = {"G82": " P0.05", "G89": " P0.05", "G83": f" Q{number(-depth / 1.6)}", "G73": f" Q{number(-depth / 1.6)}"}.get(word, "")
    hole = lambda: f"X{number(rng.uniform(-10, 10))} Y{number(rng.uniform(-10, 10))}"
    first = f"{rng.choice(['G98', 'G99'])} {word} {hole()} Z{number(depth)} R{number(rng.uniform(0.2, 1))}{more} F{number(feed)}"
    return [mode(rng), "G0 Z2", first] + [hole() for _ in range(rng.randint(0, 2))] + ["G80", "G0 Z3"]


def compensation(rng, machine_):
    """A tool of its own diameter around a contour of lines and arcs; outside or inside corners, tangential arcs."""
    diameter = logarithmic(rng, 0.2, 4)
    side = rng.choice(["G41.1", "G42.1"])
    pen = Pen(rng, machine_)
    pen.heading = rng.uniform(0, 2 * math.pi)
    pen.line(2 * diameter)
    pen.lines[-1] = f"{side} D{number(diameter)}\n" + pen.lines[-1]
    for _ in range(rng.randint(3, 7)):
        pen.turn(2, 100)
        if rng.random() < 0.3:
            pen.arc(diameter * rng.uniform(1.2, 4), rng.choice([-1, 1]) * math.radians(rng.uniform(20, 150)))
        else:
            pen.line(diameter * rng.uniform(2.5, 8))
    pen.lines.append("G40")
    pen.line(2 * diameter)
    return [mode(rng, 0.2)] + "\n".join(pen.lines).split("\n")


def rotary(rng, machine_):
    """Linear and rotary axes together, and each of them alone."""
    pen = Pen(rng, machine_)
    turned = dict.fromkeys(ROTARY, 0.0)
    while not pen.is_done():
        words = []
        for axis in ROTARY:
            if rng.random() < 0.5:
                turned[axis] += rng.uniform(-15, 15)
                words.append(f" {axis}{number(turned[axis])}")
        if words and rng.random() < 0.2:
            pen.lines.append("G1" + "".join(words) + pen.feed_word())
            pen.time += 0.2
            continue
        before = len(pen.lines)
        pen.line(pen.length())
        if len(pen.lines) > before and words:
            pen.lines[-1] = pen.lines[-1].replace(" F", "".join(words) + " F") if " F" in pen.lines[-1] else pen.lines[-1] + "".join(words)
        pen.turn()
    return [mode(rng, 0.3)] + pen.lines


KINDS = {kind.__name__.replace("_", " "): kind for kind in
         (lines, short_lines, arcs_and_lines, arcs, shallow_arcs, helices, exact, modes, waits, rapids, cycles, compensation, rotary)}


def programs(seed, count, machine_):
    """The programs that belong to a seed, kinds in turns."""
    names = list(KINDS)
    for index in range(count):
        kind = names[index % len(names)]
        text = KINDS[kind](random.Random(f"program {seed} {index}"), machine_)
        alone = any(re.fullmatch(r"G1( [AC]\S+)+( F\S+)?", line) for line in text)
        yield Program(kind + " alone" if alone else kind, text)
