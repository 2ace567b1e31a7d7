"""Simbad Sonar: where a simulated range sensor and a real one part, and why.

Every function calls the command of the same name in this process and returns its results as pandas
frames, so that the values are those of the command line. What a command would complain about is
raised as :class:`SonarError` with the same words.
"""

from ._commands import (
    Batch,
    Diagnosis,
    Run,
    Scene,
    audit,
    batch,
    command,
    diagnose,
    predict,
    run,
    table,
    version,
)
from ._java import SonarError

__all__ = [
    "Batch",
    "Diagnosis",
    "Run",
    "Scene",
    "SonarError",
    "audit",
    "batch",
    "command",
    "diagnose",
    "predict",
    "run",
    "table",
    "version",
]
