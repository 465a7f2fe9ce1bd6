#!/usr/bin/env python3
"""Golden upper bounds on the duration of minimum-time maneuvers.

    golden_upper_bounds.py generate          writes ../tests/data/golden/requests.jsonl
    golden_upper_bounds.py solve -o PASS     one pass over the requests; appends, skips what PASS already has
    golden_upper_bounds.py merge PASS...     writes ../tests/data/golden/upper_bounds.jsonl, the better of the passes
    golden_upper_bounds.py compare CASES     solves cases of known duration and prints the gaps

The requests are the data, the generator is how they came about: SEED and the code below reproduce the
file byte for byte (numpy's PCG64 stream), and `generate --check` compares without writing.

The method is direct and condensed. Time is cut into N intervals; the pitch rate and the thrust are constant on
each. Unknowns are the duration, the thrusts and the pitch angles between intervals. Velocity and position at the
end are explicit sums of closed forms, so the nonlinear program has four equations (the fifth end state, the
angle, is given by the last node) and two linear rows an interval for the rate limit. Whatever it returns is a
maneuver of the true continuous problem: its duration is an upper bound on the optimum, up to the end error that an
independent quadrature measures and that is stored with it.
"""

import argparse
import json
import math
import os
import pathlib
import sys
import time

os.environ.setdefault("OMP_NUM_THREADS", "1")

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


# ----------------------------------------------------------------------------------------------------------------------
# The nonlinear program

SERIES = 11  # terms; exact to rounding while an interval turns by less than 4 rad


class Program:
    """The condensed program on N intervals, built once; the request and the mesh are parameters."""

    def __init__(self, n, tol, max_iter, mu_init):
        import casadi as ca

        self.n = n
        duration = ca.SX.sym("duration")  # in units of the time scale
        level = ca.SX.sym("level", n)  # thrust, 0 at the lower and 1 at the upper limit
        inner = ca.SX.sym("inner", n - 1)  # pitch at the inner nodes
        fixed = ca.SX.sym("fixed", 13)
        mesh = ca.SX.sym("mesh", n)  # widths of the intervals, sum 1
        scale, vx0, vz0, dx, dz, vx1, vz1, g, rate, fmin, fmax, theta0, theta1 = ca.vertsplit(fixed)

        t = duration * scale
        h = t * mesh
        theta = ca.vertcat(theta0, inner, theta1)
        turn = theta[1:] - theta[:-1]
        mid = (theta[1:] + theta[:-1]) / 2
        force = fmin + (fmax - fmin) * level

        # With y = turn / 2 and u from -1/2 to 1/2 along the interval:
        #   even = integral of cos(u turn) = sin(y) / y,   odd = integral of u sin(u turn),
        # as power series, which need no special case where the rate is zero.
        y = turn / 2
        even, odd = 0, 0
        for k in reversed(range(SERIES)):
            sign = (-1) ** k
            even = even * y * y + sign / math.factorial(2 * k + 1)
            odd = odd * y * y + sign / (2 * math.factorial(2 * k + 1) * (2 * k + 3))
        odd = odd * y

        # A push during an interval moves the end state by its velocity times the time that is left, counted from the
        # middle of the interval, and by a first moment.
        ends = ca.cumsum(mesh)
        left = t * (1 - ends + mesh / 2)
        sin, cos = ca.sin(mid), ca.cos(mid)
        push_x, push_z = force * h * even * sin, force * h * even * cos
        moment_x, moment_z = -force * h * h * odd * cos, force * h * h * odd * sin
        v_scale, p_scale = fmax * scale, fmax * scale**2
        ends_met = ca.vertcat(
            (vx0 + ca.sum1(push_x) - vx1) / v_scale,
            (vx0 * t + ca.sum1(push_x * left + moment_x) - dx) / p_scale,
            (vz0 + ca.sum1(push_z) - g * t - vz1) / v_scale,
            (vz0 * t + ca.sum1(push_z * left + moment_z) - g * t * t / 2 - dz) / p_scale,
        )
        swing = turn / (rate * scale * mesh)
        constraints = ca.vertcat(ends_met, swing - duration, -swing - duration)
        options = {
            "print_time": False,
            "ipopt.print_level": 0,
            "ipopt.sb": "yes",
            "ipopt.tol": tol,
            "ipopt.constr_viol_tol": 1e-12,
            "ipopt.max_iter": max_iter,
            "ipopt.bound_relax_factor": 0.0,
            "ipopt.honor_original_bounds": "yes",
        }
        if mu_init is None:
            options["ipopt.mu_strategy"] = "adaptive"
        else:
            options |= {
                "ipopt.mu_init": mu_init,
                "ipopt.bound_push": 1e-4,
                "ipopt.bound_frac": 1e-4,
                "ipopt.slack_bound_push": 1e-4,
                "ipopt.slack_bound_frac": 1e-4,
            }
        nlp = {
            "x": ca.vertcat(duration, level, inner),
            "f": duration,
            "g": constraints,
            "p": ca.vertcat(fixed, mesh),
        }
        self.solver = ca.nlpsol(f"direct{n}", "ipopt", nlp, options)
        inf = np.inf
        self.bounds = {
            "lbx": np.r_[1e-3, np.zeros(n), np.full(n - 1, -inf)],
            "ubx": np.r_[1e3, np.ones(n), np.full(n - 1, inf)],
            "lbg": np.r_[np.zeros(4), np.full(2 * n, -inf)],
            "ubg": np.zeros(4 + 2 * n),
        }

    def solve(self, req, k, guess):
        start, end = req["from"], req["to"]
        fmin, fmax = req["thrust"]
        scale = guess.duration
        theta0, theta1 = start[4], end[4] + 2 * math.pi * k
        fixed = [scale, start[1], start[3], end[0] - start[0], end[2] - start[2], end[1], end[3]]
        fixed += [req["gravity"], req["rate"], fmin, fmax, theta0, theta1]
        level = np.clip((guess.force - fmin) / (fmax - fmin), 0, 1)
        answer = self.solver(x0=np.r_[1.0, level, guess.theta[1:-1]], p=np.r_[fixed, guess.mesh], **self.bounds)
        x = answer["x"].full().ravel()
        stats = self.solver.stats()
        n = self.n
        theta = np.r_[theta0, x[n + 1 :], theta1]
        force = fmin + (fmax - fmin) * x[1 : n + 1]
        out = Maneuver(float(x[0]) * scale, theta, force, guess.mesh)
        out.iterations = stats["iter_count"]
        out.status = stats["return_status"]
        return out


class Maneuver:
    """A duration, pitch angles at the nodes, thrusts on the intervals, relative widths of the intervals."""

    def __init__(self, duration, theta, force, mesh):
        self.duration, self.theta, self.force, self.mesh = duration, theta, force, mesh
        self.iterations, self.status = 0, ""

    def onto(self, mesh):
        """The same maneuver on another mesh: pitch interpolated, thrust averaged."""
        old = np.r_[0, np.cumsum(self.mesh)]
        new = np.r_[0, np.cumsum(mesh)]
        old[-1] = new[-1] = 1.0
        theta = np.interp(new, old, self.theta)
        impulse = np.interp(new, old, np.r_[0, np.cumsum(self.force * self.mesh)])
        return Maneuver(self.duration, theta, np.diff(impulse) / mesh, mesh)


GAUSS, WEIGHT = np.polynomial.legendre.leggauss(20)
GAUSS, WEIGHT = (GAUSS + 1) / 2, WEIGHT / 2


def end_error(req, k, man):
    """Clips the controls to the limits, integrates the motion by quadrature (not by the program's closed forms) and
    returns the error of the five end states."""
    start, end = req["from"], req["to"]
    h = man.duration * man.mesh
    rate = np.clip(np.diff(man.theta) / h, -req["rate"], req["rate"])
    force = np.clip(man.force, *req["thrust"])
    theta = start[4] + np.r_[0, np.cumsum(rate * h)]
    angle = theta[:-1, None] + (rate * h)[:, None] * GAUSS
    remaining = (man.duration - np.r_[0, np.cumsum(h)[:-1]])[:, None] - h[:, None] * GAUSS
    ax, az = force[:, None] * np.sin(angle), force[:, None] * np.cos(angle) - req["gravity"]
    weight = h[:, None] * WEIGHT
    t = man.duration
    reached = [
        start[0] + start[1] * t + np.sum(ax * remaining * weight),
        start[1] + np.sum(ax * weight),
        start[2] + start[3] * t + np.sum(az * remaining * weight),
        start[3] + np.sum(az * weight),
        theta[-1],
    ]
    goal = [*end[:4], end[4] + 2 * math.pi * k]
    return [float(a - b) for a, b in zip(reached, goal)]


# ----------------------------------------------------------------------------------------------------------------------
# Starts


def relaxed(req):
    """A guess as if attitude were free: the acceleration linear in time that meets the end, with the shortest duration
    whose root-mean-square thrust is within the limit. Returns the duration and the thrust as a function of s in 0..1."""
    start, end = np.array(req["from"]), np.array(req["to"])
    v0, v1 = start[[1, 3]], end[[1, 3]]
    move = (end - start)[[0, 2]]
    up = np.array([0.0, req["gravity"]])
    s = np.linspace(0, 1, 41)

    def thrust(t, s):
        a0 = 6 * (move - v0 * t) / t**2 - 2 * (v1 - v0) / t
        a1 = 2 * ((v1 - v0) - a0 * t) / t**2
        return a0 + a1 * (s * t)[:, None] + up

    for t in np.geomspace(0.02, 60, 400):
        if np.mean(np.sum(thrust(t, s) ** 2, axis=1)) <= req["thrust"][1] ** 2:
            break
    return float(t), lambda s: thrust(t, s)


def starts(req, k, n, rng):
    """At least 20 guesses for one winding: the relaxed maneuver reached by turning either way, straight lines, single
    swings, flips early, midway and late, and random ones."""
    fmin, fmax = req["thrust"]
    rate = req["rate"]
    theta0, theta1 = req["from"][4], req["to"][4] + 2 * math.pi * k
    mesh = np.full(n, 1 / n)
    node = np.linspace(0, 1, n + 1)
    middle = (node[1:] + node[:-1]) / 2
    t_free, thrust = relaxed(req)
    t_turn = abs(theta1 - theta0) / rate
    line = theta0 + (theta1 - theta0) * node
    out = []

    def add(kind, duration, theta, force):
        theta = np.r_[theta0, theta[1:-1], theta1]
        out.append((kind, Maneuver(max(duration, 1.05 * t_turn), theta, np.broadcast_to(force, n).copy(), mesh)))

    # Relaxed, within the cones that the rate limit leaves from both ends; either way round, pushed to either side.
    for side in (-1, 1):
        for stretch in (1.1, 1.5):
            duration = max(t_free * stretch, 1.05 * t_turn)
            aside = np.array([0.1 * side * fmax, 0])
            vector = thrust(node) + aside
            wanted = np.unwrap(np.arctan2(vector[:, 0], vector[:, 1]))
            center = (theta0 + theta1) / 2
            lap = round((center - np.mean(wanted)) / (2 * math.pi))
            force = np.linalg.norm(thrust(middle), axis=1)
            for j in (lap - 1, lap, lap + 1):
                theta = np.clip(wanted + 2 * math.pi * j, theta0 - rate * duration * node, theta0 + rate * duration * node)
                back = rate * duration * (1 - node)
                add("relaxed", duration, np.clip(theta, theta1 - back, theta1 + back), np.clip(force, fmin, fmax))
    # Lines.
    for force in (fmin, 0.5 * (fmin + fmax), fmax):
        add("line", 1.3 * t_free, line, force)
    # Single swings about the line.
    for size in (-2.5, -1.2, 1.2, 2.5):
        add("swing", 1.3 * t_free, line + size * np.sin(math.pi * node), 0.8 * fmax)
    # The whole turn at full rate: early, midway, late.
    for where in (0.0, 0.5, 1.0):
        duration = max(1.3 * t_free, 1.05 * t_turn)
        share = max(t_turn / duration, 0.1)
        ramp = np.clip((node - where * (1 - share)) / share, 0, 1)
        add("flip", duration, theta0 + (theta1 - theta0) * ramp, 0.8 * fmax)
    # Random: a few sines about the line, thrust noisy or bang-bang, duration from short to long.
    for i in range(18):
        waves = sum(rng.normal(0, 1.6 / math.sqrt(j)) * np.sin(j * math.pi * node) for j in range(1, 6))
        if i % 2:
            force = rng.uniform(fmin, fmax, n)
        else:
            force = np.where(np.sin(rng.uniform(1, 12) * middle + rng.uniform(0, 6.3)) > -0.3, fmax, fmin)
        add("random", t_free * rng.uniform(0.9, 2.5), line + waves, force)
    return out


# ----------------------------------------------------------------------------------------------------------------------
# One request

COARSE, FINE = 40, 200
RESIDUAL = 1e-8  # m, m/s, rad: a maneuver that misses the end by more is not counted
CLOSE = 1.04  # coarse results within this factor of the best of all are refined
KEEP = 4  # distinct coarse results refined per winding that is close
SHAKES = 4  # perturbed restarts on the fine mesh for the best winding
PASSES = 3  # times the mesh follows the switches


def focused(req, man):
    """A mesh of as many intervals that follows the switches of a solution: narrow where a control changes over, wide
    elsewhere. Density is a mixture of the uniform one and of one that sits on the changes."""
    n = len(man.mesh)
    h = man.duration * man.mesh
    fmin, fmax = req["thrust"]
    level = (man.force - fmin) / (fmax - fmin)
    speed = np.diff(man.theta) / h / req["rate"]
    change = np.zeros(n)
    for signal, span in ((level, 1.0), (speed, 2.0)):
        jump = np.abs(np.diff(signal)) / span
        jump[jump < 0.05] = 0
        change[:-1] = np.maximum(change[:-1], jump)
        change[1:] = np.maximum(change[1:], jump)
    change = np.minimum(change, 0.5)
    # Intervals that see a change are cut in pieces, the others share what is left.
    if change.max() < 1e-3:
        return man.mesh
    mass = man.mesh / man.mesh.sum() + change / change.sum()
    cdf = np.r_[0, np.cumsum(mass / mass.sum())]
    edges = np.interp(np.linspace(0, 1, n + 1), cdf, np.r_[0, np.cumsum(man.mesh)])
    mesh = np.diff(edges)
    return mesh / mesh.sum()


class Prover:
    def __init__(self):
        self.coarse = Program(COARSE, 1e-8, 250, None)
        self.fine = Program(FINE, 1e-10, 400, 1e-2)
        self.cold = Program(FINE, 1e-10, 300, None)

    def accept(self, req, k, man):
        man.error = end_error(req, k, man)
        return np.isfinite(man.duration) and max(map(abs, man.error)) <= RESIDUAL

    def windings(self, req):
        gap = req["to"][4] - req["from"][4]
        ks = [k for k in range(-8, 9) if abs(gap + 2 * math.pi * k) <= 4 * math.pi + 1e-9]
        if "turns" in req:
            ks = [req["turns"]]
        return sorted(ks, key=lambda k: (abs(gap + 2 * math.pi * k), -k)), gap

    def run(self, req, seed, cold=0):
        """The best maneuver over all windings. `cold` starts of each winding that is close are solved on the fine
        mesh directly, without the coarse one before."""
        clock, wall = time.process_time(), time.perf_counter()
        ks, gap = self.windings(req)
        tried, failed, fine_solves = 0, 0, 0
        best = math.inf
        coarse, ruled_out = {}, {}
        for k in ks:
            floor = abs(gap + 2 * math.pi * k) / req["rate"]
            if floor >= best:
                ruled_out[k] = floor
                continue
            rng = np.random.default_rng([seed, k + 100])
            found = []
            for _, guess in starts(req, k, COARSE, rng):
                tried += 1
                man = self.coarse.solve(req, k, guess)
                if self.accept(req, k, man):
                    found.append(man)
                else:
                    failed += 1
            found.sort(key=lambda m: m.duration)
            coarse[k] = found
            if found:
                best = min(best, found[0].duration)

        # Refinement: the few best distinct ones of each winding that is close, the best one of each that is not.
        fine = {}
        uniform = np.full(FINE, 1 / FINE)
        for k, found in coarse.items():
            distinct = []
            for man in found:
                if all(abs(man.duration / d.duration - 1) > 1e-6 for d in distinct):
                    distinct.append(man)
            near = [m for m in distinct if m.duration <= CLOSE * best][:KEEP]
            results = []
            for man in near or distinct[:1]:
                out = self.fine.solve(req, k, man.onto(uniform))
                fine_solves += 1
                if self.accept(req, k, out):
                    results.append(out)
            rng = np.random.default_rng([seed, k + 100, FINE])
            guesses = starts(req, k, FINE, rng) if cold and near else []
            for i in range(cold if guesses else 0):
                _, guess = guesses[(i * len(guesses)) // cold]
                tried += 1
                out = self.cold.solve(req, k, guess)
                if self.accept(req, k, out):
                    results.append(out)
                else:
                    failed += 1
            fine[k] = min(results, key=lambda m: m.duration) if results else (found[0] if found else None)
        k = min((k for k in fine if fine[k]), key=lambda k: fine[k].duration)
        rng = np.random.default_rng([seed, 999])
        for _ in range(SHAKES):
            node = np.linspace(0, 1, FINE + 1)
            noise = sum(rng.normal(0, 0.4 / j) * np.sin(j * math.pi * node) for j in range(1, 9))
            base = fine[k].onto(uniform)
            guess = Maneuver(base.duration * 1.05, base.theta + noise, base.force, uniform)
            out = self.fine.solve(req, k, guess)
            fine_solves += 1
            if self.accept(req, k, out) and out.duration < fine[k].duration:
                fine[k] = out
        t_uniform = fine[k].duration

        # The mesh follows the switches, for every winding that the uniform mesh cannot tell from the best.
        for j in fine:
            if fine[j] and fine[j].duration <= 1.001 * t_uniform and len(fine[j].mesh) == FINE:
                for _ in range(PASSES):
                    out = self.fine.solve(req, j, fine[j].onto(focused(req, fine[j])))
                    fine_solves += 1
                    if self.accept(req, j, out) and out.duration < fine[j].duration:
                        fine[j] = out
        # Mirror images tie: the smaller net turn first, then the positive one.
        best = min(fine[j].duration for j in fine if fine[j])
        ties = [j for j in fine if fine[j] and fine[j].duration <= best * (1 + 2e-8)]
        k = min(ties, key=lambda j: (round(abs(gap + 2 * math.pi * j), 6), -j))
        self.top = fine[k]

        return {
            "name": req["name"],
            "class": req.get("class", ""),
            **{f: req[f] for f in ("from", "to", "thrust", "rate", "gravity")},
            "T_upper_s": self.top.duration,
            "turns": k,
            "end_residual": self.top.error,
            "N": FINE,
            "T_uniform_mesh_s": t_uniform,
            "per_turns": [
                {"turns": j, "T_s": fine[j].duration if fine[j] else None, "N": len(fine[j].mesh) if fine[j] else None}
                for j in sorted(fine)
            ],
            "ruled_out": [{"turns": j, "T_at_least_s": ruled_out[j]} for j in sorted(ruled_out)],
            "starts": tried,
            "starts_failed": failed,
            "refinements": fine_solves,
            "cpu_s": round(time.process_time() - clock, 2),
            "wall_s": round(time.perf_counter() - wall, 2),
        }


def read(path):
    path = pathlib.Path(path)
    return [json.loads(line) for line in path.read_text().splitlines() if line] if path.exists() else []


def solve(path, seed, cold, controls):
    requests = read(REQUESTS)
    done = {r["name"] for r in read(path)}
    prover = Prover()
    for i, req in enumerate(requests):
        if req["name"] in done:
            continue
        r = prover.run(req, SEED + 1000 * seed + i, cold)
        with open(path, "a") as f:
            f.write(json.dumps(r) + "\n")
        if controls:
            top = prover.top
            kept = {"name": r["name"], "turns": r["turns"], "T_s": top.duration}
            kept |= {"interval_s": (top.duration * top.mesh).tolist(), "theta": top.theta.tolist()}
            with open(controls, "a") as f:
                f.write(json.dumps(kept | {"thrust": top.force.tolist()}) + "\n")
        print(
            f"{i + 1:3}/{len(requests)} {r['name']:15} T {r['T_upper_s']:.9f} turns {r['turns']:+d}  starts {r['starts']}"
            f" ({r['starts_failed']} failed)  {r['cpu_s']} s CPU, {r['wall_s']} s",
            flush=True,
        )
    return 0


def merge(paths):
    passes = [{r["name"]: r for r in read(p)} for p in paths]
    out = []
    for req in read(REQUESTS):
        found = [p[req["name"]] for p in passes if req["name"] in p]
        least = min(r["T_upper_s"] for r in found)
        best = dict(next(r for r in found if r["T_upper_s"] <= least * (1 + 2e-8)))
        assert all(best[f] == req[f] for f in ("class", "from", "to", "thrust", "rate", "gravity")), req["name"]
        turns = {}
        for r in found:
            for t in r["per_turns"]:
                if t["T_s"] and (t["turns"] not in turns or t["T_s"] < turns[t["turns"]]["T_s"]):
                    turns[t["turns"]] = t
        best["per_turns"] = [turns[j] for j in sorted(turns)]
        best["ruled_out"] = [t for t in best["ruled_out"] if t["turns"] not in turns]
        for total in ("starts", "starts_failed", "refinements"):
            best[total] = sum(r[total] for r in found)
        for total in ("cpu_s", "wall_s"):
            best[total] = round(sum(r[total] for r in found), 2)
        best["T_by_pass_s"] = [r["T_upper_s"] for r in found]
        out.append(best)
    (GOLDEN / "upper_bounds.jsonl").write_text(lines(out))
    apart = [b["name"] for b in out if max(b["T_by_pass_s"]) > min(b["T_by_pass_s"]) * (1 + 1e-6)]
    print(f"{len(out)} bounds; passes differ by more than 1e-6 in {len(apart)}: {' '.join(apart)}")
    print(f"starts {sum(b['starts'] for b in out)}, CPU {sum(b['cpu_s'] for b in out):.0f} s")
    return 0


def compare(path):
    """Cases of known duration: a JSON file with a list `cases` of {name, x0, xT, limits, T_seconds, turns}."""
    prover = Prover()
    worst = 0.0
    for i, case in enumerate(json.loads(pathlib.Path(path).read_text())["cases"]):
        lim = case["limits"]
        req = {"name": case["name"], "from": case["x0"], "to": case["xT"], "thrust": [lim["f_min"], lim["f_max"]]}
        req |= {"rate": lim["omega_max"], "gravity": lim["g"]}
        r = prover.run(req, i)
        known = case["T_seconds"]
        gap, gap_uniform = r["T_upper_s"] / known - 1, r["T_uniform_mesh_s"] / known - 1
        worst = max(worst, gap)
        print(
            f"{case['name']:20} known {known:.9f} turns {case['turns']:+d}  upper {r['T_upper_s']:.9f} turns {r['turns']:+d}"
            f"  gap {gap:+.2e}  uniform mesh {gap_uniform:+.2e}  starts {r['starts']} ({r['starts_failed']} failed)"
            f"  {r['cpu_s']} s",
            flush=True,
        )
    print(f"worst gap {worst:.2e}")
    return 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    p = commands.add_parser("generate", help="write the requests")
    p.add_argument("--check", action="store_true", help="compare with the stored file, write nothing")
    p = commands.add_parser("compare", help="solve cases of known duration")
    p.add_argument("cases")
    p = commands.add_parser("solve", help="one pass over the requests")
    p.add_argument("-o", "--output", required=True)
    p.add_argument("--seed", type=int, default=0, help="another number gives other random starts")
    p.add_argument("--cold", type=int, default=0, help="starts per close winding solved on the fine mesh directly")
    p.add_argument("--controls", help="also append the controls of each maneuver to this file")
    p = commands.add_parser("merge", help="the better of several passes")
    p.add_argument("passes", nargs="+")
    args = parser.parse_args()
    if args.command == "generate":
        return generate(args.check)
    if args.command == "compare":
        return compare(args.cases)
    if args.command == "solve":
        return solve(args.output, args.seed, args.cold, args.controls)
    if args.command == "merge":
        return merge(args.passes)


if __name__ == "__main__":
    sys.exit(main())
