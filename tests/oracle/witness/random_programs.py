"""Small random programs and configurations for the controls grbl and Klipper, each from its seed."""
import math
import random


def spread(dice, low, high):
    """Evenly over the powers of ten."""
    return math.exp(dice.uniform(math.log(low), math.log(high)))


def digits(number, count=4):
    """Of a configuration, short enough to be read by people."""
    return float(f"{number:.{count}g}")


def klipper_configuration(dice):
    velocity = digits(spread(dice, 30, 500))
    acceleration = digits(spread(dice, 100, 20000))
    return {
        "[printer]": {
            "max_velocity": velocity,
            "max_accel": acceleration,
            "square_corner_velocity": dice.choice([0.0, 1.0, 5.0, digits(spread(dice, 0.1, 30))]),
            "minimum_cruise_ratio": dice.choice([0.0, 0.5, round(dice.uniform(0, 0.95), 2)]),
            "max_z_velocity": dice.choice([velocity, digits(spread(dice, 3, velocity))]),
            "max_z_accel": dice.choice([acceleration, digits(spread(dice, 20, acceleration))]),
        },
        "[gcode_arcs]": {"resolution": dice.choice([1.0, 0.1, digits(spread(dice, 0.05, 5))])},
    }


def grbl_configuration(dice):
    settings = {
        "$1": dice.choice([25, 0, dice.randint(1, 254)]),
        "$11": dice.choice([0.01, digits(spread(dice, 0.001, 0.2))]),
        "$12": dice.choice([0.002, digits(spread(dice, 0.0005, 0.05))]),
    }
    for axis in range(3):
        settings[f"${100 + axis}"] = dice.choice([80, 250, digits(spread(dice, 20, 800))])
        settings[f"${110 + axis}"] = digits(spread(dice, 300, 15000))
        settings[f"${120 + axis}"] = digits(spread(dice, 10, 3000))
    if dice.random() < 0.5:  # axes alike
        for first in (100, 110, 120):
            for axis in (1, 2):
                settings[f"${first + axis}"] = settings[f"${first}"]
    return {"settings": settings}


class Program:
    """Writes blocks from place to place; numbers are rounded as a CAM system rounds them."""

    def __init__(self, dice, control):
        self.dice = dice
        self.klipper = control == "klipper"
        self.place = [0.0, 0.0, 0.0]
        self.plane = 17
        self.incremental = False
        self.direction = dice.uniform(0, 2 * math.pi)
        self.size = spread(dice, 0.05, 40)  # of blocks [mm]
        self.decimals = dice.choice([3, 4])
        self.lines = ["G21 G90" if control == "grbl" else "G90", f"G1 F{self.feed()}"]

    def feed(self):
        return round(spread(self.dice, 50, 15000))

    def words(self, letters, end):
        """Axis words of the end, and where they lead to."""
        text = ""
        for letter in letters:
            axis = "XYZ".index(letter)
            value = round(end[axis] - (self.place[axis] if self.incremental else 0), self.decimals)
            text += f" {letter}{value:.{self.decimals}f}"
            self.place[axis] = value + (self.place[axis] if self.incremental else 0)
        return text

    def line(self):
        turn = self.dice.choice([0.0, self.dice.gauss(0, 0.1), self.dice.uniform(-math.pi, math.pi), math.pi / 2])
        self.direction += turn
        length = self.size * spread(self.dice, 0.2, 5)
        end = list(self.place)
        end[0] += length * math.cos(self.direction)
        end[1] += length * math.sin(self.direction)
        letters = self.dice.choice(["XY", "XY", "XY", "XYZ", "Z"])
        if "Z" in letters:
            end[2] += length * self.dice.uniform(-1, 1)
        feed = f" F{self.feed()}" if self.dice.random() < 0.15 else ""
        self.lines.append(self.dice.choice(["G1", "G1", "G1", "G0"]) + self.words(letters, end) + feed)

    def short_lines(self):
        """A curve as a CAM system writes it."""
        step = spread(self.dice, 0.02, 1)
        bend = self.dice.gauss(0, 0.1)
        for _ in range(self.dice.randint(10, 40)):
            self.direction += bend + self.dice.gauss(0, 0.01)
            end = list(self.place)
            end[0] += step * math.cos(self.direction)
            end[1] += step * math.sin(self.direction)
            self.lines.append("G1" + self.words("XY", end))

    def arc(self):
        if self.incremental and self.klipper:
            return
        a, b, third = {17: (0, 1, 2), 18: (0, 2, 1), 19: (1, 2, 0)}[self.plane]
        radius = self.size * spread(self.dice, 0.1, 5)
        begin = self.dice.uniform(0, 2 * math.pi)
        full = self.dice.random() < 0.2
        sweep = 2 * math.pi if full else self.dice.uniform(-2 * math.pi, 2 * math.pi)
        end = list(self.place)
        offset = [round(radius * math.cos(begin), self.decimals), round(radius * math.sin(begin), self.decimals)]
        if not full:
            for axis, o, spoke in ((a, offset[0], math.cos), (b, offset[1], math.sin)):
                end[axis] += o - radius * spoke(begin + sweep)
        if self.dice.random() < 0.2:
            end[third] += radius * self.dice.uniform(-1, 1)
        if self.dice.random() < 0.05:  # what no CAM system writes: the end is off the circle
            share = self.dice.choice([0.0, 0.5, 1.5, 3.0])
            for axis, o in ((a, offset[0]), (b, offset[1])):
                end[axis] = self.place[axis] + o * (1 - share)
        centre = f" {'IJK'[a]}{offset[0]:.{self.decimals}f} {'IJK'[b]}{offset[1]:.{self.decimals}f}"
        if not self.klipper and not full and self.dice.random() < 0.3:
            centre = f" R{radius if abs(sweep) < math.pi else -radius:.{self.decimals}f}"
        begun = list(self.place)
        words = self.words("".join("XYZ"[axis] for axis in sorted((a, b, third))), end)
        refused = math.hypot(self.place[a] - begun[a] - offset[0], self.place[b] - begun[b] - offset[1]) - radius
        self.lines.append(("G3" if sweep > 0 else "G2") + words + centre)
        if not self.klipper and self.incremental and abs(refused) > 0.004:
            self.incremental = False  # the control may not be where it was sent to
            self.lines.append("G90")

    def switch(self):
        if self.klipper:
            choices = [
                f"G4 P{self.dice.randint(0, 300)}",
                f"M204 S{round(spread(self.dice, 100, 20000))}",
                f"SET_VELOCITY_LIMIT VELOCITY={round(spread(self.dice, 20, 500))}",
                f"SET_VELOCITY_LIMIT SQUARE_CORNER_VELOCITY={round(spread(self.dice, 0.5, 20), 2)}",
                f"SET_VELOCITY_LIMIT MINIMUM_CRUISE_RATIO={round(self.dice.uniform(0, 0.9), 2)}",
                f"M220 S{self.dice.randint(20, 200)}",
                "M400",
            ]
        else:
            choices = [
                f"G4 P{round(self.dice.uniform(0, 1), 2)}",
                f"M3 S{self.dice.randint(1, 9) * 1000}",
                "M5",
                "M0",
            ]
        self.lines.append(self.dice.choice(choices))

    def change_plane(self):
        self.plane = self.dice.choice([17, 17, 18, 19])
        self.lines.append(f"G{self.plane}")

    def change_distances(self):
        self.incremental = not self.incremental
        self.lines.append("G91" if self.incremental else "G90")

    def write(self):
        steps = [self.line] * 12 + [self.short_lines] * 2 + [self.arc] * 5 + [self.switch] * 2
        steps += [self.change_plane, self.change_distances]
        for _ in range(self.dice.randint(3, 25)):
            self.dice.choice(steps)()
        return "\n".join(self.lines + ["M30" if not self.klipper else "M400"]) + "\n"


def random_case(control, seed):
    """Configuration and program."""
    dice = random.Random(f"{control} {seed}")
    configuration = klipper_configuration(dice) if control == "klipper" else grbl_configuration(dice)
    return configuration, Program(dice, control).write()
