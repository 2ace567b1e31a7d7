package simbad.scattering;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.stream.IntStream;
import simbad.sonar.level.Air;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * What Kranz (2014) says of the thresholds of his three obstacles, to calibrate on: the angle's in
 * numbers (appendix A.2), the other two's in three sentences.
 *
 * @param square cross-section of the square tube, flat sides across the axes
 * @param round cross-section of the round tube
 * @param air of the bench; the thesis names neither temperature nor humidity
 */
public record ThesisThresholds(Outline square, Outline round, Air air) {
  private static final double ROUND_M = 2.0;
  private static final double FACE_M = 2.5;
  private static final double CORNER_M = 0.2;

  /** Bearings from 25 to 65 degrees. */
  private static final int FIRST_OF_CORNER = 5;

  private static final int LAST_OF_CORNER = 13;

  /**
   * Returns what is said in words: "about two meters" all round the round tube (section 4.1.3),
   * "about 250cm along the flat sides" of the square one and about 20 cm towards its corners
   * (section 4.1.2).
   */
  public List<KnownThresholds> inWords() {
    Backscatter echo = echo(square);
    Map<Integer, Double> corner = new TreeMap<>();
    IntStream.rangeClosed(FIRST_OF_CORNER, LAST_OF_CORNER).forEach(i -> corner.put(i, CORNER_M));
    return List.of(
        new KnownThresholds(echo, Map.of(0, FACE_M)),
        new KnownThresholds(echo, corner),
        new KnownThresholds(echo(round), Map.of(0, ROUND_M)));
  }

  /**
   * Returns the words and the angle's measured table.
   *
   * @param angle the angle's cross-section, in the table's frame
   * @param table its measured thresholds
   */
  public List<KnownThresholds> with(Outline angle, ThresholdTable table) {
    List<KnownThresholds> all = new ArrayList<>(inWords());
    all.add(KnownThresholds.of(List.of(angle), table, air));
    return all;
  }

  private Backscatter echo(Outline outline) {
    return Backscatter.of(List.of(outline), air, KnownThresholds.BEARINGS);
  }
}
