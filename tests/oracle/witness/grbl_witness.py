"""grbl 1.1's planner and step timing once more, from the published description alone, to check the model `grbl` with.

Reads G0 to G4, G17 to G21, G90, G91, M2 to M5, F and S; lines that grbl rejects do nothing. All numbers have 32 bits and are mm and
minutes, as in the control; results are seconds.
"""
import math
import re
import struct
from collections import deque

_FLOAT = struct.Struct("f")
TICK_HZ = 16e6
RING = 15  # blocks that are planned together
AHEAD = 5  # segments that are prepared


def f32(number):
    return _FLOAT.unpack(_FLOAT.pack(number))[0]


SEGMENT = f32(1 / 6000)  # 10 ms in minutes


def round_away(number):
    return int(math.copysign(math.floor(abs(number) + 0.5), number))


def unit(vector):
    """The unit vector and the length."""
    total = 0.0
    for x in vector:
        total = f32(total + f32(x * x))
    length = f32(math.sqrt(total))
    inverse = f32(1 / length)
    return [f32(x * inverse) for x in vector], length


def least(limits, direction):
    return min(abs(f32(limit / u)) for limit, u in zip(limits, direction) if u != 0)


class Grbl:
    def __init__(self, settings):
        self.steps_per_mm = [f32(settings[f"${100 + i}"]) for i in range(3)]
        self.rates = [f32(settings[f"${110 + i}"]) for i in range(3)]
        self.accelerations = [f32(f32(settings[f"${120 + i}"]) * 3600) for i in range(3)]
        self.deviation = f32(settings["$11"])
        self.tolerance = f32(settings["$12"])
        self.hold = settings["$1"] / 1000 if settings["$1"] != 255 else 0
        self.steps = [0, 0, 0]
        self.ring = deque()
        self.planned = 0
        self.before = None  # direction and nominal speed of the block queued last
        self.profile = False  # of the running block is known
        self.begun = False
        self.running = False
        self.ready = 0
        self.seconds = 0.0
        self.moved = False
        self.held = False  # a hold whose time counts as soon as motion follows

    # --- planning ---

    def junction(self, direction):
        cosine = 0.0
        across = []
        for a, b in zip(self.before[0], direction):
            cosine = f32(cosine - f32(a * b))
            across.append(f32(b - a))
        if cosine > f32(0.999999):
            return 0.0
        if cosine < f32(-0.999999):
            return math.inf
        acceleration = least(self.accelerations, unit(across)[0])
        sine = f32(math.sqrt(f32(0.5 * f32(1 - cosine))))
        return max(0.0, f32(f32(f32(acceleration * self.deviation) * sine) / f32(1 - sine)))

    def add(self, target, feed):
        """`feed` in mm/min; none of a rapid."""
        steps = [round_away(f32(t * s)) for t, s in zip(target, self.steps_per_mm)]
        delta = [b - a for a, b in zip(self.steps, steps)]
        if not any(delta):
            return
        direction, length = unit([f32(d / s) for d, s in zip(delta, self.steps_per_mm)])
        rapid = least(self.rates, direction)
        block = {
            "count": max(abs(d) for d in delta),
            "left": length,
            "a": least(self.accelerations, direction),
            "nominal": max(rapid if feed is None else min(feed, rapid), 1.0),
            "entry": 0.0,
            "most": 0.0,
        }
        if self.ring:
            nominal = min(block["nominal"], self.before[1])
            block["most"] = min(f32(nominal * nominal), self.junction(direction))
        self.before = direction, block["nominal"]
        self.steps = steps
        self.ring.append(block)
        self.replan()

    def replan(self):
        last = len(self.ring) - 1
        if last == self.planned:
            return
        gain = lambda block: f32(f32(2 * block["a"]) * block["left"])
        newest = self.ring[last]
        newest["entry"] = min(newest["most"], gain(newest))
        for i in range(last - 1, self.planned, -1):
            block = self.ring[i]
            if block["entry"] != block["most"]:
                block["entry"] = min(block["most"], f32(self.ring[i + 1]["entry"] + gain(block)))
        if self.planned == 0 and self.profile:
            self.ring[0]["entry"] = f32(self.speed * self.speed)
            self.profile = False
        for i in range(self.planned, last):
            block, after = self.ring[i], self.ring[i + 1]
            if block["entry"] < after["entry"]:
                reached = f32(block["entry"] + gain(block))
                if reached < after["entry"]:
                    after["entry"] = reached
                    self.planned = i + 1
            if after["entry"] == after["most"]:
                self.planned = i + 1

    # --- segments ---

    def load(self):
        """The profile of the front block: where its ramps end, by the length left."""
        block = self.ring[0]
        if not self.begun:
            self.begun = True
            self.count_left = float(block["count"])
            self.per_mm = f32(self.count_left / block["left"])
            self.least_way = f32(1.25 / self.per_mm)
            self.carry = 0.0
            self.speed = f32(math.sqrt(block["entry"]))
        self.profile = True
        entry = block["entry"]
        leave = self.ring[1]["entry"] if len(self.ring) > 1 else 0.0
        nominal = f32(block["nominal"] * block["nominal"])
        half = f32(0.5 / block["a"])
        length = block["left"]
        self.leave = f32(math.sqrt(leave))
        self.phase = "up"
        self.top, self.level_at, self.down_at = self.speed, length, length
        meet = f32(0.5 * f32(length + f32(half * f32(entry - leave))))
        if meet <= 0:
            self.level_at = self.down_at = 0.0
            self.top = self.leave
        elif meet >= length:
            self.phase = "down"
        else:
            self.down_at = f32(half * f32(nominal - leave))
            if self.down_at < meet:
                self.top = block["nominal"]
                if entry == nominal:
                    self.phase = "level"
                else:
                    self.level_at = f32(length - f32(half * f32(nominal - entry)))
            else:
                self.level_at = self.down_at = meet
                self.top = f32(math.sqrt(f32(f32(f32(2 * block["a"]) * meet) + leave)))

    def follow(self, begin, left, time):
        """One phase for `time` or to its end: the length left then, and the time it took."""
        a = self.ring[0]["a"]
        change = f32(a * time)
        if self.phase == "up":
            ahead = f32(left - f32(time * f32(self.speed + f32(0.5 * change))))
            if ahead >= self.level_at:
                self.speed = f32(self.speed + change)
                return ahead, time
            time = f32(f32(2 * f32(begin - self.level_at)) / f32(self.speed + self.top))
            self.phase = "down" if self.level_at == self.down_at else "level"
            self.speed = self.top
            return self.level_at, time
        if self.phase == "level":
            ahead = f32(left - f32(self.top * time))
            if ahead >= self.down_at:
                return ahead, time
            self.phase = "down"
            return self.down_at, f32(f32(left - self.down_at) / self.top)
        if self.speed > change:
            ahead = f32(left - f32(time * f32(self.speed - f32(0.5 * change))))
            if ahead > 0:
                self.speed = f32(self.speed - change)
                return ahead, time
        time = f32(f32(2 * left) / f32(self.speed + self.leave))
        self.speed = self.leave
        return 0.0, time

    def segment(self):
        if not self.profile:
            self.load()
        block = self.ring[0]
        begin = left = block["left"]
        most = time = SEGMENT
        least_left = max(f32(left - self.least_way), 0.0)
        passed = 0.0
        while True:
            left, took = self.follow(begin, left, time)
            passed = f32(passed + took)
            if passed < most:
                time = f32(most - passed)
            elif left > least_left:
                most = f32(most + SEGMENT)
                time = f32(most - passed)
            else:
                break
            if left <= 0:
                break
        self.count_time(left, passed)
        block["left"] = left
        if left <= 0:
            self.ring.popleft()
            self.planned = max(self.planned - 1, 0)
            self.profile = self.begun = False

    def count_time(self, left, passed):
        after = f32(self.per_mm * left)
        whole = math.ceil(after)
        count = math.ceil(self.count_left) - whole
        time = f32(passed + self.carry)
        of_step = f32(time / f32(math.ceil(self.count_left) - after))
        period = math.ceil(f32(f32(TICK_HZ * 60) * of_step))
        level = 0 if period < 2000 else 1 if period < 4000 else 2 if period < 8000 else 3
        period = min(period >> level, 65535)
        self.seconds += (count << level) * (period + 1) / TICK_HZ
        self.count_left = float(whole)
        self.carry = f32(f32(whole - after) * of_step)

    def prepare(self):
        while self.ready < AHEAD and self.ring:
            self.segment()
            self.ready += 1

    def queue(self, target, feed):
        while True:
            if self.running:
                self.prepare()
            if len(self.ring) < RING:
                break
            if self.running:
                self.ready -= 1
            self.running = True
        if self.held:
            self.seconds += self.hold
            self.held = False
        before = len(self.ring)
        self.add(target, feed)
        self.moved = self.moved or len(self.ring) > before

    def sync(self, dwell=0.0):
        while self.ring:
            self.ready = 0
            self.prepare()
        self.ready = 0
        self.running = False
        self.held = self.held or self.moved
        self.moved = False
        self.seconds += dwell


PLANES = {17: (0, 1, 2), 18: (2, 0, 1), 19: (1, 2, 0)}


class Reader:
    def __init__(self, settings):
        self.grbl = Grbl(settings)
        self.place = [0.0, 0.0, 0.0]
        self.motion, self.plane, self.inch, self.incremental = 0, 17, False, False
        self.feed, self.spindle, self.speed = 0.0, 5, 0.0

    def line(self, text):
        text = re.sub(r"\(.*?\)|;.*|[\s/]", "", text.upper())
        words = re.findall(r"([A-Z])([-+]?[\d.]+)", text)
        if not words:
            return
        codes = [float(v) for letter, v in words if letter == "G"]
        switches = [int(float(v)) for letter, v in words if letter == "M"]
        values = {letter: f32(float(v)) for letter, v in words if letter not in "GM"}
        motion, plane, inch, incremental = self.motion, self.plane, self.inch, self.incremental
        for code in codes:
            if code in (0, 1, 2, 3):
                motion = int(code)
            elif code in (17, 18, 19):
                plane = int(code)
            elif code in (20, 21):
                inch = code == 20
            elif code in (90, 91):
                incremental = code == 91
        scale = f32(25.4) if inch else 1.0
        feed = f32(values["F"] * scale) if "F" in values else self.feed
        target = list(self.place)
        for axis, letter in enumerate("XYZ"):
            if letter in values:
                value = f32(values[letter] * scale)
                target[axis] = f32(value + self.place[axis]) if incremental else value
        moves = any(letter in values for letter in "XYZ")
        arc = None
        if moves and motion and feed == 0:
            return  # error 22
        if moves and motion in (2, 3):
            arc = self.arc(values, target, PLANES[plane], motion == 2, scale)
            if arc is None:
                return
        if self.spindle != 5 and values.get("S", self.speed) != self.speed:
            self.grbl.sync()
        self.speed = values.get("S", self.speed)
        for switch in switches:
            if switch in (3, 4, 5) and switch != self.spindle:
                self.grbl.sync()
                self.spindle = switch
        if 4 in codes:
            self.grbl.sync(math.ceil(f32(20 * values["P"])) / 20)
        self.motion, self.plane, self.inch, self.incremental = motion, plane, inch, incremental
        self.feed = feed
        if moves:
            self.place = target
            for point in arc or [target]:
                self.grbl.queue(point, feed if motion else None)
        if any(switch in (0, 1, 2, 30) for switch in switches):
            self.grbl.sync()

    def arc(self, values, target, axes, clockwise, scale):
        """The ends of the chords; none of an arc that is an error."""
        a, b, third = axes
        if "XYZ"[a] not in values and "XYZ"[b] not in values:
            return None  # error 26
        x, y = f32(target[a] - self.place[a]), f32(target[b] - self.place[b])
        if "R" in values:
            radius = f32(values["R"] * scale)
            if x == 0 and y == 0:
                return None  # error 33
            rest = f32(f32(f32(f32(4 * radius) * radius) - f32(x * x)) - f32(y * y))
            if rest < 0:
                return None  # error 34
            side = f32(f32(math.sqrt(rest)) / f32(math.hypot(x, y)))
            side = side if clockwise == (radius < 0) else -side
            offset = [f32(0.5 * f32(x - f32(y * side))), f32(0.5 * f32(y + f32(x * side)))]
            radius = abs(radius)
        else:
            if "IJK"[a] not in values and "IJK"[b] not in values:
                return None  # error 35
            offset = [f32(values.get("IJK"[axis], 0.0) * scale) for axis in (a, b)]
            radius = f32(math.hypot(*offset))
            off = abs(f32(f32(math.hypot(f32(x - offset[0]), f32(y - offset[1]))) - radius))
            if off > 0.005 and (off > 0.5 or off > f32(0.001 * radius)):
                return None  # error 33
        return self.chords(target, axes, offset, radius, clockwise)

    def chords(self, target, axes, offset, radius, clockwise):
        a, b, third = axes
        tolerance = self.grbl.tolerance
        start = list(self.place)
        centre = [f32(start[a] + offset[0]), f32(start[b] + offset[1])]
        spoke = [-offset[0], -offset[1]]
        out = [f32(target[a] - centre[0]), f32(target[b] - centre[1])]
        angle = f32(
            math.atan2(
                f32(f32(spoke[0] * out[1]) - f32(spoke[1] * out[0])), f32(f32(spoke[0] * out[0]) + f32(spoke[1] * out[1]))
            )
        )
        turn = f32(2 * math.pi)
        if clockwise:
            angle = f32(angle - turn) if angle >= -5e-7 else angle
        else:
            angle = f32(angle + turn) if angle <= 5e-7 else angle
        if 2 * radius <= tolerance:
            return [target]
        chord = f32(math.sqrt(f32(tolerance * f32(f32(2 * radius) - tolerance))))
        count = math.floor(f32(abs(f32(f32(0.5 * angle) * radius)) / chord))
        points = []
        if count > 0:
            step, rise = f32(angle / count), f32(f32(target[third] - start[third]) / count)
            c = f32(2 - f32(step * step))
            s = f32(f32(step * f32(1 / 6)) * f32(c + 4))
            c = f32(c * 0.5)
            height = start[third]
            since = 0
            for i in range(1, count):
                if since < 12:
                    spoke = [f32(f32(spoke[0] * c) - f32(spoke[1] * s)), f32(f32(spoke[0] * s) + f32(spoke[1] * c))]
                    since += 1
                else:
                    cosine, sine = f32(math.cos(f32(i * step))), f32(math.sin(f32(i * step)))
                    spoke = [
                        f32(f32(-offset[0] * cosine) + f32(offset[1] * sine)),
                        f32(f32(-offset[0] * sine) - f32(offset[1] * cosine)),
                    ]
                    since = 0
                height = f32(height + rise)
                point = [0.0, 0.0, 0.0]
                point[a], point[b], point[third] = f32(centre[0] + spoke[0]), f32(centre[1] + spoke[1]), height
                points.append(point)
        return points + [target]


def seconds(program, configuration):
    """Of a program's text on a configuration as in grbl_configurations.json."""
    reader = Reader(configuration["settings"])
    for line in program.splitlines():
        reader.line(line)
    reader.grbl.sync()
    return reader.grbl.seconds
