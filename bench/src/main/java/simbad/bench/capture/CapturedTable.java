package simbad.bench.capture;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.ToDoubleFunction;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.Provenance;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/**
 * The table that a capture came to.
 *
 * @param document thresholds and where they come from
 * @param fits of the bearings, in their order
 */
public record CapturedTable(TableDocument document, List<ThresholdFit> fits) {
  /** Copies the list. */
  public CapturedTable {
    fits = List.copyOf(fits);
  }

  /**
   * Makes the table of a journal.
   *
   * @param text journal of a capture that is done
   * @param state of the sweep after its last entry
   * @throws DataFormatException if bearings are missing, or the journal's settings are damaged
   */
  public static CapturedTable of(JournalText text, SweepState state) throws DataFormatException {
    CaptureSettings settings = CaptureSettings.of(text);
    SweepPlan plan = settings.plan();
    OptionalInt missing = state.nextBearing(plan);
    if (missing.isPresent()) {
      throw DataFormatException.inFile(
          text.file(),
          String.format(
              Locale.ROOT,
              "%d of %d bearings are done, the next is %.4g degrees; to continue: simbad "
                  + "bench resume",
              state.doneCount(),
              plan.bearings(),
              plan.bearingDeg(missing.getAsInt())));
    }
    List<ThresholdFit> fits = new ArrayList<>();
    for (int bearing = 0; bearing < plan.bearings(); bearing++) {
      if (state.levels(bearing).isEmpty()) {
        throw DataFormatException.inFile(
            text.file(), "bearing " + bearing + " is done without any reading");
      }
      fits.add(ThresholdFit.of(state.levels(bearing), plan));
    }
    ThresholdBand band =
        new ThresholdBand(table(fits, ThresholdFit::lowM), table(fits, ThresholdFit::highM));
    return new CapturedTable(
        new TableDocument(
            table(fits, ThresholdFit::thresholdM),
            header(settings, text, state),
            Optional.of(band)),
        fits);
  }

  /** In steps of a tenth of a millimetre. */
  private static ThresholdTable table(
      List<ThresholdFit> fits, ToDoubleFunction<ThresholdFit> distanceM) {
    return ThresholdTable.of(
        fits.stream().mapToDouble(distanceM).map(m -> Math.rint(m * 1e4) / 1e4).toArray());
  }

  private static Map<String, String> header(
      CaptureSettings settings, JournalText text, SweepState state) {
    SweepPlan plan = settings.plan();
    Map<String, String> header = new LinkedHashMap<>();
    header.put("object", settings.of("obstacle"));
    header.put("sensor", settings.of("sensor"));
    header.put("provenance", Provenance.CAPTURED.word());
    header.put("source", simulation(settings) + "journal sha256 " + text.sha256());
    header.put("date", settings.of("date"));
    header.put("unit", "m");
    header.put("resolution", Double.toString(plan.stepM()));
    header.put("band", "threshold_low_m to threshold_high_m, 95 % confidence interval");
    header.put("pings", state.pings() + " in all, " + plan.pings() + " at each distance");
    header.put("lost", "from " + plan.misses() + " misses of " + plan.pings() + " on");
    settings.ranging().describe(header, settings.temperatureC().isPresent());
    header.put("firmware", settings.of("firmware"));
    header.put("captured with", settings.of("version"));
    header.values().removeIf(String::isEmpty);
    return header;
  }

  /** Said wherever the table is shown: nobody shall take it for a real sensor's. */
  private static String simulation(CaptureSettings settings) {
    String model = settings.of("model");
    return model.isEmpty() ? "" : "simulated board, " + model + " model; ";
  }

  /**
   * Returns the table as the text of a file, with the furthest distances heard on the way out and
   * in and the number of pings in further columns.
   */
  public String text() {
    StringBuilder text = new StringBuilder();
    Iterator<ThresholdFit> rows = fits.iterator();
    boolean columns = false;
    for (String line : TableFile.text(document).lines().toList()) {
      text.append(line);
      if (columns) {
        ThresholdFit fit = rows.next();
        text.append(
            String.format(Locale.ROOT, ",%.4f,%.4f,%d", fit.outM(), fit.inM(), fit.pings()));
      } else if (!line.startsWith("#")) {
        text.append(",out_m,in_m,pings");
        columns = true;
      }
      text.append('\n');
    }
    return text.toString();
  }
}
