package simbad.cli;

import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CountDownLatch;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;
import simbad.studio.Choices;
import simbad.studio.Studio;
import simbad.studio.folders.Folders;

/** {@code simbad studio}. */
@Command(
    name = "studio",
    description = {
      "Show a robot, its sonars and an obstacle live on a page in the browser.",
      "You can play, step, go back in time, and drag the robot or the obstacle. The "
          + "page shows what each sonar reads, and why it hears nothing.",
      "With FOLDER the page also shows the runs, batches, captures and diagnoses in "
          + "it. Its pictures answer to the mouse; two can be shown beside each other. "
          + "The robot can drive with each diagnosed sensor, and move as diagnosed.",
      "The command itself needs no display. Guide: docs/guide/studio.md."
    },
    footer = {
      "",
      "Only this computer can open the page; its address holds a token. Ctrl-C ends it.",
      "",
      "Example: simbad studio",
      "Example: simbad studio diagnoses --data data/gap",
      "Example: simbad studio --sensor diagnosed:diagnoses/bench-3 --port 8123"
    })
final class StudioCommand extends Subcommand {
  private static final int GREATEST_PORT = 65_535;

  @Parameters(
      arity = "0..1",
      paramLabel = "FOLDER",
      description = "Folder with runs, batches, captures and diagnoses, at any depth.")
  private Optional<Path> folder = Optional.empty();

  @Option(
      names = "--data",
      paramLabel = "FOLDER",
      description =
          "A further folder in which to look for the data sets of diagnoses. May be repeated.")
  private List<Path> data = new ArrayList<>();

  @Option(
      names = "--sensor",
      paramLabel = "diagnosed:DIR",
      description = "A diagnosed sensor that the page offers besides the others. May be repeated.")
  private List<String> diagnosed = new ArrayList<>();

  @Option(
      names = "--robot",
      paramLabel = "ROBOT",
      description = {
        "A diagnosed robot, or a robot.json, that the page offers. May be repeated.",
        RunCommand.ROBOT + "."
      })
  private List<String> robots = new ArrayList<>();

  @Option(
      names = "--scene",
      paramLabel = "FILE",
      description = "A scene that was saved on the page, at which it opens.")
  private Optional<Path> scene = Optional.empty();

  @Option(
      names = "--port",
      paramLabel = "N",
      defaultValue = "0",
      description = "Port of the page. Default: 0, which takes any free port.")
  private int port;

  @Override
  protected void run() throws Exception {
    if (port < 0 || port > GREATEST_PORT) {
      throw wrongUsage("--port: " + port + " is not in [0, " + GREATEST_PORT + "]");
    }
    if (folder.isEmpty() && !data.isEmpty()) {
      throw wrongUsage("--data: expected FOLDER with it, a folder with diagnoses");
    }
    Optional<Folders> folders =
        folder.isPresent() ? Optional.of(Folders.of(folder.get(), data)) : Optional.empty();
    InetSocketAddress address = new InetSocketAddress(InetAddress.getLoopbackAddress(), port);
    try (Studio studio = Studio.open(address, choices(folders), folders, scene)) {
      out().println(studio.url());
      err().println("studio: open this address; Ctrl-C ends it");
      new CountDownLatch(1).await();
    }
  }

  /** Those of the options, and all that diagnoses in the folder left. */
  private Choices choices(Optional<Folders> folders) throws DataFormatException {
    Map<String, String> options = new HashMap<>();
    Choices named = new Choices(sensors(options), moving(options), options);
    return folders.isPresent() ? named.with(folders.get()) : named;
  }

  private List<RobotKind> moving(Map<String, String> options) throws DataFormatException {
    Map<String, RobotKind> byName = new LinkedHashMap<>();
    for (String word : robots) {
      RobotKind kind = RobotKind.read(word);
      if (byName.put(kind.name(), kind) != null) {
        throw wrongUsage("--robot: two are called " + kind.name());
      }
      options.put(kind.name(), word);
    }
    return List.copyOf(byName.values());
  }

  /** The plain sensors, that of the main experiment first, then those of diagnoses. */
  private List<SensorKind> sensors(Map<String, String> options) throws DataFormatException {
    List<SensorKind> sensors = new ArrayList<>(Choices.plain().sensors());
    for (String word : diagnosed) {
      SensorKind kind =
          SensorKind.read(word)
              .orElseThrow(() -> wrongUsage("--sensor: " + SensorArgument.unknown(word)));
      if (sensors.contains(kind)) {
        throw wrongUsage(
            "--sensor: '" + word + "' is offered anyway, or has the name of another one");
      }
      sensors.add(kind);
      options.put(kind.word(), word);
    }
    return sensors;
  }
}
