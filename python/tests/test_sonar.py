"""The package beside the command line: the same values."""

import io
import json
import subprocess
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import simbad_sonar as sonar

PROJECT = Path(__file__).resolve().parents[2]
DATA = PROJECT / "data" / "gap" / "angle-against-uniform"


@pytest.fixture(scope="module")
def readings() -> pd.DataFrame:
    return pd.read_csv(DATA / "readings.csv")


@pytest.fixture(scope="module")
def found(readings: pd.DataFrame) -> sonar.Diagnosis:
    return sonar.diagnose(readings, DATA / "scene.json")


def by_command_line(*words: object) -> str:
    jar = PROJECT / "cli" / "target" / "cli.jar"
    libraries = PROJECT / "cli" / "target" / "lib" / "*"
    command = ["java", "-cp", f"{jar}:{libraries}", "simbad.cli.Main", *map(str, words)]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def without_origin(document: dict) -> dict:
    return {key: value for key, value in document.items() if key not in ("provenance", "dataset")}


def test_diagnosis_is_that_of_the_command_line(found: sonar.Diagnosis, tmp_path: Path) -> None:
    by_command_line("diagnose", DATA, "--out", tmp_path / "out")
    other = json.loads((tmp_path / "out" / DATA.name / "diagnosis.json").read_text())
    assert without_origin(dict(found.document)) == without_origin(other)


def test_diagnosis_reads_as_values(found: sonar.Diagnosis) -> None:
    assert found.verdict == "explained"
    assert found.explanation == ["orientation-shadow"]
    assert found.gap_cm["after_cm"] < found.gap_cm["before_cm"]
    assert found.effects.iloc[0]["name"] == "orientation-shadow"
    assert found.report.exists()


def test_forecast_keeps_the_order_and_index_of_rows(
    found: sonar.Diagnosis, readings: pd.DataFrame
) -> None:
    rows = readings.sample(40, random_state=1)
    forecast = found.predict(rows)
    assert list(forecast.index) == list(rows.index)
    assert forecast.shape == (40, 19)
    assert (np.diff(forecast.to_numpy(), axis=1) >= 0).all()
    nominal = sonar.predict(found, rows, model="nominal")
    assert not nominal.equals(forecast)


def test_scene_may_be_a_dictionary(readings: pd.DataFrame) -> None:
    scene = json.loads((DATA / "scene.json").read_text())
    assert sonar.audit(readings, scene).empty


def test_audit_names_centimetres(readings: pd.DataFrame) -> None:
    wrong = readings.assign(range_m=100 * readings["range_m"])
    findings = sonar.audit(wrong, DATA / "scene.json")
    assert findings["what"].str.contains("centimetres").any()


def test_bad_rows_are_refused_with_line_and_field(readings: pd.DataFrame) -> None:
    wrong = readings.astype({"t_s": object})
    wrong.loc[3, "t_s"] = "soon"
    with pytest.raises(sonar.SonarError, match="readings.csv:5: t_s: 'soon'") as raised:
        sonar.diagnose(wrong, DATA / "scene.json")
    assert raised.value.status == 2


def test_run_measures_against_the_table() -> None:
    driven = sonar.run("round", sensor=["shadow"], speed=0.5)
    assert driven.errors.loc[0, "mean_abs_cm"] < 2
    assert len(driven.radial) == 72
    assert set(driven.radial["obstacle"]) == {"round"}


def test_batch_has_a_row_for_each_run() -> None:
    spec = {
        "format": "simbad-batch/1",
        "obstacles": ["round"],
        "sensors": ["shadow"],
        "speeds_m_per_s": [0.5],
        "controllers": [{"name": "edge-follower", "parameters": {}}],
    }
    results = sonar.batch(spec).results
    assert list(results["status"]) == ["done"]


def test_table_is_that_of_the_file() -> None:
    table = sonar.table("angle")
    lines = (PROJECT / "data" / "threshold-plots" / "angle-25mm.csv").read_text().splitlines()
    rows = "\n".join(line for line in lines if not line.startswith("#"))
    file = pd.read_csv(io.StringIO(rows))
    np.testing.assert_array_equal(table["threshold_m"], file["threshold_m"])
    assert table.attrs["provenance"] == "measured"


def test_unknown_obstacle_is_an_error() -> None:
    with pytest.raises(sonar.SonarError):
        sonar.table("no-such-obstacle.csv")


def test_command_says_what_the_program_says() -> None:
    assert sonar.version().startswith("simbad ")
    with pytest.raises(sonar.SonarError, match="no-such-word") as raised:
        sonar.command("no-such-word")
    assert raised.value.status == 2
