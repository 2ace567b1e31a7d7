package simbad.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import simbad.figures.plot.BeamPlot;
import simbad.figures.plot.Caption;
import simbad.sonar.format.Sensitivity;
import simbad.sonar.format.SensorFile;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.scene.SonarSpec;

/** {@code simbad sensor}: sensors as files. */
@Command(
    name = "sensor",
    description = "Show and plot sensor files, such as those in data/sensors.",
    subcommands = {SensorCommand.Show.class, SensorCommand.Plot.class},
    footer = {"", "Example: simbad sensor show data/sensors/hc-sr04.json"})
final class SensorCommand extends CommandGroup {

  /** {@code simbad sensor show}. */
  @Command(
      name = "show",
      description = "Print a sensor's figures.",
      footer = {"", "Example: simbad sensor show data/sensors/maxbotix-lv-ez1.json"})
  static final class Show extends Subcommand {
    @Parameters(paramLabel = "FILE", description = "A sensor's file (JSON).")
    private Path file = Path.of("");

    @Override
    protected void run() throws Exception {
      SonarSpec spec = SensorFile.read(file);
      out().println(spec.name());
      line("cone half angle %.4g degrees", Math.toDegrees(spec.coneHalfAngleRad()));
      line(
          "range %.4g to %.4g m, steps of %.4g m",
          spec.minRangeM(), spec.maxRangeM(), spec.resolutionM());
      line("noise %.4g m, misses %.4g %%", spec.rangeNoiseM(), 100 * spec.missRate());
      line(
          "a ping every %.4g s, %.4g m/s assumed",
          spec.updatePeriodS(), spec.assumedSoundSpeedMPerS());
      LevelLaw law = spec.levelLaw();
      line(
          "level: %.4g dB at %.4g degrees off the axis, absorption %.3g dB/m, scatter %.3g dB",
          law.beam().twoWayDb(spec.coneHalfAngleRad()) - law.beam().axisDb(),
          Math.toDegrees(spec.coneHalfAngleRad()),
          law.absorptionDbPerM(),
          law.excessSdDb());
      List<String> missing = spec.law().level().missing();
      line("level fields by default: %s", missing.isEmpty() ? "none" : String.join(", ", missing));
    }

    private void line(String format, Object... values) {
      out().println("  " + String.format(Locale.ROOT, format, values));
    }
  }

  /** {@code simbad sensor plot}. */
  @Command(
      name = "plot",
      description =
          "Draw a sensor's sensitivity against the angle off its axis, and the cone that "
              + "stands for it.",
      footer = {"", "Example: simbad sensor plot data/sensors/srf04.json --out srf04.svg"})
  static final class Plot extends Subcommand {
    @Parameters(paramLabel = "FILE", description = "A sensor's file with sensitivity_db.")
    private Path file = Path.of("");

    @Option(names = "--out", paramLabel = "FILE", required = true, description = "*.png or *.svg")
    private Path target = Path.of("");

    @Override
    protected void run() throws Exception {
      requirePicture("--out", target);
      SonarSpec spec = SensorFile.read(file);
      Optional<Sensitivity> found = SensorFile.findSensitivity(file);
      if (found.isEmpty()) {
        throw wrongUsage("FILE: " + file + " has no sensitivity_db to plot");
      }
      Sensitivity curve = found.get();
      OutputFile.refuseExisting(target);
      OutputFile.draw(
          new BeamPlot(
                  new Caption("Sensitivity: " + spec.name(), curve.source().split(";", 2)[0]),
                  curve.points().stream().map(Sensitivity.Point::offAxisDeg).toList(),
                  curve.points().stream().map(Sensitivity.Point::levelDb).toList(),
                  Math.toDegrees(spec.coneHalfAngleRad()))
              .figure(),
          target);
    }
  }
}
