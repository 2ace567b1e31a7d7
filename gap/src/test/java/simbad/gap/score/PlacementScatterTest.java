package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Placements;
import simbad.gap.fixture.Ladders;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/**
 * Six placements before a board of four readings each, two a little too short and two as much too
 * long. The same is off at the first as at the last and so on, so that the slope is that of the
 * distances: the median of what is off is 0, and half of it lies within b.
 */
class PlacementScatterTest {
  private static final double OFF_M = 0.01;
  private static final double[] OFFS = {OFF_M, 0, -OFF_M, -OFF_M, 0, OFF_M};

  /** Of a median of normal readings over that of their mean. */
  private static final double HALF_PI = Math.PI / 2;

  private static ReadingRow row(List<ReadingRow> rows, int place, double rangeM) {
    Pose pose = Pose.of(0, 0.5 + 0.3 * place, Math.PI / 2);
    return new ReadingRow("r", "s", 0.1 * rows.size(), pose, new Echo(rangeM));
  }

  private static List<ReadingRow> rows(double withinM, double... offs) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int place = 0; place < offs.length; place++) {
      for (int i = 0; i < 4; i++) {
        double way = i % 2 == 0 ? withinM : -withinM;
        rows.add(row(rows, place, 0.5 + 0.3 * place + offs[place] + way));
      }
    }
    return rows;
  }

  private static CalibratedLog given(SensingSetup setup, List<ReadingRow> rows) {
    return new CalibratedLog(setup, List.of(), new PingLog(rows));
  }

  private static double clumping(SensingSetup setup, List<ReadingRow> rows) {
    CalibratedLog given = given(setup, rows);
    return PlacementScatter.clumping(given, new Placements(given.log()));
  }

  private static double stated(double poseSigmaM, List<ReadingRow> rows) {
    CalibratedLog given = given(Ladders.board(0, poseSigmaM, 0), rows);
    return PlacementScatter.statedClumping(given, new Placements(given.log()));
  }

  private static boolean isNoisier(List<ReadingRow> rows) {
    CalibratedLog given = given(Ladders.BOARD, rows);
    return PlacementScatter.isNoisier(given, new Placements(given.log()));
  }

  /** 1 + (4 - 1) times the share of the variance between placements. */
  private static double effect(double between, double within) {
    return 1 + 3 * between / (between + within);
  }

  /** Both scatter by 1.4826 cm; of what is between, pi / 8 comes from within. */
  @Test
  void designEffect_isOfBothScatters() {
    assertEquals(effect(1 - HALF_PI / 4, 1), clumping(Ladders.BOARD, rows(OFF_M, OFFS)), 1e-9);
    double[] scaled = OFFS.clone();
    for (int i = 0; i < scaled.length; i++) {
      scaled[i] *= 2;
    }
    assertEquals(effect(4 - HALF_PI / 4, 1), clumping(Ladders.BOARD, rows(OFF_M, scaled)), 1e-9);
  }

  /** Less than the sensor scatters nothing does: 3 mm, and a step of 1 cm over root 12. */
  @Test
  void within_isAtLeastAsBelieved() {
    double between = Math.pow(1.4826 * OFF_M, 2);
    double noise = Ladders.NOISE_M * Ladders.NOISE_M;
    assertEquals(
        effect(between - HALF_PI * noise / 4, noise), clumping(Ladders.BOARD, rows(0, OFFS)), 1e-9);
    double stepped = noise + 1e-4 / 12;
    assertEquals(
        effect(between - HALF_PI * stepped / 4, stepped),
        clumping(Ladders.board(0.01, 0, 0), rows(0, OFFS)),
        1e-9);
  }

  @Test
  void placementsThatAreNotOff_doNotHangTogether() {
    assertEquals(1, clumping(Ladders.BOARD, rows(OFF_M, new double[6])), 1e-9);
  }

  /** A line of another slope is a law, and no error of placements. */
  @Test
  void slope_isNotOff() {
    List<ReadingRow> scaled = new ArrayList<>();
    for (ReadingRow row : rows(OFF_M, OFFS)) {
      double more = 0.2 * row.pose().position().zM();
      double range = ((Echo) row.reading()).rangeM() + more;
      scaled.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), new Echo(range)));
    }
    assertEquals(effect(1 - HALF_PI / 4, 1), clumping(Ladders.BOARD, scaled), 1e-9);
  }

  /** Places known to 3 cm may be off by more than they seem to be, known to 1 mm they may not. */
  @Test
  void statedPlaces_countWhereTheyAreWorse() {
    List<ReadingRow> rows = rows(OFF_M, OFFS);
    double within = Math.pow(1.4826 * OFF_M, 2);
    assertEquals(effect(9e-4, within), stated(0.03, rows), 1e-9);
    assertEquals(effect(1 - HALF_PI / 4, 1), stated(0.001, rows), 1e-9);
  }

  /** Misses, readings of nothing, and placements that were read once do not count. */
  @Test
  void whatIsNoEchoOfTheTarget_tellsNothing() {
    List<ReadingRow> rows = rows(OFF_M, OFFS);
    for (int place = 0; place < 6; place++) {
      Pose pose = Pose.of(0, 0.5 + 0.3 * place, Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), pose, NoEcho.NO_ECHO));
      Pose away = Pose.of(0, 0.5 + 0.3 * place, -Math.PI / 2);
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), away, new Echo(2)));
      rows.add(new ReadingRow("r", "s", 0.1 * rows.size(), away, new Echo(3)));
    }
    rows.add(row(rows, 6, 3));
    assertEquals(effect(1 - HALF_PI / 4, 1), clumping(Ladders.BOARD, rows), 1e-9);
    assertFalse(isNoisier(noised(rows, 0.001)));
  }

  /** Every range moved towards its placement's, so that so much scatter is left. */
  private static List<ReadingRow> noised(List<ReadingRow> rows, double withinM) {
    List<ReadingRow> quiet = new ArrayList<>();
    for (ReadingRow row : rows) {
      boolean ahead = row.reading() instanceof Echo && row.pose().heading().radians() < 2;
      double way = quiet.size() % 2 == 0 ? withinM : -withinM;
      Echo echo = new Echo(row.pose().position().zM() + way);
      quiet.add(
          ahead ? new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), echo) : row);
    }
    return quiet;
  }

  /**
   * Four readings to either side by a have three degrees of freedom: they scatter by a root 4/3.
   * 1.2 times the 3 mm that are believed are 3.6 mm, where a is 3.118 mm.
   */
  @Test
  void noisier_isAFifthMoreThanBelieved() {
    assertFalse(isNoisier(rows(0.00311, OFFS)));
    assertTrue(isNoisier(rows(0.00313, OFFS)));
  }

  /** By the same variance: with 1 cm off and 1 cm within, 1.4826 cm less pi / 8 of its square. */
  @Test
  void between_isWhatPlacementsAreOffBy() {
    double variance = Math.pow(1.4826 * OFF_M, 2);
    assertEquals(Math.sqrt(variance * (1 - HALF_PI / 4)), between(rows(OFF_M, OFFS)), 1e-9);
    assertEquals(0, between(rows(OFF_M, new double[6])));
    assertEquals(0, between(List.of()));
    assertEquals(0, between(rows(0.0, OFF_M, OFF_M, OFF_M)), "too few");
  }

  private static double between(List<ReadingRow> rows) {
    CalibratedLog given = given(Ladders.BOARD, rows);
    return PlacementScatter.betweenM(given, new Placements(given.log()));
  }

  /**
   * 1.1554 cm of six placements: of a tape of s they are as much as 1 + 2.326 / root 4.44 = 2.104
   * times s by chance.
   */
  @Test
  void furtherOff_isMoreThanChanceGivesATape() {
    double between = between(rows(OFF_M, OFFS));
    assertTrue(isFurtherOff(0));
    assertTrue(isFurtherOff(between / 2.11));
    assertFalse(isFurtherOff(between / 2.10));
  }

  private static boolean isFurtherOff(double poseSigmaM) {
    CalibratedLog given = given(Ladders.board(0, poseSigmaM, 0), rows(OFF_M, OFFS));
    return PlacementScatter.isFurtherOff(given, new Placements(given.log()));
  }

  /** One reading of something nearer and one of something further make no sensor noisier. */
  @Test
  void noisier_isNotWhatIsFarOff() {
    for (double withinM : new double[] {0.00311, 0.00313}) {
      List<ReadingRow> rows = rows(withinM, OFFS);
      rows.add(row(rows, 2, 0.2));
      rows.add(row(rows, 2, 2.9));
      assertEquals(withinM > 0.00312, isNoisier(rows), withinM + " m");
    }
  }

  /** With one reading to a placement, or three placements, nothing hangs together. */
  @Test
  void whereNothingWasReadAgain_nothingIsKnown() {
    List<ReadingRow> once = new ArrayList<>();
    for (int place = 0; place < 6; place++) {
      once.add(row(once, place, 0.5 + 0.3 * place + OFFS[place]));
    }
    assertEquals(1, clumping(Ladders.BOARD, once));
    assertFalse(isNoisier(once));
    assertEquals(1, clumping(Ladders.BOARD, rows(OFF_M, OFF_M, 0, OFF_M)));
    assertEquals(1, stated(0.03, once));
  }
}
