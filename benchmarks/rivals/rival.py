"""A rival that learns: boosted trees on residual slices (scikit-learn's HistGradientBoostingClassifier).

    python rival.py features WORLD... --out features.joblib     # folders that blind-world made
    python rival.py train features.joblib --out rival.joblib
    python rival.py answer rival.joblib features.joblib --out ANSWERS
    python rival.py kinds features.joblib other-features.joblib --answers ANSWERS

An answer is a folder for each case with diagnosis.json, as blind-world's scorer reads it.
"""

import argparse
import json
import os
import sys
from pathlib import Path

# One thread each: small trees wait for one another otherwise.
os.environ.setdefault("OMP_NUM_THREADS", "1")

import joblib
import numpy as np
from sklearn.ensemble import HistGradientBoostingClassifier
from sklearn.metrics import roc_auc_score
from sklearn.model_selection import StratifiedKFold, cross_val_predict

import features as sensing
import motion
from nominal import Refused, folders, truth

SEED = 20261124
VERDICTS = ("none", "explained", "unexplained")


def trees():
    return HistGradientBoostingClassifier(
        learning_rate=0.06, max_iter=250, max_leaf_nodes=15, min_samples_leaf=20, l2_regularization=1.0,
        early_stopping=False, random_state=SEED)


def case(folder: Path) -> dict:
    return motion.case(folder) if (folder / "robot.json").exists() else sensing.case(folder)


def features(arguments):
    jobs = [(world, folder) for world in arguments.worlds for folder in folders(world)]
    found = joblib.Parallel(n_jobs=arguments.jobs, verbose=1)(joblib.delayed(case)(folder) for _, folder in jobs)
    # A name that is not there for a case, such as that of strange echoes where there are none, is a missing value.
    names = sorted({name for one in found for name in one})
    joblib.dump(
        {
            "names": names,
            "values": np.array([[one.get(name, np.nan) for name in names] for one in found], dtype=np.float32),
            "cases": [folder.name for _, folder in jobs],
            "truths": [truth(world, folder.name) for world, folder in jobs],
        },
        arguments.out)
    print(f"{len(jobs)} cases, {len(names)} features, written to {arguments.out}")


def verdict(told: dict) -> str:
    if told["outside_vocabulary"]:
        return "unexplained"
    return "explained" if told["effects"] else "none"


def columns(data: dict, names: list) -> np.ndarray:
    where = {name: i for i, name in enumerate(data["names"])}
    return np.column_stack(
        [data["values"][:, where[name]] if name in where else np.full(len(data["cases"]), np.nan) for name in names])


def train(arguments):
    data = [joblib.load(file) for file in arguments.features]
    names = sorted({name for one in data for name in one["names"]})
    x = np.vstack([columns(one, names) for one in data])
    truths = [told for one in data for told in one["truths"]]
    verdicts = np.array([VERDICTS.index(verdict(told)) for told in truths])
    effects = sorted({name for told in truths for name in told["effects"] if name not in told["outside_vocabulary"]})
    folds = StratifiedKFold(5, shuffle=True, random_state=SEED)
    guessed = cross_val_predict(trees(), x, verdicts, cv=folds, method="predict_proba", n_jobs=arguments.jobs)
    print(f"{len(truths)} cases; cross-validated verdicts right: {np.mean(guessed.argmax(axis=1) == verdicts):.3f}")
    model = {"names": names, "effects": {}, "verdict": trees().fit(x, verdicts)}
    for name in effects:
        y = np.array([name in told["effects"] for told in truths])
        if y.sum() >= 10:
            model["effects"][name] = trees().fit(x, y)
            print(f"  {name}: {y.sum()} cases")
    joblib.dump(model, arguments.out)


def answer(arguments):
    model = joblib.load(arguments.model)
    data = joblib.load(arguments.features)
    x = columns(data, model["names"])
    verdicts = model["verdict"].predict_proba(x)
    chances = {name: trees_.predict_proba(x)[:, 1] for name, trees_ in model["effects"].items()}
    for number, name in enumerate(data["cases"]):
        stated = dict(zip(VERDICTS, map(float, verdicts[number])))
        listed = sorted(((float(chances[e][number]), e) for e in chances), key=lambda pair: (-pair[0], pair[1]))
        said = max(VERDICTS, key=lambda word: stated[word])
        named = [e for p, e in listed if p > 0.5] or [listed[0][1]]
        folder = arguments.out / name
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "diagnosis.json").write_text(json.dumps({
            "format": "sonar-diagnosis/1",
            "dataset": name,
            "verdict": said,
            "explanation": named if said == "explained" else [],
            "unknown_probability": stated["unexplained"],
            "verdict_probability": stated,
            "effects": [{"name": e, "probability": p} for p, e in listed],
        }, indent=1) + "\n")
    print(f"{len(data['cases'])} answers, written to {arguments.out}")


def kinds(arguments):
    """How well trees tell a kind of world without a name that they learnt from, and one that they never saw."""
    data, other = joblib.load(arguments.features), joblib.load(arguments.other)
    x, z = columns(data, data["names"]), columns(other, data["names"])
    kind, asked = (np.array([(told["outside_vocabulary"] or [""])[0] for told in one["truths"]]) for one in (data, other))

    def chances(kept):
        return trees().fit(x[kept], kind[kept] != "").predict_proba(z)[:, 1]

    def said(name):
        file = arguments.answers / name / "diagnosis.json"
        return json.loads(file.read_text())["unknown_probability"] if file.exists() else 0.5

    # What is missing is a number that says how many echoes fewer came than the nominal model expects.
    alike = {"learnt": chances(np.full(len(kind), True)), "missing": -np.nan_to_num(columns(other, ["surplus"])[:, 0])}
    if arguments.answers:
        alike["ANSWERS"] = np.array([said(name) for name in other["cases"]])
    rows = []
    for one in sorted(set(asked) - {""}):
        among = (asked == one) | (asked == "")
        each = {**alike, "unseen": chances(kind != one)}
        rows.append((one, np.sum(asked == one), {by: roc_auc_score(asked[among] != "", p[among]) for by, p in each.items()}))
    shown = ["learnt", "unseen", "missing"] + (["ANSWERS"] if arguments.answers else [])
    print("AUROC of what has no name, by its kind: trees that learnt the kind, trees that did not see it, echoes that are missing")
    print(f"  {'kind':20} cases " + " ".join(f"{by:>8}" for by in shown))
    for one, cases, figures in rows:
        print(f"  {one:20} {cases:5} " + " ".join(f"{figures[by]:8.2f}" for by in shown))
    weights = [cases for _, cases, _ in rows]
    print(f"  {'all':20} {sum(weights):5} " + " ".join(
        f"{np.average([figures[by] for _, _, figures in rows], weights=weights):8.2f}" for by in shown))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--jobs", type=int, default=2, help="processes at a time")
    steps = parser.add_subparsers(required=True)
    step = steps.add_parser("features", help="turn worlds into numbers")
    step.add_argument("worlds", nargs="+", type=Path)
    step.add_argument("--out", type=Path, required=True)
    step.set_defaults(run=features)
    step = steps.add_parser("train", help="learn from worlds whose truth is known")
    step.add_argument("features", nargs="+", type=Path)
    step.add_argument("--out", type=Path, required=True)
    step.set_defaults(run=train)
    step = steps.add_parser("answer", help="answer cases")
    step.add_argument("model", type=Path)
    step.add_argument("features", type=Path)
    step.add_argument("--out", type=Path, required=True)
    step.set_defaults(run=answer)
    step = steps.add_parser("kinds", help="see how trees tell what has no name where they never saw its kind")
    step.add_argument("features", type=Path, help="to learn from")
    step.add_argument("other", type=Path, help="features of other worlds whose truth is known")
    step.add_argument("--answers", type=Path, help="of a program on the other worlds, to stand beside")
    step.set_defaults(run=kinds)
    arguments = parser.parse_args()
    try:
        arguments.run(arguments)
    except Refused as refused:
        print(f"rival.py: {refused}", file=sys.stderr)
        sys.exit(2)


if __name__ == "__main__":
    main()
