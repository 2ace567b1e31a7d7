package simbad.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import simbad.bench.link.PortLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.session.Ranger;

/** {@code simbad bench ports}. */
@Command(
    name = "ports",
    description = {
      "List this machine's serial ports, and what answers at each.",
      "A pseudo-terminal, such as the simulated board's, is not listed; name it to " + "ask it."
    },
    footer = {"", "Example: simbad bench ports /dev/ttyUSB0"})
final class BenchPortsCommand extends Subcommand {
  private static final Duration LIMIT = Duration.ofSeconds(2);

  @Parameters(paramLabel = "PORT", arity = "0..*", description = "Only these.")
  private List<Path> named = new ArrayList<>();

  @Override
  protected void run() {
    List<Path> ports = named.isEmpty() ? PortLink.ports().stream().map(Path::of).toList() : named;
    if (ports.isEmpty()) {
      out().println("no serial ports here");
    }
    for (Path port : ports) {
      ask(port);
    }
  }

  private void ask(Path port) {
    try (Ranger ranger = Ranger.connect(PortLink.open(port), LIMIT, FirmwareMode.FRAME)) {
      FrameLine.Identity identity = ranger.identity();
      out()
          .println(
              port + ": " + identity.name() + " " + identity.version() + " " + identity.build());
    } catch (IOException e) {
      String said = String.valueOf(e.getMessage());
      complain(new IOException(said.startsWith(port + ":") ? said : port + ": " + said, e));
    }
  }
}
