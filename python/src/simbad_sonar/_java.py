"""One Java for this process, started at the first call."""

from __future__ import annotations

import threading
from importlib import resources
from typing import Any, NamedTuple

import jpype


class SonarError(Exception):
    """What a command complained about, in its own words.

    Attributes:
        status: 2 for bad input, 1 for work that failed.
    """

    def __init__(self, message: str, status: int) -> None:
        super().__init__(message)
        self.status = status


class Result(NamedTuple):
    """What a command wrote: its results, and its warnings."""

    out: str
    err: str


# Two commands at once would share the program's temporary folders.
_lock = threading.Lock()


def _start() -> None:
    if jpype.isJVMStarted():
        return
    package = resources.files("simbad_sonar")
    jars = sorted(str(jar) for jar in (package / "jars").iterdir() if jar.name.endswith(".jar"))
    if not jars:
        raise SonarError("this package carries no jars; build it with python/build", 1)
    jpype.startJVM(
        "-Djava.awt.headless=true",
        classpath=jars,
        convertStrings=True,
    )


def java_class(name: str) -> Any:
    """Returns a class of the program."""
    with _lock:
        _start()
        return jpype.JClass(name)


def call(arguments: list[str]) -> Result:
    """Runs one command of ``simbad`` and returns what it printed.

    Raises:
        SonarError: where its exit status is not 0.
    """
    with _lock:
        _start()
        writers = [jpype.JClass("java.io.StringWriter")() for _ in range(2)]
        print_writer = jpype.JClass("java.io.PrintWriter")
        main = jpype.JClass("simbad.cli.Main")
        out, err = (print_writer(writer) for writer in writers)
        status = int(main.run(out, err, jpype.JArray(jpype.JString)(arguments)))
        out.flush()
        err.flush()
        result = Result(*(str(writer.toString()) for writer in writers))
    if status != 0:
        raise SonarError(result.err.strip() or f"simbad ended with status {status}", status)
    return result
