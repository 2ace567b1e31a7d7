package simbad.cli;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.UnknownHostException;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;
import simbad.sonar.format.DataFormatException;

/** {@code --web} of the commands that capture. */
final class WebOption {
  private static final Pattern FORM = Pattern.compile("(?:(\\[?[0-9A-Fa-f.:]+\\]?):)?(\\d{1,5})");
  private static final int GREATEST_PORT = 65535;

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
          place(web)
              .orElseThrow(
                  () ->
                      new CommandLine.ParameterException(
                          spec.commandLine(), "--web: '" + web + "' is no [ADDRESS:]PORT")));
    }
  }

  /**
   * Where a page shall be: {@code PORT} on this computer only, or {@code ADDRESS:PORT}. Empty for
   * what is no such place; names are none, for they may mean any computer.
   */
  static Optional<InetSocketAddress> place(String word) {
    Matcher matcher = FORM.matcher(word);
    if (!matcher.matches() || Integer.parseInt(matcher.group(2)) > GREATEST_PORT) {
      return Optional.empty();
    }
    int port = Integer.parseInt(matcher.group(2));
    String address = matcher.group(1);
    try {
      InetAddress at =
          address == null ? InetAddress.getLoopbackAddress() : InetAddress.getByName(address);
      return Optional.of(new InetSocketAddress(at, port));
    } catch (UnknownHostException e) {
      return Optional.empty();
    }
  }
}
