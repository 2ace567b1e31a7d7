"""What the simulator expects of each row of a data set, by the format's own rule.

Frame and units are the format's (docs/guide/own-log.md): metres, degrees, z down the page, headings and bearings
counter-clockwise.
"""

import csv
import json
import math
from dataclasses import dataclass
from pathlib import Path

import numpy as np

# Points along an outline: the nearest point in the cone is found among them.
SPACING_M = 0.004


class Refused(Exception):
    """What was given cannot be used; the message says why."""


def folders(world: Path) -> list:
    """The cases of a folder that blind-world made."""
    if not (world / "cases").is_dir():
        raise Refused(f"{world}: no folder that blind-world made, it has no cases")
    found = sorted(path for path in (world / "cases").iterdir() if path.is_dir())
    if not found:
        raise Refused(f"{world}: its folder of cases is empty")
    return found


def truth(world: Path, name: str):
    """What is so of a case; None where the truth is kept elsewhere."""
    file = world / "truth" / name / "truth.json"
    return json.loads(file.read_text()) if file.exists() else None


@dataclass(frozen=True)
class Rows:
    """One sheet of readings, in the order of run, sensor and time. A no-echo has range nan."""

    run: np.ndarray
    sensor: np.ndarray
    t: np.ndarray
    x: np.ndarray
    z: np.ndarray
    heading: np.ndarray
    range: np.ndarray


@dataclass(frozen=True)
class Expected:
    """Per row, of the obstacle that most likely echoes: chance of an echo, distance, margin, bearing, angle off the axis."""

    chance: np.ndarray
    distance: np.ndarray
    margin: np.ndarray
    bearing: np.ndarray
    off_axis: np.ndarray
    obstacle: np.ndarray


def read_rows(path: Path) -> Rows:
    with path.open(newline="") as file:
        lines = list(csv.DictReader(file))
    lines.sort(key=lambda line: (line["run"], line["sensor"], float(line["t_s"])))

    def numbers(name):
        return np.array([float(line[name]) if line[name] else math.nan for line in lines])

    runs = {name: i for i, name in enumerate(sorted({line["run"] for line in lines}))}
    sensors = {name: i for i, name in enumerate(sorted({line["sensor"] for line in lines}))}
    return Rows(
        np.array([runs[line["run"]] for line in lines]),
        np.array([sensors[line["sensor"]] for line in lines]),
        numbers("t_s"),
        numbers("x_m"),
        numbers("z_m"),
        np.radians(numbers("heading_deg")),
        numbers("range_m"),
    )


def outline_points(outline: np.ndarray) -> np.ndarray:
    """Points on the closed polygon, its corners among them."""
    points = []
    for start, end in zip(outline, np.roll(outline, -1, axis=0)):
        count = max(1, math.ceil(np.hypot(*(end - start)) / SPACING_M))
        points.append(start + np.outer(np.arange(count) / count, end - start))
    return np.vstack(points)


def threshold(obstacle: dict, bearing: np.ndarray) -> np.ndarray:
    """The threshold distance at each bearing (radians): straight edges between the table's points, or the constant."""
    if obstacle["detection"] == "uniform":
        return np.full(bearing.shape, float(obstacle["uniform_range_m"]))
    table = np.array(obstacle["thresholds_m"], dtype=float)
    step = 2 * math.pi / len(table)
    position = np.mod(bearing, 2 * math.pi) / step
    low = np.floor(position).astype(int) % len(table)
    a, b = table[low], table[(low + 1) % len(table)]
    inside = (position - np.floor(position)) * step
    # Where the ray at this angle meets the edge between the two points.
    below = a * np.sin(inside) + b * np.sin(step - inside)
    return np.where(below > 0, a * b * math.sin(step) / np.where(below > 0, below, 1), 0)


def expect(scene: dict, rows: Rows) -> Expected:
    sensor = scene["sensor"]
    half = math.radians(sensor["cone_half_angle_deg"])
    edge = max(sensor["edge_width_m"], 1e-6)
    silent = np.ones(len(rows.t))
    best = {name: np.zeros(len(rows.t)) for name in ("chance", "distance", "margin", "bearing", "off_axis", "obstacle")}
    best["distance"][:] = scene["no_echo_m"]
    best["margin"][:] = 9.0
    nearest_centre = np.full(len(rows.t), np.inf)
    for number, obstacle in enumerate(scene["obstacles"]):
        turn = math.radians(obstacle["turn_deg"])
        own = outline_points(np.array(obstacle["outline_m"], dtype=float))
        cos, sin = math.cos(turn), math.sin(turn)
        px = own[:, 0] * cos + own[:, 1] * sin + obstacle["x_m"]
        pz = -own[:, 0] * sin + own[:, 1] * cos + obstacle["z_m"]
        dx, dz = px[None, :] - rows.x[:, None], pz[None, :] - rows.z[:, None]
        off = np.arctan2(-dz, dx) - rows.heading[:, None]
        off = np.mod(off + math.pi, 2 * math.pi) - math.pi
        distances = np.hypot(dx, dz)
        seen = np.where(np.abs(off) <= half, distances, np.inf)
        d = seen.min(axis=1)
        cx, cz = rows.x - obstacle["x_m"], rows.z - obstacle["z_m"]
        r = np.hypot(cx, cz)
        bearing = np.arctan2(cx, cz) - turn
        t = threshold(obstacle, bearing)
        chance = (1 - sensor["miss_rate"]) / (1 + np.exp(np.clip((r - t) / edge, -50, 50)))
        heard = (d >= sensor["min_range_m"]) & (d <= sensor["max_range_m"]) & (t > 0)
        chance = np.where(heard, chance, 0)
        silent *= 1 - chance
        centre_off = np.arctan2(obstacle["z_m"] * -1 + rows.z, obstacle["x_m"] - rows.x) - rows.heading
        centre_off = np.mod(centre_off + math.pi, 2 * math.pi) - math.pi
        margin = r / np.maximum(t, 0.05)
        takes = (chance > best["chance"]) | ((best["chance"] == 0) & (r < nearest_centre))
        nearest_centre = np.where(takes, r, nearest_centre)
        for name, value in (
            ("chance", chance),
            ("distance", np.where(np.isfinite(d), d, distances.min(axis=1))),
            ("margin", margin),
            ("bearing", np.mod(bearing, 2 * math.pi)),
            ("off_axis", centre_off),
            ("obstacle", np.full(len(rows.t), float(number))),
        ):
            best[name] = np.where(takes, value, best[name])
    best["chance"] = 1 - silent
    return Expected(**best)


def read_scene(path: Path) -> dict:
    return json.loads(path.read_text())
