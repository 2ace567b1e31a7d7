"""A rival that learns: amortised model comparison (BayesFlow) on sets of rows.

    python amortised.py rows practice/L1 --out L1.joblib         # folders that blind-world made
    python amortised.py train L1.joblib --out amortised-L1.joblib --seed 1
    python amortised.py rows world --out cases.joblib
    python amortised.py answer amortised-L1.joblib cases.joblib --out answers

An answer is a folder for each case with diagnosis.json, as blind-world's scorer reads it.
"""

import argparse
import json
import sys
from pathlib import Path

import joblib
import numpy as np

import features as sensing
import sheets
from nominal import read_scene


# Chosen on cases that were held out of practice; docs/benchmark.md says how.
SETTINGS = {
    "summary": "deepset", "summaries": 32, "embed": 64, "numbers": True, "rows": 256, "widths": (256, 256), "dropout": 0.3,
    "epochs": 60, "patience": 15, "batch": 64, "rate": 1e-3, "decay": 1e-2,
}
HELD = 0.15
VERDICTS = ("none", "explained", "unexplained")


class Refused(Exception):
    """What was given cannot be used; the message says why."""


def folders(world: Path) -> list:
    if not (world / "cases").is_dir():
        raise Refused(f"{world}: no folder that blind-world made, it has no cases")
    return sorted(path for path in (world / "cases").iterdir() if path.is_dir())


def case(folder: Path) -> tuple:
    if not (folder / "scene.json").exists():
        raise Refused(f"{folder}: no scene.json; only logs of a sonar can be answered")
    scene = read_scene(folder / "scene.json")
    reference = folder / "reference.csv"
    files = [folder / "readings.csv"] + ([reference] if reference.exists() else [])
    read = [sensing.read(scene, file) for file in files]
    with np.errstate(all="ignore"):
        numbers = [sensing.sheet(scene, *one) for one in read]
    sets = [sheets.sheet(scene, *one, number > 0) for number, one in enumerate(read)]
    return sheets.together(*(sets + [None])[:2], folder.name), sensing.compared(*(numbers + [None])[:2])


def truth(world: Path, name: str):
    file = world / "truth" / name / "truth.json"
    return json.loads(file.read_text()) if file.exists() else None


def rows(arguments):
    jobs = [(world, folder) for world in arguments.worlds for folder in folders(world)]
    found = joblib.Parallel(n_jobs=arguments.jobs, verbose=1)(joblib.delayed(case)(folder) for _, folder in jobs)
    names = sorted({name for _, numbers in found for name in numbers})
    joblib.dump(
        {
            "rows": np.stack([rows_ for rows_, _ in found]),
            "names": names,
            "values": np.array([[numbers.get(name, np.nan) for name in names] for _, numbers in found], dtype=np.float32),
            "cases": [folder.name for _, folder in jobs],
            "truths": [truth(world, folder.name) for world, folder in jobs],
        },
        arguments.out)
    print(f"{len(jobs)} cases of {sheets.KEPT} rows and {len(names)} numbers, written to {arguments.out}")


class Scale:
    """Numbers of a case about 0 and of a size about 1; what is missing is 0."""

    def __init__(self, values: np.ndarray):
        with np.errstate(all="ignore"):
            self.kept = np.nanstd(values, axis=0) > 0
        low, self.middle, high = np.nanpercentile(values[:, self.kept], [10, 50, 90], axis=0)
        spread = np.nanstd(values[:, self.kept], axis=0)
        self.unit = np.where(high - low > 0.02 * spread, (high - low) / 2, spread)

    def __call__(self, values: np.ndarray) -> np.ndarray:
        scaled = np.arcsinh((values[:, self.kept] - self.middle) / self.unit)
        return np.clip(np.nan_to_num(scaled), -5, 5).astype(np.float32)


def model_of(told: dict) -> str:
    if told["outside_vocabulary"]:
        return "unknown"
    names = list(told["effects"])
    return names[0] if len(names) == 1 else "several" if names else "none"


def targets(truths: list, effects: list) -> np.ndarray:
    """For each case which model it is, and which effects are present."""
    models = ["none", *effects, "several", "unknown"]
    which = [[float(model == model_of(told)) for model in models] for told in truths]
    present = [[float(name in told["effects"]) for name in effects] for told in truths]
    return np.hstack([which, present]).astype(np.float32)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=2, help="processes at a time")
    steps = parser.add_subparsers(required=True)
    step = steps.add_parser("rows", help="turn worlds into sets of rows")
    step.add_argument("worlds", nargs="+", type=Path)
    step.add_argument("--out", type=Path, required=True)
    step.set_defaults(run=rows)
    arguments = parser.parse_args()
    try:
        arguments.run(arguments)
    except Refused as refused:
        print(f"amortised.py: {refused}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
