package simbad.cli;

import java.util.List;

/** The one list of what {@code simbad} can do. */
final class Subcommands {
  private Subcommands() {}

  /** New instances, in the order in which the help lists them. */
  static List<Subcommand> all() {
    return List.of(
        new RunCommand(),
        new ViewCommand(),
        new DemoCommand(),
        new ProgramCommand(),
        new TableCommand(),
        new BenchCommand(),
        new SensorCommand(),
        new FidelityCommand(),
        new BoardCommand(),
        new FlashInfoCommand(),
        new DatasetCommand(),
        new DiagnoseCommand(),
        new PredictCommand(),
        new EffectsCommand(),
        new ExportCommand(),
        new BlindCheckCommand(),
        new BatchCommand(),
        new BatchPlotCommand(),
        new DocsCommand(),
        new DoctorCommand(),
        new CompletionCommand(),
        new TestCommand(),
        new ReleaseCommand());
  }
}
