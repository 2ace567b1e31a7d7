"""Plots for a notebook. Needs ``pip install simbad-sonar[plots]``.

Every function draws into ``ax``, or into new axes, and returns them. Data come first, models on top.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, Optional, Union

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
import pandas as pd
from matplotlib.axes import Axes

from ._commands import Diagnosis, Run, table

Floats = npt.NDArray[np.floating[Any]]


def _edge(obstacle: Union[str, pd.DataFrame]) -> tuple[Floats, Floats]:
    """x and z of a shadow's edge, closed."""
    frame = table(obstacle) if isinstance(obstacle, str) else obstacle
    bearing = np.deg2rad(frame["bearing_deg"].to_numpy(dtype=float))
    metres = frame["threshold_m"].to_numpy(dtype=float)
    x, z = metres * np.sin(bearing), metres * np.cos(bearing)
    return np.append(x, x[0]), np.append(z, z[0])


def plot_shadow(
    obstacle: Union[str, pd.DataFrame],
    paths: Iterable[Floats] = (),
    ax: Optional[Axes] = None,
) -> Axes:
    """Draws the edge of a detection shadow from above, and ways round it.

    Args:
        obstacle: a name, or a table as :func:`simbad_sonar.table` returns it.
        paths: arrays whose first columns are x and z in metres.
        ax: axes to draw into.
    """
    axes = ax if ax is not None else plt.subplots()[1]
    axes.plot(*_edge(obstacle), color="black", linewidth=1, label="edge of the shadow")
    for path in paths:
        axes.plot(path[:, 0], path[:, 1], linewidth=1)
    axes.plot(0, 0, "k+")
    axes.set(xlabel="x (m)", ylabel="z (m), down the page", aspect="equal")
    axes.invert_yaxis()
    axes.legend(loc="upper right")
    return axes


def plot_radial(run: Run, obstacle: str, ax: Optional[Axes] = None) -> Axes:
    """Draws a run's radial errors by bearing, a line for each sensor."""
    rows = run.radial[run.radial["obstacle"] == obstacle]
    axes = ax if ax is not None else plt.subplots()[1]
    for sensor, own in rows.groupby("sensor", sort=False):
        axes.plot(own["bearing_deg"], 100 * own["mean_abs_error_m"], label=str(sensor))
    axes.set(xlabel="bearing (deg)", ylabel="radial error (cm)", title=obstacle)
    axes.legend()
    return axes


def plot_effects(found: Diagnosis, ax: Optional[Axes] = None) -> Axes:
    """Draws how probable each effect is, the most probable on top."""
    shown = found.effects.head(10)[::-1]
    axes = ax if ax is not None else plt.subplots()[1]
    axes.barh(shown["name"], shown["probability"])
    axes.set(xlim=(0, 1), xlabel="probability", title=f"verdict: {found.verdict}")
    return axes


def plot_gap(found: Diagnosis, ax: Optional[Axes] = None) -> Axes:
    """Draws how far the simulation is from held-out readings, with and without the effects."""
    gap = found.gap_cm
    axes = ax if ax is not None else plt.subplots()[1]
    words = ["before", "after", "floor"]
    axes.bar(words, [gap[f"{word}_cm"] for word in words])
    axes.set(ylabel="mean CRPS of a reading (cm)")
    return axes


def plot_forecast(
    forecast: pd.DataFrame, readings: pd.DataFrame, ax: Optional[Axes] = None
) -> Axes:
    """Draws readings over what a model forecast of them: the median, and 90 % between bounds."""
    axes = ax if ax is not None else plt.subplots()[1]
    row = np.arange(len(forecast))
    axes.plot(row, readings["range_m"], "k.", markersize=3, label="read")
    axes.fill_between(row, forecast["q05"], forecast["q95"], alpha=0.3, label="90 % of the forecast")
    axes.plot(row, forecast["q50"], linewidth=1, label="median of the forecast")
    axes.set(xlabel="row", ylabel="range (m)")
    axes.legend()
    return axes
