package simbad.cli;

import java.nio.file.Path;
import java.util.Map;
import java.util.Stack;
import picocli.CommandLine.IParameterPreprocessor;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;

/** Of {@code simbad program}, {@code --trace} takes a file; of all other commands, nothing. */
final class TraceFileOption implements IParameterPreprocessor {
  @Override
  @SuppressWarnings({"JdkObsolete", "NonApiType"}) // The signature is picocli's.
  public boolean preprocess(
      Stack<String> args, CommandSpec command, ArgSpec option, Map<String, Object> info) {
    boolean takes = command.userObject() instanceof ProgramCommand && !args.isEmpty();
    if (takes && !args.peek().startsWith("-")) {
      ((ProgramCommand) command.userObject()).setTrace(Path.of(args.pop()));
    }
    return false;
  }
}
