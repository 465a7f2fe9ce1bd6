#!/usr/bin/env python3
"""The solver beside its peer, on one list of requests, in one run.

    compare.py [REQUESTS.jsonl] [--first N] [--mintime PATH]

Without a file: the paper's dashes, flips and (5, 5). Both solve the same requests one after the other on this machine. For
each, both times, both durations and their ratios are printed, then medians. The peer's duration is `T_checked_s`, its
controls re-integrated exactly; where it did not converge it has none. Times are wall time: the solver's for the fastest
maneuver and every winding that could have won, verified and packed; the peer's for its three end angles, without building
its program.
"""

import argparse
import json
import pathlib
import statistics
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent


def standard():
    places = [(3, 0), (6, 0), (9, 0), (12, 0), (15, 0), (0, 1), (0, 2), (0, 2.7), (0, 4), (0, 6), (5, 5), (2, 3), (1, -2),
              (10, -5)]
    for x, z in places:
        yield {"name": f"{x},{z}", "from": [0] * 5, "to": [x, 0, z, 0, 0], "thrust": [1, 20], "rate": 10, "gravity": 9.81}


def answers(command, requests):
    text = "\n".join(json.dumps(request) for request in requests)
    done = subprocess.run(command, input=text, capture_output=True, text=True, check=False)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    if len(lines) != len(requests):
        sys.exit(f"{command[0]} answered {len(lines)} of {len(requests)} requests: {done.stderr.strip()}")
    return lines


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("requests", nargs="?")
    arguments.add_argument("--first", type=int)
    arguments.add_argument("--mintime", default=HERE.parent / "target/release/mintime")
    given = arguments.parse_args()
    fields = ("name", "from", "to", "thrust", "rate", "gravity", "turns")
    if given.requests:
        lines = pathlib.Path(given.requests).read_text(encoding="utf-8").splitlines()
        requests = [{k: v for k, v in json.loads(line).items() if k in fields} for line in lines if line.strip()]
    else:
        requests = list(standard())
    requests = requests[: given.first]

    ours = answers([given.mintime, "solve", "--batch", "/dev/stdin"], requests)
    peers = answers([sys.executable, HERE / "peer_multiple_shooting.py"], requests)
    print(f"{'request':<16}{'T (s)':>12}{'peer T (s)':>12}{'ratio':>10}{'time (ms)':>12}{'peer (ms)':>12}{'ratio':>10}")
    times, peer_times, ratios = [], [], []
    for us, peer in zip(ours, peers):
        ms, peer_ms = us.get("solve_time_s", float("nan")) * 1e3, peer["wall_s"] * 1e3
        times.append(ms)
        peer_times.append(peer_ms)
        ours_t, peer_t = us.get("duration_s"), peer.get("T_checked_s")
        ratio = peer_t / ours_t if ours_t and peer_t else None
        if ratio:
            ratios.append(ratio)
        shown = [f"{value:.6f}" if value else "none" for value in (ours_t, peer_t, ratio)]
        print(f"{us['name']:<16}{shown[0]:>12}{shown[1]:>12}{shown[2]:>10}{ms:>12.3f}{peer_ms:>12.1f}{peer_ms / ms:>10.0f}")
    print(f"median time {statistics.median(times):.3f} ms, peer {statistics.median(peer_times):.1f} ms, "
          f"ratio {statistics.median(p / u for p, u in zip(peer_times, times)):.0f}")
    worse = sum(ratio > 1.001 for ratio in ratios)
    print(f"the peer is more than 0.1 % slower in {worse} of {len(ratios)} answers, and has none for {len(ours) - len(ratios)}")


if __name__ == "__main__":
    main()
