package simbad.experiments.cli;

/** A command that only holds others, such as {@code simbad table}. */
abstract class CommandGroup extends Subcommand {
  @Override
  protected final void run() {
    throw wrongUsage("no command given");
  }
}
