"""Results of the benchmark as a table for docs/benchmark.md, from files that blind-world's scorer wrote.

    python results.py L1 COMMIT diagnosis=check-L1/check.json trees=trees-L1.json

The first file also gives the trivial rule and the oracle, where it has them.
"""

import json
import sys
from pathlib import Path

KINDS = ("none", "single", "pair", "outside", "faint")
HEAD = ("part", "answers", "mean of the classes", *KINDS, "wrongly explained", "on the truth", "ECE", "AUROC", "commit")


def share(found: dict) -> str:
    return f"{found['hits']}/{found['of']}"


def row(part: str, name: str, found: dict, commit: str) -> tuple:
    low, high = found["class_mean_ci95"]
    standings = found["standings"]
    counts = []
    for kind in KINDS:
        standing = standings.get(kind, {})
        counts.append(f"{standing.get('right', 0)} + {standing.get('cautious', 0)} of {sum(standing.values())}")
    wrong = found["shares"]["all wrongly explained"]
    return (
        part, name, f"{100 * found['class_mean']:.0f} % ({100 * low:.0f} to {100 * high:.0f})", *counts,
        f"{share(wrong)} ({100 * wrong['low95']:.0f} to {100 * wrong['high95']:.0f} %)",
        f"{found['probability_of_truth']:.2f}", f"{found['verdict_calibration']['ece']:.3f}",
        f"{found['unknown']['auroc']:.2f}", commit)


def main():
    part, commit, *files = sys.argv[1:]
    print("| " + " | ".join(HEAD) + " |")
    for number, file in enumerate(files):
        name, path = file.split("=", 1)
        by_sort = next(iter(json.loads(Path(path).read_text())["scores"].values()))
        names = {"diagnosis": name, "baseline": "trivial rule", "oracle": "oracle"}
        for sort, found in by_sort.items():
            if sort == "diagnosis" or number == 0:
                print("| " + " | ".join(row(part, names[sort], found, commit)) + " |")


if __name__ == "__main__":
    main()
