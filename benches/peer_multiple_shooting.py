#!/usr/bin/env python3
"""Minimum-time maneuvers the way one would write them today: CasADi, IPOPT, multiple shooting.

    peer_multiple_shooting.py [REQUESTS.jsonl] [-n N]      (standard input without a file)

State (x, vx, z, vz, theta) at N + 1 nodes, pitch rate and thrust constant on N intervals, one RK4 step each, the
duration free. The first guess is the one everybody starts with: states on a straight line, hover thrust, no rotation.
The end angle is tried as given and one turn to either side, unless the request says `turns`.

One JSON line per request:

    T_nlp_s       the best duration that IPOPT reports
    T_checked_s   that duration corrected to first order by what the integration step hid: the controls are integrated
                  exactly, and the end error times the multipliers of the end conditions is added
    end_error     of the exact integration: m, m/s, m, m/s, rad
    wall_s        of all windings tried, without building the program (build_s, once per process)
    status        what IPOPT said
"""

import argparse
import json
import math
import os
import sys
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

import casadi as ca
import numpy as np


def build(n):
    start, end = ca.SX.sym("start", 5), ca.SX.sym("end", 5)
    gravity = ca.SX.sym("gravity")
    duration = ca.SX.sym("duration")
    states = ca.SX.sym("states", 5, n + 1)
    inputs = ca.SX.sym("inputs", 2, n)

    def motion(state, rate, thrust):
        return ca.vertcat(
            state[1],
            thrust * ca.sin(state[4]),
            state[3],
            thrust * ca.cos(state[4]) - gravity,
            rate,
        )

    h = duration / n
    gaps = []
    for i in range(n):
        a, rate, thrust = states[:, i], inputs[0, i], inputs[1, i]
        k1 = motion(a, rate, thrust)
        k2 = motion(a + h / 2 * k1, rate, thrust)
        k3 = motion(a + h / 2 * k2, rate, thrust)
        k4 = motion(a + h * k3, rate, thrust)
        gaps.append(states[:, i + 1] - (a + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)))
    nlp = {
        "x": ca.vertcat(duration, ca.vec(states), ca.vec(inputs)),
        "f": duration,
        "g": ca.vertcat(states[:, 0] - start, *gaps, states[:, n] - end),
        "p": ca.vertcat(start, end, gravity),
    }
    quiet = {"print_time": False, "ipopt.print_level": 0, "ipopt.sb": "yes", "ipopt.max_iter": 1000}
    return ca.nlpsol("shooting", "ipopt", nlp, quiet)


def shoot(solver, n, req, end):
    start = np.array(req["from"], float)
    (low, high), rate, gravity = req["thrust"], req["rate"], req["gravity"]
    distance = math.hypot(end[0] - start[0], end[2] - start[2])
    guess = max(2 * math.sqrt(distance / gravity), abs(end[4] - start[4]) / rate, 0.1)
    line = start[:, None] + (end - start)[:, None] * np.linspace(0, 1, n + 1)
    hover = np.clip(gravity, low, high)
    free = np.full(5 * (n + 1), np.inf)
    answer = solver(
        x0=np.r_[guess, line.ravel(order="F"), np.tile([0, hover], n)],
        p=np.r_[start, end, gravity],
        lbx=np.r_[0.01, -free, np.tile([-rate, low], n)],
        ubx=np.r_[100, free, np.tile([rate, high], n)],
        lbg=0,
        ubg=0,
    )
    stats = solver.stats()
    x = answer["x"].full().ravel()
    inputs = x[1 + 5 * (n + 1) :].reshape(n, 2)
    multipliers = answer["lam_g"].full().ravel()[-5:]
    return float(x[0]), inputs, multipliers, stats


def fly(start, gravity, duration, inputs):
    """The end state, integrated exactly: on an interval of constant rate w the velocity changes by
    thrust (cos a - cos b, sin b - sin a) / w and the position by its integral; by series where the turn is small."""
    x, vx, z, vz, theta = map(float, start)
    h = duration / len(inputs)
    for w, thrust in inputs:
        turn = w * h
        if abs(turn) > 0.05:
            c1, s1 = (1 - math.cos(turn)) / turn, math.sin(turn) / turn
            c2, s2 = (1 - s1) / turn, (1 - math.cos(turn)) / turn**2
        else:
            q = turn * turn
            c1 = turn * (1 / 2 - q / 24 + q * q / 720 - q**3 / 40320)
            s1 = 1 - q / 6 + q * q / 120 - q**3 / 5040
            c2 = turn * (1 / 6 - q / 120 + q * q / 5040)
            s2 = 1 / 2 - q / 24 + q * q / 720 - q**3 / 40320
        sin, cos = math.sin(theta), math.cos(theta)
        x += vx * h + thrust * h * h * (sin * s2 + cos * c2)
        z += vz * h + thrust * h * h * (cos * s2 - sin * c2) - gravity * h * h / 2
        vx += thrust * h * (sin * s1 + cos * c1)
        vz += thrust * h * (cos * s1 - sin * c1) - gravity * h
        theta += turn
    return np.array([x, vx, z, vz, theta])


def answer(solver, n, req):
    clock = time.perf_counter()
    per_turns = []
    best = None
    for k in [req["turns"]] if "turns" in req else [0, 1, -1]:
        end = np.array(req["to"], float)
        end[4] += 2 * math.pi * k
        tick = time.perf_counter()
        duration, inputs, multipliers, stats = shoot(solver, n, req, end)
        solved = stats["return_status"] == "Solve_Succeeded"
        per_turns.append(
            {
                "turns": k,
                "T_nlp_s": duration if solved else None,
                "status": stats["return_status"],
                "wall_s": time.perf_counter() - tick,
            }
        )
        if solved and (best is None or duration < best[0] * (1 - 1e-7)):
            best = duration, k, inputs, multipliers, end
    wall = time.perf_counter() - clock
    out = {"name": req["name"], "T_nlp_s": None, "T_checked_s": None, "end_error": None, "turns": None}
    if best:
        duration, k, inputs, multipliers, end = best
        error = fly(req["from"], req["gravity"], duration, inputs) - end
        # CasADi's Lagrangian is f + multipliers * g with g = end state - target: moving the target by -error moves the
        # optimal duration by multipliers * error.
        out |= {
            "T_nlp_s": duration,
            "T_checked_s": duration + float(multipliers @ error),
            "end_error": error.tolist(),
            "turns": k,
        }
    out["status"] = "Solve_Succeeded" if best else per_turns[0]["status"]
    out["wall_s"] = wall
    out["per_turns"] = per_turns
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("requests", nargs="?", default="-")
    parser.add_argument("-n", "--intervals", type=int, default=100)
    args = parser.parse_args()
    clock = time.perf_counter()
    solver = build(args.intervals)
    built = time.perf_counter() - clock
    with sys.stdin if args.requests == "-" else open(args.requests) as lines:
        for line in lines:
            if line.strip():
                out = answer(solver, args.intervals, json.loads(line))
                print(json.dumps(out | {"build_s": round(built, 3)}), flush=True)


if __name__ == "__main__":
    main()
