package simbad.cli;

import java.io.IOException;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import simbad.sonar.format.DataFormatException;

/** {@code --web} of the commands that capture. */
final class WebOption {
  // Set by picocli before anything is run.
  @Spec(Spec.Target.MIXEE)
  @SuppressWarnings("NullAway.Init")
  private CommandSpec spec;

  @Option(
      names = "--web",
      paramLabel = "[ADDRESS:]PORT",
      description =
          "Show the capture on a page of the studio while it goes on. Without ADDRESS only "
              + "this computer can open the page. Its address holds a token.")
  private @Nullable String web;

  /** Shows a capture on the page that was asked for, if any. */
  void show(CaptureRun run) throws IOException, DataFormatException {
    if (web != null) {
      run.showAt(
          WebArgument.parse(web)
              .orElseThrow(
                  () ->
                      new CommandLine.ParameterException(
                          spec.commandLine(), "--web: '" + web + "' is no [ADDRESS:]PORT")));
    }
  }
}
