"""A motion folder as numbers for a learner: how what was tracked follows what was commanded, and what is left over.

Frame and units are the format's: metres, z down the page, angles counter-clockwise. Shares no code with the diagnosis.
"""

import csv
import json
import math
from pathlib import Path

import numpy as np

# A grid that all logs are brought to, and the commands of how long before act on a step.
STEP_S = 0.1
LAGS = 14
HOLE_S = 0.3


def table(path: Path) -> tuple:
    with path.open(newline="") as file:
        lines = csv.reader(file)
        names = next(lines)
        rows = list(lines)
    runs = np.array([row[0] for row in rows])
    numbers = np.array([[float(cell) for cell in row[1:]] for row in rows])
    return names, runs, numbers


def grids(robot: dict, commands: Path, track: Path) -> list:
    """Of each run, rows of a grid: time, commanded speed and turn rate; tracked speed along, across and turn rate; pose."""
    names, command_runs, told = table(commands)
    _, track_runs, seen = table(track)
    found = []
    for run in np.unique(track_runs):
        c = told[command_runs == run]
        t = seen[track_runs == run]
        if len(c) == 0 or len(t) < 10:
            continue
        c, t = c[np.argsort(c[:, 0], kind="stable")], t[np.argsort(t[:, 0], kind="stable")]
        if "left_m_s" in names:
            speed, turn = (c[:, 1] + c[:, 2]) / 2, (c[:, 2] - c[:, 1]) / robot["wheel_base_m"]
        else:
            speed, turn = c[:, 1], c[:, 2]
        times = np.arange(max(t[0, 0], c[0, 0]), t[-1, 0], STEP_S)
        if len(times) < 60:
            continue
        heading = np.unwrap(np.radians(t[:, 3]))
        x, z, h = (np.interp(times, t[:, 0], one) for one in (t[:, 1], t[:, 2], heading))
        after = np.clip(np.searchsorted(t[:, 0], times), 1, len(t) - 1)
        known = t[after, 0] - t[after - 1, 0] < HOLE_S
        dx, dz, turned = np.diff(x), np.diff(z), np.diff(h)
        middle = h[:-1] + turned / 2
        along = (dx * np.cos(middle) - dz * np.sin(middle)) / STEP_S
        across = (-dx * np.sin(middle) - dz * np.cos(middle)) / STEP_S
        rate = turned / STEP_S
        bad = ~(known[:-1] & known[1:])
        for one in (along, across, rate):
            one[bad] = np.nan
        held = [staircase(c[:, 0], values, times) for values in (speed, turn)]
        found.append(np.column_stack([times[:-1], *held, along, across, rate, x[:-1], z[:-1], middle]))
    return found


def staircase(since: np.ndarray, values: np.ndarray, times: np.ndarray) -> np.ndarray:
    """The mean over each step of the grid of what is held from each time to the next."""
    edges = np.concatenate([since, [times[-1] + 10]])
    area = np.concatenate([[0], np.cumsum(values * np.diff(edges))])
    return np.diff(np.interp(times, edges, area)) / STEP_S


def lagged(values: np.ndarray) -> np.ndarray:
    columns = []
    for lag in range(LAGS):
        column = np.full(len(values), np.nan)
        column[lag:] = values[: len(values) - lag]
        columns.append(column)
    return np.column_stack(columns)


def fit(columns: np.ndarray, values: np.ndarray) -> tuple:
    """Ridge regression; returns coefficients and residuals (nan where something is missing)."""
    good = np.isfinite(columns).all(axis=1) & np.isfinite(values)
    left = np.full(len(values), np.nan)
    if good.sum() < 3 * columns.shape[1]:
        return np.full(columns.shape[1], np.nan), left
    a, b = columns[good], values[good]
    scale = np.sqrt((a * a).mean(axis=0)) + 1e-9
    a = a / scale
    w = np.linalg.solve(a.T @ a + 1e-3 * len(b) * np.eye(a.shape[1]), a.T @ b) / scale
    left[good] = values[good] - columns[good] @ w
    return w, left


def mean(values: np.ndarray) -> float:
    values = values[np.isfinite(values)]
    return float(values.mean()) if len(values) > 7 else np.nan


def spread(values: np.ndarray) -> float:
    values = values[np.isfinite(values)]
    return float(np.subtract(*np.percentile(values, [75, 25])) / 1.349) if len(values) > 7 else np.nan


def together(values: np.ndarray, lag: int) -> float:
    a, b = values[lag:], values[:-lag]
    good = np.isfinite(a) & np.isfinite(b)
    if good.sum() < 30:
        return np.nan
    a, b = a[good], b[good]
    return float((a * b).mean() / (np.sqrt((a * a).mean() * (b * b).mean()) + 1e-12))


def share(left: np.ndarray, values: np.ndarray) -> float:
    good = np.isfinite(left) & np.isfinite(values)
    return float((left[good] ** 2).mean() / ((values[good] ** 2).mean() + 1e-12)) if good.sum() > 20 else np.nan


def response(out: dict, name: str, weights: np.ndarray):
    """What an impulse response says: gain, delay, how long it lasts."""
    lags = np.arange(LAGS) * STEP_S
    total = weights.sum()
    size = np.abs(weights).sum() + 1e-9
    out[f"{name} gain"] = float(total)
    out[f"{name} delay"] = float((weights * lags).sum() / (total if abs(total) > 0.1 else np.nan))
    out[f"{name} width"] = float(np.sqrt(max(0.0, (np.abs(weights) * (lags - (np.abs(weights) * lags).sum() / size) ** 2).sum() / size)))
    out[f"{name} least"] = float(weights.min())
    for lag in (0, 1, 2, 3, 5, 8):
        out[f"{name} up to {lag}"] = float(weights[: lag + 1].sum() / (total if abs(total) > 0.1 else np.nan))


def by(out: dict, name: str, values: np.ndarray, over: np.ndarray, edges):
    which = np.digitize(over, edges)
    for number in range(len(edges) + 1):
        here = values[which == number]
        out[f"{name} mean {number}"] = mean(here)
        out[f"{name} spread {number}"] = spread(here)


def wheels(out: dict, robot: dict, grid: np.ndarray):
    """Each wheel's, or each speed's, tracked value by its command: dead band, saturation, steps."""
    v, w, along, rate = grid[:, 1], grid[:, 2], grid[:, 3], grid[:, 5]
    pairs = {"speed": (v, along), "turn": (w, rate)}
    if robot.get("wheel_base_m"):
        half = robot["wheel_base_m"] / 2
        pairs |= {"left": (v - w * half, along - rate * half), "right": (v + w * half, along + rate * half)}
    for name, (told, seen) in pairs.items():
        # Only where the command has been the same for half a second.
        steady = np.ones(len(told), bool)
        for lag in range(1, 6):
            steady[lag:] &= np.abs(told[lag:] - told[:-lag]) < 1e-6 + 0.02 * np.abs(told).max()
        good = steady & np.isfinite(seen) & (np.abs(told) > 0)
        largest = np.percentile(np.abs(told), 99) + 1e-9
        size, ratio = np.abs(told[good]) / largest, (seen[good] * np.sign(told[good])) / largest
        edges = (0.05, 0.1, 0.2, 0.35, 0.5, 0.65, 0.8, 0.95)
        which = np.digitize(size, edges)
        for number in range(len(edges) + 1):
            here = which == number
            out[f"{name} error at {number}"] = float(np.median(ratio[here] - size[here])) if here.sum() > 7 else np.nan
            out[f"{name} scatter at {number}"] = spread(ratio[here] - size[here]) if here.sum() > 7 else np.nan
        out[f"{name} steady"] = float(good.mean())
        out[f"{name} most"] = float(np.nanpercentile(np.abs(seen), 99.5) / largest)
        # Steps show as a wave of the error over the command.
        error = ratio - size
        if good.sum() > 100:
            best = max(((abs(np.mean(error * np.exp(2j * math.pi * size * k))), k) for k in range(3, 60)), key=lambda pair: pair[0])
            out[f"{name} wave"], out[f"{name} waves"] = float(best[0] / (spread(error) + 1e-9)), float(best[1])


def ripple(out: dict, name: str, left: np.ndarray, way: np.ndarray, weight: np.ndarray):
    good = np.isfinite(left)
    values, at = (left * weight)[good], way[good]
    lengths = np.geomspace(0.06, 1.6, 120)
    sizes = np.array([abs(np.mean(values * np.exp(2j * math.pi * at / length))) for length in lengths])
    out[f"{name} ripple"] = float(sizes.max() / (np.median(sizes) + 1e-12))
    out[f"{name} ripple length"] = float(lengths[sizes.argmax()])


def sheet(robot: dict, commands: Path, track: Path) -> dict:
    runs = grids(robot, commands, track)
    out = {"runs": float(len(runs))}
    if not runs:
        return out
    grid = np.vstack(runs)
    t, v, w, along, across, rate, x, z, h = grid.T
    from_start = np.concatenate([one[:, 0] - one[0, 0] for one in runs])
    begin = np.concatenate([np.arange(len(one)) for one in runs])
    lag_v = np.vstack([lagged(one[:, 1]) for one in runs])
    lag_w = np.vstack([lagged(one[:, 2]) for one in runs])
    scale_v, scale_w = np.sqrt((v * v).mean()) + 1e-9, np.sqrt((w * w).mean()) + 1e-9
    out |= {"seconds": float(len(t) * STEP_S), "speed": float(scale_v), "turn rate": float(scale_w)}
    out["changes"] = float((np.abs(np.diff(v)) > 0.05 * scale_v).mean())
    out["backwards"] = float((v < -0.05 * scale_v).mean())
    weights_v, left_v = fit(lag_v, along)
    weights_w, left_w = fit(lag_w, rate)
    response(out, "along", weights_v)
    response(out, "turn", weights_w)
    braking = np.abs(lag_v[:, 0]) < np.abs(lag_v[:, 3]) - 0.02 * scale_v
    for name, where in (("braking", braking), ("not braking", ~braking)):
        one, _ = fit(lag_v[where], along[where])
        response(out, "along, " + name, one)
    for name, values, left, scale in (("along", along, left_v, scale_v), ("turn", rate, left_w, scale_w)):
        left = left / scale
        told = v if name == "along" else w
        out[f"{name} nominal"] = share(values - told, told)
        out[f"{name} left"] = share(left, values / scale)
        sigma = spread(left)
        out[f"{name} sigma"] = sigma
        z_left = np.abs(left[np.isfinite(left)]) / (sigma + 1e-9)
        for far in (4, 8):
            out[f"{name} beyond {far}"] = float((z_left > far).mean()) if len(z_left) else np.nan
        sign = left * np.sign(told)
        out[f"{name} short"] = float((sign < -4 * sigma).mean() - (sign > 4 * sigma).mean())
        for lag in (1, 2, 5, 10, 20, 50, 100):
            out[f"{name} together {lag}"] = together(left, lag)
        limit = 20 * sigma
        calm = np.clip(left, -limit, limit)
        by(out, f"{name} by speed", calm, np.abs(v) / scale_v, (0.05, 0.5, 1, 1.5))
        by(out, f"{name} by turn", calm, np.abs(w) / scale_w, (0.05, 0.5, 1, 1.5))
        by(out, f"{name} by side", calm, np.sign(w), (-0.5, 0.5))
        by(out, f"{name} by way", calm, np.sign(v), (-0.5, 0.5))
        by(out, f"{name} by time", calm, from_start / (from_start.max() + 1e-9), (0.25, 0.5, 0.75))
        by(out, f"{name} by heading", calm, np.mod(h, 2 * np.pi), tuple(np.arange(1, 8) * np.pi / 4))
        by(out, f"{name} by x", calm, x, tuple(np.percentile(x, [25, 50, 75])))
        by(out, f"{name} by z", calm, z, tuple(np.percentile(z, [25, 50, 75])))
        change = np.abs(lag_v[:, 0] - lag_v[:, 4]) / scale_v + np.abs(lag_w[:, 0] - lag_w[:, 4]) / scale_w
        by(out, f"{name} by change", calm, change, (0.05, 0.3, 1))
        turned_back = (lag_v[:, 0] * lag_v[:, 8]) < 0
        out[f"{name} turned back"] = mean(calm[turned_back])
    ways = np.concatenate([np.cumsum(np.abs(np.nan_to_num(one[:, 3]))) * STEP_S for one in runs])
    ripple(out, "along", left_v / scale_v, ways, np.sign(v))
    ripple(out, "turn", left_w / scale_w, ways, np.ones(len(v)))
    # The point that is tracked, its heading, a wheel that is larger, a turn of its own.
    weights, left = fit(np.column_stack([along, rate]), across)
    out["across per way"], out["across per turn"] = map(float, weights)
    out["across left"] = share(left, along)
    weights, _ = fit(np.column_stack([v, w, np.abs(v), np.abs(w), np.ones(len(v))]), rate)
    for name, value in zip(("per way", "per turn", "per amount of way", "per amount of turn", "always"), weights):
        out[f"turn {name}"] = float(value)
    weights, _ = fit(np.column_stack([v, w, np.abs(v), np.abs(w), np.ones(len(v)), rate * w]), along)
    for name, value in zip(("per way", "per turn", "per amount of way", "per amount of turn", "always", "per turn squared"), weights):
        out[f"along {name}"] = float(value)
    out["steps seen"] = float((begin > 0).mean())
    wheels(out, robot, grid)
    for name in ("latency_s", "speed_time_constant_s", "turn_time_constant_s", "max_speed_m_s", "dead_band_m_s",
                 "track_sigma_m", "track_sigma_deg", "wheel_base_m", "wheel_radius_m"):
        out[f"believed {name}"] = float(robot.get(name, np.nan))
    out["separate clocks"] = float(robot.get("clocks") == "separate")
    return out


def case(folder: Path) -> dict:
    """Features of a motion folder; those of its reference, and the differences, where there is one, else nan."""
    robot = json.loads((folder / "robot.json").read_text())
    with np.errstate(all="ignore"):
        out = sheet(robot, folder / "commands.csv", folder / "track.csv")
        reference = folder / "reference-track.csv"
        trusted = sheet(robot, folder / "reference-commands.csv", reference) if reference.exists() else {}
    for name in list(out):
        out["change of " + name] = out[name] - trusted.get(name, np.nan)
    out["has reference"] = float(reference.exists())
    return out
