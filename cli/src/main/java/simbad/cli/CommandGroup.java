package simbad.cli;

/**
 * A command that only holds others, such as {@code simbad table}. By itself it does nothing and
 * says which there are.
 */
abstract class CommandGroup extends Subcommand {
  @Override
  protected final void run() {
    usage(err());
    throw wrongUsage("a command is missing");
  }
}
