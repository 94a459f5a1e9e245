"""Klipper's look-ahead once more, from the published description alone, to check the model `klipper` with.

Reads programs of G0 to G4, G17 to G19, G90 to G92, M204, M220, M400 and SET_VELOCITY_LIMIT; E words are left out. Millimetres and
seconds; `printer` is a section of printer.cfg.
"""
import math
import re


class Move:
    """A straight move: length, unit vector and what may change of the speed squared on it."""

    def __init__(self, start, end, feed, limits):
        way = [b - a for a, b in zip(start, end)]
        self.length = math.sqrt(sum(w * w for w in way))
        # By the reciprocal, as Klipper does: its last bit decides whether a straight joint is one.
        self.unit = [w * (1 / self.length) for w in way] if self.length > 0 else way
        self.limits = limits
        speed = min(feed, limits["max_velocity"])
        self.acceleration = limits["max_accel"]
        if way[2] and self.length > 0:
            share = self.length / abs(way[2])
            speed = min(speed, limits["max_z_velocity"] * share)
            self.acceleration = min(self.acceleration, limits["max_z_accel"] * share)
        self.top = speed**2
        self.change = 2 * self.length * self.acceleration
        smooth = limits["max_accel"] * (1 - limits["minimum_cruise_ratio"])
        self.smooth_change = min(self.change, 2 * self.length * smooth)
        self.deviation = limits["square_corner_velocity"] ** 2 * (math.sqrt(2) - 1) / limits["max_accel"]
        self.limit = self.smooth_limit = 0.0

    def join(self, before):
        """The most that the speed squared may be where this move begins."""
        cosine = -sum(a * b for a, b in zip(self.unit, before.unit))
        sine = math.sqrt(max(0.5 * (1 - cosine), 0))
        half = math.sqrt(max(0.5 * (1 + cosine), 0))
        self.limit = min(self.top, before.top, before.limit + before.change)
        if sine < 1 and half > 0:
            radius = sine / (1 - sine)
            tangent = sine / half
            self.limit = min(
                self.limit,
                radius * self.deviation * self.acceleration,
                radius * before.deviation * before.acceleration,
                self.change * tangent / 4,
                before.change * tangent / 4,
            )
        self.smooth_limit = min(self.limit, before.smooth_limit + before.smooth_change)


def plan(moves):
    """Seconds from standstill to standstill."""
    for before, move in zip(moves, moves[1:]):
        move.join(before)
    planned = []
    end = smooth_end = peak = 0.0
    pending = 0
    for move in reversed(moves):
        reach = end + move.change
        start = min(move.limit, reach)
        smooth_reach = smooth_end + move.smooth_change
        smooth_start = min(move.smooth_limit, smooth_reach)
        pending += 1
        cruise = None
        if smooth_start < smooth_reach:
            if smooth_start + move.smooth_change > smooth_end or pending > 1:
                peak = (smooth_start + smooth_reach) / 2
            cruise = min((start + reach) / 2, move.top, peak)
            pending = 0
        planned.append((move, start, cruise, end))
        end, smooth_end = start, smooth_start
    seconds = 0.0
    before = 0.0
    for move, start, cruise, end in reversed(planned):
        if cruise is None:
            cruise = min(before, start)
        before = cruise
        start, end = min(start, cruise), min(end, cruise)
        v0, v, v1 = (math.sqrt(x) for x in (start, cruise, end))
        up = (cruise - start) / (2 * move.acceleration)
        down = (cruise - end) / (2 * move.acceleration)
        level = move.length - up - down
        for way, speed in ((up, (v0 + v) / 2), (level, v), (down, (v + v1) / 2)):
            seconds += way / speed if way > 0 else 0
    return seconds


class Reader:
    def __init__(self, printer, resolution):
        self.limits = dict(printer)
        self.resolution = resolution
        self.place = [0.0, 0.0, 0.0]
        self.origin = [0.0, 0.0, 0.0]
        self.incremental = False
        self.plane = (0, 1, 2)
        self.speed = 25.0
        self.factor = 1.0
        self.moves = []
        self.seconds = 0.0

    def stop(self, seconds=0.0):
        self.seconds += plan(self.moves) + seconds
        self.moves = []

    def go(self, target):
        move = Move(self.place, target, self.speed, self.limits)
        self.place = list(target)
        if move.length >= 1e-9:
            self.moves.append(move)

    def target(self, words):
        target = list(self.place)
        for axis, letter in enumerate("XYZ"):
            if letter in words:
                target[axis] = words[letter] + (self.place if self.incremental else self.origin)[axis]
        return target

    def arc(self, words, clockwise):
        """Chords by the angle from the start; the last one ends at the programmed end, wherever that is."""
        a, b, third = self.plane
        offsets = [words.get("IJK"[axis], 0.0) for axis in (a, b)]
        if self.incremental or "R" in words or offsets == [0, 0]:
            return
        target = self.target(words)
        if "F" in words:
            self.speed = words["F"] * self.factor / 60
        spoke = [-offset for offset in offsets]
        centre = [self.place[axis] - s for axis, s in zip((a, b), spoke)]
        out = [target[axis] - c for axis, c in zip((a, b), centre)]
        angle = math.atan2(spoke[0] * out[1] - spoke[1] * out[0], spoke[0] * out[0] + spoke[1] * out[1])
        if angle < 0:
            angle += 2 * math.pi
        if clockwise:
            angle -= 2 * math.pi
        if angle == 0 and target[a] == self.place[a] and target[b] == self.place[b]:
            angle = 2 * math.pi
        rise = target[third] - self.place[third]
        length = math.hypot(angle * math.hypot(*spoke), rise)
        chords = max(1, math.floor(length / self.resolution))
        bottom = self.place[third]
        for i in range(1, chords):
            c, s = math.cos(i * angle / chords), math.sin(i * angle / chords)
            point = [0.0, 0.0, 0.0]
            point[a] = centre[0] + spoke[0] * c - spoke[1] * s
            point[b] = centre[1] + spoke[0] * s + spoke[1] * c
            point[third] = bottom + i * rise / chords
            self.go(point)
        self.go(target)

    def line(self, text):
        text = text.split(";")[0].strip().upper()
        if not text[:1].isalpha():
            return
        pairs = re.findall(r"([A-Z_]+)\s*=?\s*([-+]?[\d.]*)", text)
        if pairs and pairs[0][0] == "N":
            pairs = pairs[1:]
        if not pairs:
            return
        command = pairs[0][0] + pairs[0][1]
        words = {key: float(value) for key, value in pairs[1:] if value not in ("", "-", "+", ".")}
        if command in ("G0", "G1"):
            target = self.target(words)
            if "F" in words:
                if words["F"] <= 0:
                    return
                self.speed = words["F"] * self.factor / 60
            self.go(target)
        elif command in ("G2", "G3"):
            self.arc(words, command == "G2")
        elif command == "G4":
            self.stop(words.get("P", 0) / 1000)
        elif command in ("G17", "G18", "G19"):
            self.plane = {"G17": (0, 1, 2), "G18": (0, 2, 1), "G19": (1, 2, 0)}[command]
        elif command in ("G90", "G91"):
            self.incremental = command == "G91"
        elif command == "G92":
            for axis, letter in enumerate("XYZ"):
                if letter in words:
                    self.origin[axis] = self.place[axis] - words[letter]
        elif command == "M220":
            factor = words.get("S", 100) / 100
            self.speed *= factor / self.factor
            self.factor = factor
        elif command == "M400":
            self.stop()
        elif command == "M204":
            value = words["S"] if "S" in words else min(words["P"], words["T"])
            self.limits = {**self.limits, "max_accel": value}
        elif command == "SET_VELOCITY_LIMIT":
            names = {
                "VELOCITY": "max_velocity",
                "ACCEL": "max_accel",
                "SQUARE_CORNER_VELOCITY": "square_corner_velocity",
                "MINIMUM_CRUISE_RATIO": "minimum_cruise_ratio",
            }
            self.limits = {**self.limits, **{names[key]: value for key, value in words.items()}}


def seconds(program, configuration):
    """Of a program's text on a configuration as in klipper_configurations.json."""
    reader = Reader(configuration["[printer]"], configuration["[gcode_arcs]"]["resolution"])
    for line in program.splitlines():
        reader.line(line)
    reader.stop()
    return reader.seconds
