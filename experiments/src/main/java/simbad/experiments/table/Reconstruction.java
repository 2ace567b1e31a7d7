package simbad.experiments.table;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import simbad.sonar.format.TableDocument;
import simbad.sonar.shape.ThresholdTable;

/**
 * The two tables that Kranz (2014) plotted but did not publish, from what is known of them.
 *
 * <p>Known in words (sections 4.1.2 to 4.1.4): the round one is a circle of about 2 m; the square
 * one has about 2.5 m over each flat side and falls to about 0.2 m towards the corners; the angle
 * was placed so that its two outer faces match half of the square. Nothing else is read but the
 * angle's measured table. The argument is in docs/decisions.
 */
public final class Reconstruction {
  private static final int SIZE = 72;
  private static final int SPACING_DEG = 5;
  private static final int QUARTER_DEG = 90;
  private static final int CORNER_DEG = 45;

  /** Bearings of the angle's outer faces, which lie where two faces of the square would. */
  private static final int[] FACES_DEG = {90, 180};

  private static final double SQUARE_GREATEST_M = 2.5;
  private static final double SQUARE_LEAST_M = 0.2;
  private static final double ROUND_M = 2.0;

  /** Step of the measured table. */
  private static final double STEP_M = 0.02;

  private Reconstruction() {}

  /** Returns the round obstacle's table: 2 m all round. */
  public static TableDocument round() {
    return new TableDocument(
        ThresholdTable.uniform(SIZE, ROUND_M),
        header(
            "aluminium tube, 1 inch round (25.4 mm), anodised, upright",
            "a circle of about 2 m (Kranz 2014, section 4.1.3); its table was only plotted"));
  }

  /**
   * Returns the square obstacle's table.
   *
   * <p>The threshold at an angle to a face's normal is the geometric mean of the angle's thresholds
   * at that angle to both sides of both outer faces; all are scaled so that the normal has 2.5 m;
   * none is below 0.2 m; the result is rounded to the measured table's step of 2 cm.
   *
   * @param angle the measured table of the angle, 72 bearings
   */
  public static TableDocument square(ThresholdTable angle) {
    if (angle.size() != SIZE) {
      throw new IllegalArgumentException(
          "angle has " + angle.size() + " bearings; the reconstruction needs " + SIZE);
    }
    double gain = SQUARE_GREATEST_M / faceMeanM(angle, 0);
    double[] thresholds = new double[SIZE];
    for (int i = 0; i < SIZE; i++) {
      int offNormalDeg = Math.abs((i * SPACING_DEG + CORNER_DEG) % QUARTER_DEG - CORNER_DEG);
      double scaled = gain * faceMeanM(angle, offNormalDeg);
      thresholds[i] = stepped(Math.max(SQUARE_LEAST_M, scaled));
    }
    return new TableDocument(
        ThresholdTable.of(thresholds),
        header(
            "aluminium tube, 1 inch square (25.4 mm), anodised, upright, flat sides across the axes",
            "from the outer faces of the angle's measured table (Kranz 2014); mean of both faces and of"
                + " their sides, scaled to 2.5 m at the normal, at least 0.2 m; its own table was only"
                + " plotted (sections 4.1.2, 4.1.4)"));
  }

  private static double faceMeanM(ThresholdTable angle, int offNormalDeg) {
    double meanLog =
        DoubleStream.of(
                value(angle, FACES_DEG[0] + offNormalDeg),
                value(angle, FACES_DEG[0] - offNormalDeg),
                value(angle, FACES_DEG[1] + offNormalDeg),
                value(angle, FACES_DEG[1] - offNormalDeg))
            .map(Math::log)
            .average()
            .orElseThrow();
    return Math.exp(meanLog);
  }

  private static double value(ThresholdTable angle, int bearingDeg) {
    return angle.valueM(bearingDeg / SPACING_DEG);
  }

  /** To the nearest step, in whole hundredths so that no rounding error reaches the file. */
  private static double stepped(double metres) {
    return Math.round(metres / STEP_M) * Math.round(STEP_M * 100) / 100.0;
  }

  private static Map<String, String> header(String object, String source) {
    Map<String, String> header = new LinkedHashMap<>();
    List.of(
            Map.entry("object", object),
            Map.entry("sensor", "Devantech SRF04, 15 cm above a hard floor"),
            Map.entry("provenance", "reconstructed"),
            Map.entry("source", source),
            Map.entry("date", "2026"),
            Map.entry("unit", "m"),
            Map.entry("resolution", Double.toString(STEP_M)))
        .forEach(entry -> header.put(entry.getKey(), entry.getValue()));
    return header;
  }
}
