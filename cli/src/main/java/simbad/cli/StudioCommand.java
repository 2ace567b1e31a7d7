package simbad.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;
import simbad.studio.Studio;

/** {@code simbad studio}. */
@Command(
    name = "studio",
    description = {
      "Show a robot, its sonars and an obstacle live, on a page in the browser: play, step, scrub"
          + " back, drag the robot or the obstacle, see what each sonar reads and why not.",
      "It needs no display. More: docs/guide/studio.md."
    },
    footer = {
      "",
      "The page is for this computer only; its address holds a token. Ctrl-C ends it.",
      "",
      "Example: simbad studio",
      "Example: simbad studio --sensor diagnosed:diagnoses/bench-3 --port 8123"
    })
final class StudioCommand extends Subcommand {
  private static final int GREATEST_PORT = 65_535;

  @Option(
      names = "--sensor",
      paramLabel = "diagnosed:DIR",
      description = "A diagnosis' sensor to choose beside the others; may be given several times.")
  private List<String> diagnosed = new ArrayList<>();

  @Option(
      names = "--port",
      paramLabel = "N",
      defaultValue = "0",
      description = "Port of the page; 0, which is the default, for any that is free.")
  private int port;

  @Override
  protected void run() throws Exception {
    if (port < 0 || port > GREATEST_PORT) {
      throw wrongUsage("--port: " + port + " is not in [0, " + GREATEST_PORT + "]");
    }
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    try (Studio studio = Studio.open(address, sensors())) {
      out().println(studio.url());
      err().println("studio: open this address; Ctrl-C ends it");
      new CountDownLatch(1).await();
    }
  }

  /** The plain sensors, that of the main experiment first, then those of diagnoses. */
  private List<SensorKind> sensors() throws DataFormatException {
    List<SensorKind> sensors = new ArrayList<>(List.of(SensorKind.SHADOW));
    SensorKind.all().stream().filter(kind -> !sensors.contains(kind)).forEach(sensors::add);
    for (String word : diagnosed) {
      SensorKind kind =
          SensorArgument.parse(word)
              .orElseThrow(() -> wrongUsage("--sensor: " + SensorArgument.unknown(word)));
      if (sensors.contains(kind)) {
        throw wrongUsage("--sensor: '" + word + "' is there anyway, or named like another");
      }
      sensors.add(kind);
    }
    return sensors;
  }
}
