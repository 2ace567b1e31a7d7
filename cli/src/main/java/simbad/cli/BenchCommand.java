package simbad.cli;

import picocli.CommandLine.Command;

/** {@code simbad bench}: threshold tables from a real sensor, or from the simulated board. */
@Command(
    name = "bench",
    description = {
      "Measure threshold tables, or readings at given poses, over a serial line.",
      "Guide: docs/guide/bench.md."
    },
    subcommands = {
      BenchPortsCommand.class,
      BenchCaptureCommand.class,
      BenchResumeCommand.class,
      BenchTableCommand.class,
      BenchImportCommand.class,
      BenchMeasureCommand.class
    },
    footer = {"", "Example: simbad bench capture --auto --obstacle angle --out angle-capture"})
final class BenchCommand extends CommandGroup {}
