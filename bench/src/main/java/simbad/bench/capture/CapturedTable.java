package simbad.bench.capture;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.Provenance;
import simbad.sonar.format.TableDocument;
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
              "%d of %d bearings are done, the next is %.4g degrees; go on with simbad bench resume",
              state.doneCount(),
              plan.bearings(),
              plan.bearingDeg(missing.getAsInt())));
    }
    List<ThresholdFit> fits = new ArrayList<>();
    double[] thresholdsM = new double[plan.bearings()];
    for (int bearing = 0; bearing < thresholdsM.length; bearing++) {
      if (state.levels(bearing).isEmpty()) {
        throw DataFormatException.inFile(
            text.file(), "bearing " + bearing + " is done without any reading");
      }
      fits.add(ThresholdFit.of(state.levels(bearing), plan));
      thresholdsM[bearing] = Math.rint(fits.get(bearing).thresholdM() * 1e4) / 1e4;
    }
    return new CapturedTable(
        new TableDocument(ThresholdTable.of(thresholdsM), header(settings, text, state)), fits);
  }

  private static Map<String, String> header(
      CaptureSettings settings, JournalText text, SweepState state) {
    SweepPlan plan = settings.plan();
    Map<String, String> header = new LinkedHashMap<>();
    header.put("object", settings.of("obstacle"));
    header.put("sensor", settings.of("sensor"));
    header.put("provenance", Provenance.CAPTURED.word());
    header.put("source", "journal sha256 " + text.sha256());
    header.put("date", settings.of("date"));
    header.put("unit", "m");
    header.put("resolution", Double.toString(plan.stepM()));
    header.put("pings", state.pings() + " in all, " + plan.pings() + " at each distance");
    header.put("lost", "from " + plan.misses() + " misses of " + plan.pings() + " on");
    settings.ranging().describe(header, settings.temperatureC().isPresent());
    header.put("firmware", settings.of("firmware"));
    header.put("captured with", settings.of("version"));
    header.values().removeIf(String::isEmpty);
    return header;
  }

  /** Returns the table as the text of a file, with the interval of each bearing. */
  public String text() {
    StringBuilder text = new StringBuilder();
    document.header().forEach((key, value) -> text.append("# " + key + ": " + value + "\n"));
    text.append("bearing_deg,threshold_m,low_m,high_m,out_m,in_m,pings\n");
    for (int i = 0; i < fits.size(); i++) {
      ThresholdFit fit = fits.get(i);
      text.append(
          String.format(
              Locale.ROOT,
              "%s,%s,%.4f,%.4f,%.4f,%.4f,%d%n",
              Double.toString(i * 360.0 / fits.size()).replaceFirst("\\.0$", ""),
              document.table().valueM(i),
              fit.lowM(),
              fit.highM(),
              fit.outM(),
              fit.inM(),
              fit.pings()));
    }
    return text.toString();
  }
}
