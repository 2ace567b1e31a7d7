"""A data set as a set of rows for a learner: numbers of each row and of the row before it, against the nominal model."""

import zlib

import numpy as np

from nominal import Expected, Rows

# Rows of a case that are kept, and how many of them are of the reference where there is one.
KEPT = 512
OF_REFERENCE = 192

# No number of a row is beyond it.
FURTHEST = 16

NAMES = (
    "reference", "echo", "chance", "surplus", "error", "error, fine", "error, coarse", "reading", "distance", "margin", "off axis",
    "side", "bearing sine", "bearing cosine", "time", "x", "z", "heading sine", "heading cosine", "sensor", "obstacle",
    "follows", "echo before", "surplus before", "error before", "same as before", "against before", "against expected before",
    "ahead", "turned", "waited", "place x", "place z", "off grid")


def before(values: np.ndarray, follows: np.ndarray) -> np.ndarray:
    """The value of the row before, 0 where there is none."""
    return np.where(follows, np.r_[0, values[:-1]], 0)


def squeezed(values: np.ndarray, unit: float) -> np.ndarray:
    """Straight for what is small beside the unit, a logarithm beyond."""
    return np.arcsinh(values / unit)


def sheet(scene: dict, rows: Rows, expected: Expected, reference: bool) -> np.ndarray:
    """Numbers of each row, in the order of NAMES."""
    sensor = scene["sensor"]
    half = np.radians(sensor["cone_half_angle_deg"])
    step = max(sensor["resolution_m"], 1e-4)
    noise = max(np.hypot(sensor["range_noise_m"], step / 3.5), 1e-4)
    echo = np.isfinite(rows.range)
    reading = np.where(echo, rows.range, 0)
    error = np.where(echo, reading - expected.distance, 0)
    surplus = echo - expected.chance
    follows = np.r_[False, (rows.run[1:] == rows.run[:-1]) & (rows.sensor[1:] == rows.sensor[:-1])]
    both = follows & echo & (before(echo.astype(float), follows) > 0)
    moved = rows.x - np.r_[0, rows.x[:-1]], rows.z - np.r_[0, rows.z[:-1]]
    ahead = np.where(follows, moved[0] * np.cos(rows.heading) - moved[1] * np.sin(rows.heading), 0)
    turned = np.where(follows, np.sin(rows.heading - np.r_[0, rows.heading[:-1]]), 0)
    waited = np.where(follows, rows.t - np.r_[0, rows.t[:-1]], 0)
    grid = reading / step
    side = expected.off_axis / half
    return np.column_stack([
        np.full(len(echo), float(reference)), echo, expected.chance, surplus,
        squeezed(error, noise), np.clip(error / noise, -4, 4), np.clip(error, -3, 3), reading / 3, expected.distance / 3,
        np.clip(expected.margin - 1, -1, 2), np.clip(np.abs(side), 0, 3), np.clip(side, -3, 3),
        np.sin(expected.bearing), np.cos(expected.bearing), (rows.t - rows.t.min()) / max(1e-9, np.ptp(rows.t)),
        rows.x / 3, rows.z / 3, np.sin(rows.heading), np.cos(rows.heading), rows.sensor / 4, expected.obstacle / 4,
        follows, before(echo.astype(float), follows), before(surplus, follows), squeezed(before(error, follows), noise),
        both & (reading == before(reading, follows)), np.where(both, squeezed(reading - before(reading, follows), noise), 0),
        np.where(echo & follows, squeezed(reading - before(expected.distance, follows), noise), 0),
        np.clip(ahead * 10, -3, 3), turned, np.clip(waited, 0, 3),
        np.where(echo, rows.x + reading * np.cos(rows.heading), 0) / 3,
        np.where(echo, rows.z - reading * np.sin(rows.heading), 0) / 3, np.where(echo, np.abs(grid - np.round(grid)), 0)])


def some(values: np.ndarray, count: int, name: str) -> np.ndarray:
    """As many rows by chance that the name of the case sets; rows come twice where there are too few."""
    chance = np.random.default_rng(zlib.crc32(name.encode()))
    return values[chance.choice(len(values), count, replace=len(values) < count)]


def together(readings: np.ndarray, reference: np.ndarray | None, name: str) -> np.ndarray:
    """The rows of a case that are kept, those of its reference among them where there is one."""
    kept = some(readings, KEPT, name)
    if reference is not None:
        kept[KEPT - OF_REFERENCE:] = some(reference, OF_REFERENCE, name)
    return np.clip(kept, -FURTHEST, FURTHEST).astype(np.float16)
