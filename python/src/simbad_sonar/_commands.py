"""The commands, with frames in and out."""

from __future__ import annotations

import json
import os
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Union

import numpy as np
import pandas as pd

from ._java import SonarError, call, java_class

AUDIT = ["check", "severity", "file", "what", "rows", "first_rows", "suggestion", "mend"]

DATA_FORMAT = "simbad.sonar.format.DataFormatException"

PathLike = Union[str, "os.PathLike[str]"]

#: A scene as FORMAT.md has it: a dictionary, or a file that holds it.
Scene = Union[Mapping[str, Any], PathLike]


def command(*arguments: object) -> str:
    """Runs any command of ``simbad`` and returns what it prints.

    >>> print(command("table", "show", "round").splitlines()[0])
    round (reconstructed)
    """
    return call([str(argument) for argument in arguments]).out


def version() -> str:
    """Returns the version and the commit of the program."""
    return command("--version").strip()


def _scene_text(scene: Scene) -> str:
    if isinstance(scene, Mapping):
        return json.dumps(scene)
    return Path(scene).read_text(encoding="utf-8")


def _write_set(
    folder: Path, readings: pd.DataFrame, scene: Scene, reference: pd.DataFrame | None
) -> Path:
    folder.mkdir()
    (folder / "scene.json").write_text(_scene_text(scene), encoding="utf-8")
    readings.to_csv(folder / "readings.csv", index=False)
    if reference is not None:
        reference.to_csv(folder / "reference.csv", index=False)
    return folder


@dataclass(frozen=True)
class Diagnosis:
    """What a diagnosis found.

    Attributes:
        document: diagnosis.json as it is.
        folder: where diagnosis.json, model.json, scene.json and report.html stand.
    """

    document: Mapping[str, Any]
    folder: Path
    _kept: Any = None

    @classmethod
    def read(cls, folder: PathLike, kept: Any = None) -> Diagnosis:
        """Reads the folder that ``simbad diagnose`` or :func:`diagnose` wrote."""
        path = Path(folder)
        text = (path / "diagnosis.json").read_text(encoding="utf-8")
        return cls(json.loads(text), path, kept)

    @property
    def verdict(self) -> str:
        """none, explained, partly, unexplained, undecided or refused."""
        return str(self.document["verdict"])

    @property
    def explanation(self) -> list[str]:
        """The effects that explain the log, by name."""
        return list(self.document["explanation"])

    @property
    def unknown_probability(self) -> float:
        """How probable it is that something without a name is at work."""
        return float(self.document["unknown_probability"])

    @property
    def gap_cm(self) -> Mapping[str, Any]:
        """before_cm, after_cm, floor_cm and what they shrink by."""
        return dict(self.document["gap"])

    @property
    def effects(self) -> pd.DataFrame:
        """A row for each effect that was looked for, the most probable first."""
        return pd.DataFrame(self.document["effects"])

    @property
    def report(self) -> Path:
        """The page for people."""
        return self.folder / "report.html"

    def predict(self, rows: pd.DataFrame, model: str = "diagnosed") -> pd.DataFrame:
        """Forecasts rows, as :func:`predict`."""
        return predict(self.folder, rows, model)


def diagnose(
    readings: pd.DataFrame,
    scene: Scene,
    reference: pd.DataFrame | None = None,
    out: PathLike | None = None,
) -> Diagnosis:
    """Finds where readings and the simulation of their scene part, and which effect does it.

    Args:
        readings: run, sensor, t_s, x_m, z_m, heading_deg, range_m; NaN in range_m for no echo.
        scene: a dictionary or a file, as FORMAT.md has it.
        reference: readings in the same columns, of the set-up while the simulation was trusted.
        out: a folder that does not exist yet, for the files; a temporary one if none is given,
            which lives as long as the result.

    Raises:
        SonarError: with the file, the line, the field and what was expected.
    """
    work = tempfile.TemporaryDirectory(prefix="simbad-sonar-")
    data = _write_set(Path(work.name) / "data", readings, scene, reference)
    results = Path(work.name) / "out" if out is None else Path(out)
    call(["diagnose", str(data), "--out", str(results)])
    return Diagnosis.read(results / "data", None if out is not None else work)


def audit(
    readings: pd.DataFrame, scene: Scene, reference: pd.DataFrame | None = None
) -> pd.DataFrame:
    """Looks at a log before anything is fitted: units, axes, clocks, held values and the like.

    Returns:
        A row for each finding, none for a clean log: check, severity (note, warn or refused),
        file, what, rows, first_rows, suggestion, mend.
    """
    with tempfile.TemporaryDirectory(prefix="simbad-sonar-") as work:
        data = _write_set(Path(work) / "data", readings, scene, reference)
        results = Path(work) / "out"
        try:
            call(["diagnose", str(data), "--audit-only", "--out", str(results)])
        except SonarError:
            if not (results / "data" / "diagnosis.json").exists():
                raise
        found = Diagnosis.read(results / "data").document["audit"]
    return pd.DataFrame(found, columns=AUDIT)


def predict(
    diagnosis: PathLike | Diagnosis, rows: pd.DataFrame, model: str = "diagnosed"
) -> pd.DataFrame:
    """Forecasts readings at the poses of some rows.

    Args:
        diagnosis: what was found, or the folder of it.
        rows: run, sensor, t_s, x_m, z_m, heading_deg; what stands in range_m is not looked at.
        model: diagnosed, or nominal for the simulator as it was believed.

    Returns:
        The index of rows, the quantiles q05 to q95 in metres; no echo counts as no_echo_m.
    """
    folder = diagnosis.folder if isinstance(diagnosis, Diagnosis) else Path(diagnosis)
    with tempfile.TemporaryDirectory(prefix="simbad-sonar-") as work:
        source, target = Path(work) / "rows.csv", Path(work) / "forecast.csv"
        rows.to_csv(source, index=False)
        call(["predict", str(folder), str(source), "--out", str(target), "--model", model])
        forecast = pd.read_csv(target)
    forecast.index = rows.index
    return forecast


@dataclass(frozen=True)
class Run:
    """What robots drove round obstacles.

    Attributes:
        errors: a row for each obstacle and sensor: errors against the table in centimetres.
        radial: by obstacle and bearing: the table's threshold and the error there, metres.
    """

    errors: pd.DataFrame
    radial: pd.DataFrame


def run(*obstacles: str, sensor: Iterable[str] = ("original", "shadow"), **options: object) -> Run:
    """Drives a robot along the edge of obstacles, once with each sensor.

    Args:
        obstacles: as ``simbad run`` names them; all of the catalogue if none is given.
        sensor: words of ``--sensor``.
        options: further options of ``simbad run``: speed=0.1, seed=3.
    """
    with tempfile.TemporaryDirectory(prefix="simbad-sonar-") as work:
        results = Path(work) / "out"
        call(
            ["run", *obstacles, "--sensor", ",".join(sensor), "--out", str(results)]
            + _words(options)
        )
        radial = {path.parent.name: pd.read_csv(path) for path in results.glob("*/radial.csv")}
        errors = pd.read_csv(results / "errors.csv")
    joined = pd.concat(radial, names=["obstacle"]).reset_index(level=0).reset_index(drop=True)
    return Run(errors, joined)


@dataclass(frozen=True)
class Batch:
    """What a batch measured.

    Attributes:
        results: a row for each run.
    """

    results: pd.DataFrame


def batch(spec: Mapping[str, Any] | PathLike, **options: object) -> Batch:
    """Runs every combination of a batch's specification (docs/guide/batch.md)."""
    with tempfile.TemporaryDirectory(prefix="simbad-sonar-") as work:
        file = Path(work) / "spec.json"
        file.write_text(_scene_text(spec), encoding="utf-8")
        results = Path(work) / "out"
        call(["batch", str(file), "--out", str(results)] + _words(options))
        return Batch(pd.read_csv(results / "results.csv"))


def table(obstacle: str) -> pd.DataFrame:
    """Returns an obstacle's threshold table: bearing_deg and threshold_m.

    What its file says of it (object, provenance, source) stands in the frame's ``attrs``.
    """
    document = _obstacle(obstacle).thresholds()
    metres = np.asarray(document.table().valuesM())
    bearings = 360.0 * np.arange(len(metres)) / len(metres)
    frame = pd.DataFrame({"bearing_deg": bearings, "threshold_m": metres})
    frame.attrs.update({str(key): str(value) for key, value in dict(document.header()).items()})
    return frame


def _obstacle(name: str) -> Any:
    known = java_class("simbad.obstacles.Catalogue").findAny(name)
    if known.isPresent():
        return known.get()
    try:
        path = java_class("java.nio.file.Path").of(name)
        return java_class("simbad.obstacles.ObstacleFiles").read(path)
    except (java_class("java.io.IOException"), java_class(DATA_FORMAT)) as error:
        raise SonarError(str(error.getMessage()), 2) from error


def _words(options: Mapping[str, object]) -> list[str]:
    words: list[str] = []
    for name, value in options.items():
        word = "--" + name.replace("_", "-")
        if value is True:
            words.append(word)
        elif value is not None and value is not False:
            words += [word, str(value)]
    return words
