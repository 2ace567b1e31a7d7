package simbad.cli;

import java.nio.file.Path;
import java.util.Locale;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import simbad.bench.capture.CapturedReadings;
import simbad.bench.capture.CapturedTable;
import simbad.bench.capture.ThresholdFit;
import simbad.experiments.bench.CaptureFolder;
import simbad.figures.report.TablePicture;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TextFile;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/** {@code simbad bench table}. */
@Command(
    name = "table",
    description = {
      "Make a threshold table from a finished capture. simbad run takes such a table.",
      "Besides bearing and threshold it has the 95 %% interval, the furthest "
          + "distances heard on the way out and on the way in, and the number of pings."
    },
    footer = {
      "",
      "Example: simbad bench table angle-capture --out mine.csv --compare angle --plot mine.svg"
    })
final class BenchTableCommand extends Subcommand {
  private static final double CM = 100;

  @Mixin private CaptureArgument argument = new CaptureArgument();

  @Mixin private TableOutput output = new TableOutput();

  @Option(
      names = "--compare",
      paramLabel = "OBSTACLE",
      description = "Another table. " + ObstacleArgument.MEANING)
  private @Nullable String other;

  @Option(names = "--plot", paramLabel = "FILE", description = "A polar plot, *.png or *.svg.")
  private @Nullable Path plot;

  @Override
  protected void run() throws Exception {
    Path file = output.file();
    if (plot != null) {
      requirePicture("--plot", plot);
      OutputFile.refuseExisting(plot);
    }
    CaptureFolder capture = argument.folder();
    CapturedReadings readings = capture.read();
    CapturedTable table = CapturedTable.of(readings.text(), readings.state());
    ObstacleType type = ObstacleArgument.parse(readings.settings().of("obstacle"));
    if (plot != null) {
      ObstacleType drawn = new ObstacleType(type.name(), type.outline(), table.document());
      OutputFile.draw(TablePicture.of(drawn), plot);
    }
    TextFile.create(file, table.text());
    capture.writeDataSet(readings, type, Catalogue.srf04());
    out()
        .printf(
            Locale.ROOT,
            "%s: %d bearings, mean width of the intervals %.1f cm%n",
            file,
            table.fits().size(),
            CM
                * table.fits().stream()
                    .mapToDouble(fit -> fit.highM() - fit.lowM())
                    .average()
                    .orElse(0));
    if (other != null) {
      compare(table, ObstacleArgument.parse(other).thresholds().table());
    }
  }

  private void compare(CapturedTable table, ThresholdTable known) {
    double sum = 0;
    double least = Double.POSITIVE_INFINITY;
    double most = 0;
    int within = 0;
    int size = table.fits().size();
    ThresholdBand band = table.document().band().orElseThrow();
    for (int i = 0; i < size; i++) {
      ThresholdFit fit = table.fits().get(i);
      double bearingRad = table.document().table().bearingRad(i);
      double knownM = known.thresholdM(bearingRad);
      double difference = Math.abs(fit.thresholdM() - knownM);
      sum += difference;
      least = Math.min(least, difference);
      most = Math.max(most, difference);
      within += band.holds(bearingRad, knownM) ? 1 : 0;
    }
    out()
        .printf(
            Locale.ROOT,
            "against %s: mean difference %.2f cm, %.2f to %.2f cm; %d of %d within the "
                + "interval%n",
            other,
            CM * sum / size,
            CM * least,
            CM * most,
            within,
            size);
  }
}
