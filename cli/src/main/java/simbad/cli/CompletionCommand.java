package simbad.cli;

import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code simbad completion}: what the shell needs to complete commands and options. */
@Command(
    name = "completion",
    description = "Print a script that lets bash, or zsh, complete simbad's commands and options.",
    footer = {
      "",
      "Example: simbad completion > ~/.simbad-completion",
      "Then type here, and write into ~/.bashrc: source ~/.simbad-completion"
    })
final class CompletionCommand extends Subcommand {
  @Spec
  @SuppressWarnings("NullAway.Init")
  private CommandSpec command;

  @Override
  protected void run() {
    out().print(AutoComplete.bash("simbad", command.root().commandLine()));
    out().flush();
  }
}
