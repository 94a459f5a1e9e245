"""Ways to spoil a text, each drawn from a random.Random so that a seed repeats it."""

import pathlib
import re

NUMBER = re.compile(rb"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
# Ends of ranges of readers and models, and what people type by a slip.
NUMBERS = [b"0", b"-0", b"-1", b"1", b".5", b"1.", b"0.0000001", b"1e-300", b"99999", b"1e6", b"1e9", b"7000000", b"2147483647",
           b"-2147483649", b"4294967296", b"999999999999", b"1e308", b"1e999", b"nan", b"inf", b"", b"1.2.3", b"1,5", b"--2"]
BYTES = [b"\x00", b"\xff", b"\xc3", b"\r", b"\t", b"(", b")", b"[", b"]", b"\"", b"'", b";", b"=", b"#", b"%", b"{", b"}", b" "]
ESCAPED = re.compile(rb"\\x([0-9a-fA-F]{2})|\\(.)")


def dictionary(file):
    """The words of a libFuzzer dictionary."""
    unescape = lambda found: bytes([int(found[1], 16)]) if found[1] else found[2]
    return [ESCAPED.sub(unescape, word) for word in re.findall(rb'^[^#\n]*?"(.*)"\s*$', pathlib.Path(file).read_bytes(), re.M)]


def piece(text, rng, most):
    """The head of a text and some lines in a row of the rest, `most` lines in all."""
    lines = text.splitlines(keepends=True)
    head = min(10, most // 2)
    if len(lines) <= most:
        return text
    begin = rng.randint(head, len(lines) - (most - head))
    return b"".join(lines[:head] + lines[begin:begin + most - head])


def _number(text, rng, words):
    found = list(NUMBER.finditer(text))
    if not found:
        return text
    one = rng.choice(found)
    try:
        other = b"%.6g" % (float(one[0]) * rng.choice([-1, 0.001, 0.1, 0.99, 1.01, 10, 1000, 1e6]))
    except (ValueError, OverflowError):
        other = b"0"
    return text[:one.start()] + rng.choice(NUMBERS + 10 * [other]) + text[one.end():]


def _word(text, rng, words):
    at = rng.randint(0, len(text))
    word = rng.choice(words or BYTES)
    return text[:at] + rng.choice([word, b" " + word + b" ", b"\n" + word + b"\n"]) + text[at:]


def _bytes(text, rng, words):
    spoilt = bytearray(text)
    for _ in range(rng.randint(1, 4)):
        if spoilt:
            at = rng.randrange(len(spoilt))
            spoilt[at:at + 1] = rng.choice([b"", bytes([rng.randrange(256)]), rng.choice(BYTES)])
    return bytes(spoilt)


def _lines(text, rng, words):
    lines = text.splitlines(keepends=True)
    if len(lines) < 2:
        return text
    a, b = sorted(rng.sample(range(len(lines)), 2))
    return b"".join(rng.choice([lambda: lines[:a] + lines[a + 1:],                           # one is missing
                                lambda: lines[:a] + lines[b:],                               # several are
                                lambda: lines[:a] + lines[a:b] * rng.randint(2, 5) + lines[b:],
                                lambda: lines[:a] + [lines[b]] + lines[a + 1:b] + [lines[a]] + lines[b + 1:],
                                lambda: lines[:a] + [lines[a].rstrip(b"\r\n")] + lines[a + 1:],
                                lambda: lines[:b]])())


def _tokens(text, rng, words):
    """A word of the text at another place of it."""
    found = list(re.finditer(rb"[A-Za-z_]+[-+.\d]*", text))
    if not found:
        return text
    one, other = rng.choice(found), rng.choice(found)
    return text[:one.start()] + rng.choice([other[0], b""]) + text[one.end():]


def mutated(text, rng, words=(), others=()):
    """`text` (bytes), spoilt one to six times; `words`: what may be put in; `others`: texts of which it may get a part."""
    ways = [_number] * 5 + [_word, _bytes, _lines, _lines, _tokens]
    for _ in range(rng.choice([1, 1, 1, 2, 3, 6])):
        if others and rng.random() < 0.1:
            at = rng.randint(0, len(text))
            text = text[:at] + piece(rng.choice(others), rng, 20) + text[at:]
        else:
            text = rng.choice(ways)(text, rng, words)
    return text
