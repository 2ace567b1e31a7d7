"""A data set as numbers for a learner: residuals against the nominal model, sliced the ways in which effects differ."""

from pathlib import Path

import numpy as np

from nominal import Expected, Rows, expect, read_rows, read_scene

BINS = {
    "distance": (0.3, 0.6, 0.9, 1.3, 1.8, 2.5),
    "margin": (0.4, 0.6, 0.75, 0.85, 0.95, 1.05, 1.2, 1.5),
    "off": (0.2, 0.4, 0.6, 0.8, 0.95, 1.05, 1.3),
    "side": (-0.6, -0.2, 0.2, 0.6),
    "bearing": tuple(np.arange(1, 8) * np.pi / 4),
    "time": (0.25, 0.5, 0.75),
}


def slices(scene: dict, rows: Rows, expected: Expected) -> dict:
    half = np.radians(scene["sensor"]["cone_half_angle_deg"])
    span = max(1e-9, rows.t.max() - rows.t.min())
    return {
        "distance": expected.distance,
        "margin": expected.margin,
        "off": np.abs(expected.off_axis) / half,
        "side": expected.off_axis / half,
        "bearing": expected.bearing,
        "time": (rows.t - rows.t.min()) / span,
    }


def mean(values: np.ndarray) -> float:
    return float(values.mean()) if len(values) else np.nan


def spread(values: np.ndarray) -> float:
    return float(np.subtract(*np.percentile(values, [75, 25]))) if len(values) > 3 else np.nan


def slope(x: np.ndarray, y: np.ndarray) -> tuple:
    """Intercept and slope of the least absolute line, by medians of halves; nan with few points."""
    if len(x) < 12 or np.ptp(x) < 1e-6:
        return np.nan, np.nan
    order = np.argsort(x)
    third = len(x) // 3
    low, high = order[:third], order[-third:]
    run = np.median(x[high]) - np.median(x[low])
    if run < 1e-6:
        return np.nan, np.nan
    rise = (np.median(y[high]) - np.median(y[low])) / run
    return float(np.median(y) - rise * np.median(x)), float(rise)


def sheet(scene: dict, rows: Rows, expected: Expected) -> dict:
    """Named features of one sheet of readings."""
    sensor = scene["sensor"]
    echo = np.isfinite(rows.range)
    wrong = rows.range - expected.distance
    sure = expected.chance > 0.9
    near_zero = expected.chance < 0.02
    hit = echo & (expected.chance > 0.5) & (np.abs(wrong) < 0.25)
    step = max(sensor["resolution_m"], 1e-4)
    noise = max(np.hypot(sensor["range_noise_m"], step / 3.5), 1e-4)
    out = {
        "rows": float(len(rows.t)),
        "echo": mean(echo.astype(float)),
        "expected": mean(expected.chance),
        "surplus": mean(echo - expected.chance),
        "missed when sure": mean((~echo[sure]).astype(float)),
        "heard when none": mean(echo[near_zero].astype(float)),
        "gross": mean((echo & sure & (np.abs(wrong) > 0.1)).astype(float)),
        "gross near": mean((echo & sure & (wrong < -0.1)).astype(float)),
        "gross far": mean((echo & sure & (wrong > 0.1)).astype(float)),
        "least": float(np.nanmin(rows.range)) if echo.any() else np.nan,
        "most": float(np.nanmax(rows.range)) if echo.any() else np.nan,
        "believed least": sensor["min_range_m"],
        "believed most": sensor["max_range_m"],
    }
    error = wrong[hit]
    out["error"] = float(np.median(error)) if len(error) else np.nan
    out["error, noises"] = out["error"] / noise
    out["spread, noises"] = spread(error) / noise
    out["error at 0"], out["error per metre"] = slope(expected.distance[hit], error)
    out["error at start"], out["error per second"] = slope(rows.t[hit], error)
    out["error by margin"] = slope(expected.margin[hit], error)[1]
    out["error by off axis"] = slope(expected.off_axis[hit], error)[1]
    moved = np.r_[0, np.diff(rows.x)], np.r_[0, np.diff(rows.z)]
    ahead = moved[0] * np.cos(rows.heading) - moved[1] * np.sin(rows.heading)
    out["error by step ahead"] = slope(ahead[hit], error)[1]
    readings = rows.range[echo]
    if len(readings):
        off_grid = np.abs(readings / step - np.round(readings / step))
        out["off grid"] = mean((off_grid > 0.02).astype(float))
        for times in (2, 3, 5):
            coarse = readings / (times * step)
            out[f"grid of {times}"] = mean((np.abs(coarse - np.round(coarse)) < 0.02).astype(float))
    same = np.r_[False, (rows.run[1:] == rows.run[:-1]) & (rows.sensor[1:] == rows.sensor[:-1])]
    before = np.r_[np.nan, rows.range[:-1]]
    held = same & echo & (rows.range == before)
    out["held"] = mean(held[same].astype(float))
    out["held when none"] = mean(held[same & near_zero].astype(float))
    out["silent after silent, sure"] = mean((~echo[same & sure & ~np.isfinite(before)]).astype(float))
    out["silent after echo, sure"] = mean((~echo[same & sure & np.isfinite(before)]).astype(float))
    out["silent after silent, edge"] = mean((~echo[same & ~sure & ~near_zero & ~np.isfinite(before)]).astype(float))
    out["silent after echo, edge"] = mean((~echo[same & ~sure & ~near_zero & np.isfinite(before)]).astype(float))
    strange = echo & ((near_zero) | (np.abs(wrong) > 0.1))
    ranges = rows.range[strange]
    out["strange"] = mean(strange.astype(float))
    out["strange range"] = float(np.median(ranges)) if len(ranges) else np.nan
    out["strange range spread"] = spread(ranges)
    if strange.sum() > 5:
        px = rows.x[strange] + ranges * np.cos(rows.heading[strange])
        pz = rows.z[strange] - ranges * np.sin(rows.heading[strange])
        counts, _, _ = np.histogram2d(px, pz, bins=[np.arange(-6, 6.1, 0.15)] * 2)
        out["strange in one place"] = float(counts.max() / strange.sum())
        values, often = np.unique(np.round(ranges, 2), return_counts=True)
        out["strange at one range"] = float(often.max() / strange.sum())
        out["strange against before"] = float(np.nanmedian(np.abs(ranges - before[strange]))) if np.isfinite(before[strange]).any() else np.nan
    for name, values in slices(scene, rows, expected).items():
        which = np.digitize(values, BINS[name])
        for number in range(len(BINS[name]) + 1):
            here = which == number
            few = here.sum() < 8
            out[f"surplus {name} {number}"] = np.nan if few else mean((echo - expected.chance)[here])
            if name in ("distance", "time", "side"):
                close = here & hit
                out[f"error {name} {number}"] = float(np.median(wrong[close])) if close.sum() > 7 else np.nan
    # How far single sensors and obstacles stand apart from the rest.
    for name, label in (("sensor", rows.sensor), ("obstacle", expected.obstacle)):
        apart = [mean((echo - expected.chance)[label == one]) for one in np.unique(label) if (label == one).sum() > 20]
        out[f"surplus apart by {name}"] = float(np.ptp(apart)) if len(apart) > 1 else 0.0
        errors = [np.median(wrong[hit & (label == one)]) for one in np.unique(label) if (hit & (label == one)).sum() > 10]
        out[f"error apart by {name}"] = float(np.ptp(errors)) if len(errors) > 1 else 0.0
    return out


def compared(out: dict, trusted: dict | None) -> dict:
    """Features of a sheet; those of its reference, and the differences, where there is one, else nan."""
    out = dict(out)
    for name in list(out):
        of_reference = trusted.get(name, np.nan) if trusted else np.nan
        out["reference " + name] = of_reference
        out["change of " + name] = out[name] - of_reference
    out["has reference"] = float(trusted is not None)
    return out


def read(scene: dict, file: Path) -> tuple:
    """A sheet of readings and what the simulator expects of it."""
    rows = read_rows(file)
    return rows, expect(scene, rows)


def case(folder: Path) -> dict:
    """Features of a data set."""
    scene = read_scene(folder / "scene.json")
    reference = folder / "reference.csv"
    with np.errstate(all="ignore"):
        out = sheet(scene, *read(scene, folder / "readings.csv"))
        trusted = sheet(scene, *read(scene, reference)) if reference.exists() else None
    return compared(out, trusted)
