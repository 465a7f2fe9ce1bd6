#!/usr/bin/env python3
"""Golden upper bounds on the duration of minimum-time maneuvers.

    golden_upper_bounds.py generate    writes ../tests/data/golden/requests.jsonl

The requests are the data, the generator is how they came about: SEED and the code below reproduce the
file byte for byte (numpy's PCG64 stream), and `generate --check` compares without writing.
"""

import argparse
import json
import math
import pathlib
import sys

import numpy as np

SEED = 20120611
GOLDEN = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "golden"
REQUESTS = GOLDEN / "requests.jsonl"

GRAVITY = 9.81
THRUST = (1.0, 20.0)  # m/s^2, mass-normalised
RATE = 10.0  # rad/s


# ----------------------------------------------------------------------------------------------------------------------
# The requests


def rounded(values):
    """Six decimals, so that a request reads the same in every language; no negative zeros."""
    return [round(float(v), 6) + 0.0 for v in values]


def request(name, kind, start, end, thrust=THRUST, rate=RATE):
    return {
        "name": name,
        "class": kind,
        "from": rounded(start),
        "to": rounded(end),
        "thrust": rounded(thrust),
        "rate": rounded([rate])[0],
        "gravity": GRAVITY,
    }


def generate_requests():
    rng = np.random.default_rng(SEED)
    box = lambda: (rng.uniform(-15, 15), rng.uniform(-10, 10))
    speed = lambda: rng.uniform(-8, 8)
    angle = lambda: rng.uniform(-math.pi, math.pi)
    out = []

    # Rest to rest, anywhere in the box.
    for i in range(50):
        x, z = box()
        out.append(request(f"rest_{i:02}", "rest", [0] * 5, [x, 0, z, 0, 0]))

    # Moving starts and ends, any attitude.
    for i in range(50):
        x, z = box()
        start = [0, speed(), 0, speed(), angle()]
        end = [x, speed(), z, speed(), angle()]
        out.append(request(f"moving_{i:02}", "moving", start, end))

    # Other vehicles; every other one at rest at both ends.
    for i in range(40):
        thrust = rng.uniform(0.2, 6), rng.uniform(11.5, 45)
        rate = rng.uniform(3, 25)
        x, z = box()
        start = [0, speed(), 0, speed(), angle()]
        end = [x, speed(), z, speed(), angle()]
        if i % 2 == 0:
            start, end = [0] * 5, [x, 0, z, 0, 0]
        out.append(request(f"limits_{i:02}", "limits", start, end, thrust, rate))

    # Tiny moves, 1 cm to 10 cm, in any direction.
    for i in range(15):
        distance = 10 ** rng.uniform(-2, -1)
        direction = angle()
        end = [distance * math.cos(direction), 0, distance * math.sin(direction), 0, 0]
        out.append(request(f"tiny_{i:02}", "tiny", [0] * 5, end))

    # Straight up, straight down, straight to the side.
    for i in range(25):
        x, z = box()
        end = [0, 0, z, 0, 0] if i % 2 == 0 else [x, 0, 0, 0, 0]
        out.append(request(f"axis_{i:02}", "axis", [0] * 5, end))

    # Upside down at the start, at the end, at both; half of them exactly, half nearly; half of them moving.
    for i in range(20):
        x, z = box()
        flipped = lambda: rng.choice([-1, 1]) * math.pi + (rng.uniform(-0.3, 0.3) if i % 2 else 0)
        first, last = flipped(), flipped()
        start = [0, speed(), 0, speed(), first if i % 3 != 1 else 0]
        end = [x, speed(), z, speed(), last if i % 3 != 0 else 0]
        if i % 4 < 2:
            start[1] = start[3] = end[1] = end[3] = 0
        out.append(request(f"upside_down_{i:02}", "upside_down", start, end))
    return out


def lines(records):
    return "".join(json.dumps(r) + "\n" for r in records)


def generate(check):
    text = lines(generate_requests())
    if check:
        same = REQUESTS.read_text() == text
        print("requests.jsonl agrees with the generator" if same else "requests.jsonl differs from the generator")
        return 0 if same else 1
    GOLDEN.mkdir(parents=True, exist_ok=True)
    REQUESTS.write_text(text)
    print(f"{REQUESTS}: {text.count(chr(10))} requests")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    p = commands.add_parser("generate", help="write the requests")
    p.add_argument("--check", action="store_true", help="compare with the stored file, write nothing")
    args = parser.parse_args()
    if args.command == "generate":
        return generate(args.check)


if __name__ == "__main__":
    sys.exit(main())
