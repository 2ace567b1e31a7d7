package simbad.experiments.table;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import simbad.scattering.Backscatter;
import simbad.scattering.FittedReceiver;
import simbad.scattering.RangeLimits;
import simbad.scattering.ThresholdPrediction;
import simbad.sonar.format.OutlineDocument;
import simbad.sonar.format.TableDocument;
import simbad.sonar.level.Air;
import simbad.sonar.scene.SonarSpec;

/** A table that is predicted from a cross-section, with the band in which it is uncertain. */
public final class PredictedTable {
  /** An SRF04 gives up after 36 ms; no sonar of its kind hears further, whatever its file says. */
  private static final double TIME_OUT_M = 6.2;

  /** Nearer than the blanking of any ranger, for files that state no minimum. */
  private static final double LEAST_RANGE_M = 0.01;

  private PredictedTable() {}

  /**
   * Predicts a table.
   *
   * @param section the cross-section
   * @param air between sensor and obstacle
   * @param sonar whose name, minimum and maximum range are used
   * @param calibration of the sensor's kind
   * @param bearings how many, evenly spaced from 0
   */
  public static TableDocument of(
      OutlineDocument section, Air air, SonarSpec sonar, FittedReceiver calibration, int bearings) {
    ThresholdPrediction prediction =
        ThresholdPrediction.of(
            Backscatter.of(section.parts(), air, bearings),
            air,
            new RangeLimits(
                Math.max(LEAST_RANGE_M, sonar.minRangeM()),
                Math.min(TIME_OUT_M, sonar.maxRangeM())),
            calibration);
    return new TableDocument(
        prediction.table(), header(section, air, sonar), Optional.of(prediction.band()));
  }

  private static Map<String, String> header(OutlineDocument section, Air air, SonarSpec sonar) {
    Map<String, String> header = new LinkedHashMap<>();
    List.of(
            Map.entry("object", section.header("object").orElse("cross-section without a name")),
            Map.entry("sensor", sonar.name().strip()),
            Map.entry("provenance", "predicted"),
            Map.entry(
                "source",
                "rigid scattering at 40 kHz and the sonar equation (docs/method/scattering.md);"
                    + " calibrated on the one inch obstacles of Kranz 2014"),
            Map.entry("unit", "m"),
            Map.entry("resolution", "0.001"),
            Map.entry("reach_m", String.format(Locale.ROOT, "%.4f", section.reachM())),
            Map.entry("temperature_c", number(air.temperatureC())),
            Map.entry("humidity_percent", number(air.humidityPercent())),
            Map.entry(
                "band",
                "threshold_low_m to threshold_high_m, "
                    + FittedReceiver.COVERAGE_PERCENT
                    + " % of what was calibrated on"))
        .forEach(entry -> header.put(entry.getKey(), entry.getValue()));
    return header;
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.6g", value).replaceAll("\\.?0+$", "");
  }
}
