"""A rival that learns: amortised model comparison (BayesFlow) on sets of rows.

    python amortised.py rows practice/L1 --out L1.joblib         # folders that blind-world made
    python amortised.py rows practice/L2 --out L2.joblib
    python amortised.py train L1.joblib L2.joblib --out amortised-1.joblib --seed 1
    python amortised.py rows world --out cases.joblib
    python amortised.py answer amortised-1.joblib cases.joblib --out answers

Networks learn better from both parts together, and several networks (other seeds) may answer together:
their mean. An answer is a folder for each case with diagnosis.json, as blind-world's scorer reads it.
"""

import argparse
import itertools
import json
import sys
from pathlib import Path

import joblib
import numpy as np

import features as sensing
import sheets
from nominal import Refused, folders, read_scene, truth

# Chosen on cases that were held out of practice; docs/benchmark.md says how.
SETTINGS = {
    "summaries": 32, "embed": 48, "rows": 128, "widths": (256, 256), "dropout": 0.4,
    "masked": 0.15, "epochs": 10, "patience": 4, "batch": 64, "rate": 1e-3, "decay": 1e-2,
}

# Held out of what is learnt from, the same cases whatever the seed.
HELD = 0.15
HELD_BY = 20261129

VERDICTS = ("none", "explained", "unexplained")


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
        told = np.isfinite(values).any(axis=0)
        self.kept = np.flatnonzero(told)[np.nanstd(values[:, told], axis=0) > 0]
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


def held_in(file: Path, name: str, step: str) -> dict:
    """What a step of this program wrote; the name is of something that it holds."""
    if not file.is_file():
        raise Refused(f"{file}: no such file")
    try:
        held = joblib.load(file)
    except Exception:  # Whatever a file of another sort makes of the reader.
        held = None
    if not isinstance(held, dict) or name not in held:
        raise Refused(f"{file}: not written by amortised.py {step}")
    return held


def cases_of(files: list) -> dict:
    """What one or more files of rows hold, together."""
    data = [held_in(file, "rows", "rows") for file in files]
    if any(one["names"] != data[0]["names"] for one in data):
        raise Refused("the files of rows have different numbers; write them anew with one version of this program")
    together = {name: np.concatenate([one[name] for one in data]) for name in ("rows", "values")}
    lists = {name: [item for one in data for item in one[name]] for name in ("cases", "truths")}
    return {**together, **lists, "names": data[0]["names"]}


def networks():
    """The module of networks: only where it is used, because it takes seconds to load."""
    try:
        import network
    except ImportError as missing:
        raise Refused(f"{missing}; pip install -r benchmarks/rivals/requirements-amortised.txt") from None
    return network


def train(arguments):
    data = cases_of(arguments.rows)
    truths = data["truths"]
    if None in truths:
        raise Refused(f"{truths.count(None)} cases have no truth; learn from folders that have one")
    effects = sorted({name for told in truths for name in told["effects"] if name not in told["outside_vocabulary"]})
    wanted = targets(truths, effects)
    held = np.random.default_rng(HELD_BY).random(len(truths)) < HELD
    scale = Scale(data["values"][~held])
    numbers = scale(data["values"])

    def part(which):
        return {"rows": data["rows"][which], "numbers": numbers[which], "target": wanted[which]}

    network = networks()
    settings = {**SETTINGS, "epochs": arguments.epochs}
    learnt, epoch = network.learn(part(~held), part(held), len(effects) + 3, settings, arguments.seed)
    models, present = learnt.chances({"rows": data["rows"][held], "numbers": numbers[held]})
    right = rightness([said(*one, effects) for one in zip(models, present)], [told for told, h in zip(truths, held) if h])
    print(f"{np.sum(~held)} cases learnt, epoch {epoch}; of {np.sum(held)} held out right: "
          + ", ".join(f"{kind} {share:.2f}" for kind, share in right.items()))
    joblib.dump(
        {
            "effects": effects, "names": data["names"], "scale": scale, "settings": settings,
            "numbers": numbers.shape[1], "weights": learnt.get_weights(),
        },
        arguments.out)
    print(f"written to {arguments.out}")


def given(data: dict, scale: Scale) -> dict:
    return {"rows": data["rows"], "numbers": scale(data["values"])}


def several(present: np.ndarray):
    """Each set of two or three effects among the six most probable, with its share of all of them."""
    odds = np.clip(present, 1e-6, 1 - 1e-6)
    odds = odds / (1 - odds)
    likely = np.argsort(-odds)[:6]
    sets = [chosen for size in (2, 3) for chosen in itertools.combinations(likely, size)]
    weights = np.array([np.prod(odds[list(chosen)]) for chosen in sets])
    return sets, weights / weights.sum()


def said(models: np.ndarray, present: np.ndarray, effects: list) -> tuple:
    """Verdict, names and probabilities of the three verdicts, by those of the models and of each effect."""
    stated = dict(zip(VERDICTS, map(float, (models[0], models[1:-1].sum(), models[-1]))))
    word = max(VERDICTS, key=lambda verdict: stated[verdict])
    if word != "explained":
        return word, [], stated
    # The most probable set of names: one effect, or several, which are taken to be there independently of one another.
    sets, shares = several(present)
    chances = [(chance, (number,)) for number, chance in enumerate(models[1:-2])]
    chances += [(models[-2] * share, chosen) for chosen, share in zip(sets, shares)]
    _, best = max(chances)
    return word, [effects[number] for number in best], stated


def rightness(answers: list, truths: list) -> dict:
    """Share of right answers of each class."""
    found = {"none": [], "single": [], "several": [], "unknown": []}
    for (word, names, _), told in zip(answers, truths):
        model = model_of(told)
        names_right = word == "explained" and set(names) == set(told["effects"])
        right = {"none": word == "none", "unknown": word == "unexplained"}.get(model, names_right)
        found[model if model in found else "single"].append(right)
    return {kind: float(np.mean(rights)) for kind, rights in found.items() if rights}


def answer(arguments):
    data = cases_of([arguments.rows])
    learnt = [held_in(file, "weights", "train") for file in arguments.models]
    effects = learnt[0]["effects"]
    for file, model in zip(arguments.models, learnt):
        if data["names"] != model["names"] or model["effects"] != effects:
            raise Refused(f"{file}: learnt from other numbers or effects than {arguments.rows} or another model has")
    network = networks()
    each = [network.restored(model, len(effects)).chances(given(data, model["scale"])) for model in learnt]
    # Several networks: the mean of what they say.
    for name, models, present in zip(data["cases"], *(np.mean(one, axis=0) for one in zip(*each))):
        write(arguments.out / name, said(models, present, effects), dict(zip(effects, map(float, present))))
    print(f"{len(data['cases'])} answers, written to {arguments.out}")


def write(folder: Path, told: tuple, chances: dict):
    word, names, stated = told
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "diagnosis.json").write_text(json.dumps({
        "format": "sonar-diagnosis/1",
        "dataset": folder.name,
        "verdict": word,
        "explanation": names,
        "unknown_probability": stated["unexplained"],
        "verdict_probability": stated,
        "effects": [{"name": e, "probability": p} for e, p in sorted(chances.items(), key=lambda pair: (-pair[1], pair[0]))],
    }, indent=1) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    steps = parser.add_subparsers(required=True)
    step = steps.add_parser("rows", help="turn worlds into sets of rows")
    step.add_argument("worlds", nargs="+", type=Path, help="folders that blind-world made")
    step.add_argument("--out", type=Path, required=True, help="file to write")
    step.add_argument("--jobs", type=int, default=2, help="processes at a time (2)")
    step.set_defaults(run=rows)
    step = steps.add_parser("train", help="learn from worlds whose truth is known")
    step.add_argument("rows", nargs="+", type=Path, help="files of rows; 15 %% of their cases are held out to choose the epoch")
    step.add_argument("--out", type=Path, required=True, help="file to write")
    step.add_argument("--seed", type=int, default=1, help="chance of the first weights and of the order (1)")
    step.add_argument("--epochs", type=int, default=SETTINGS["epochs"], help=f"most epochs ({SETTINGS['epochs']})")
    step.set_defaults(run=train)
    step = steps.add_parser("answer", help="answer cases")
    step.add_argument("models", nargs="+", type=Path, help="files that train wrote; of several the mean is taken")
    step.add_argument("rows", type=Path, help="file of rows of the cases")
    step.add_argument("--out", type=Path, required=True, help="folder of answers to write")
    step.set_defaults(run=answer)
    arguments = parser.parse_args()
    try:
        if not arguments.out.absolute().parent.is_dir():
            raise Refused(f"{arguments.out}: there is no folder {arguments.out.parent}")
        arguments.run(arguments)
    except Refused as refused:
        print(f"amortised.py: {refused}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
