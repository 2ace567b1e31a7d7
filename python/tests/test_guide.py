"""The guide's programs, as they stand there, are run."""

import re
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
GUIDE = (PROJECT / "docs" / "guide" / "python.md").read_text(encoding="utf-8")
PROGRAMS = re.findall(r"```python\n(.*?)```", GUIDE, re.DOTALL)


@pytest.mark.parametrize("number", range(len(PROGRAMS)))
def test_program_of_the_guide_runs(number: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(PROJECT)
    monkeypatch.setenv("MPLBACKEND", "Agg")
    code = PROGRAMS[number]
    assert len(code.splitlines()) <= 20
    said: list[str] = []
    exec(code, {"print": lambda *words: said.append(" ".join(map(str, words)))})
    for promised in re.findall(r"# prints: (.*)", code):
        assert promised in said


def test_there_are_programs() -> None:
    assert len(PROGRAMS) >= 2
