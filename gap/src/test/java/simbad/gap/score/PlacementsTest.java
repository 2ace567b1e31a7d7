package simbad.gap.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Placements;
import simbad.gap.fixture.Ladders;
import simbad.gap.fixture.Worlds;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** Ladders and drives: what was put in place, and how far its readings hang together. */
class PlacementsTest {
  private static Placements of(List<ReadingRow> rows) {
    return new Placements(new PingLog(rows));
  }

  private static double clumping(List<ReadingRow> rows) {
    CalibratedLog given = new CalibratedLog(Ladders.BOARD, List.of(), new PingLog(rows));
    return PlacementScatter.clumping(given, of(rows));
  }

  private static double[] sixty() {
    return IntStream.range(0, 60).mapToDouble(i -> 0.2 + 0.04 * i).toArray();
  }

  @Test
  void ladder_isRepeated_driveIsNot() {
    Placements ladder = of(Ladders.read((range, lot) -> range, 1));
    assertEquals(10, ladder.count());
    assertTrue(ladder.areRepeated());
    assertFalse(of(Worlds.poses(200, 0.3, 1.3, 1)).areRepeated());
    double[] three = {0.5, 1, 1.5};
    assertFalse(of(Ladders.read((range, lot) -> range, three, 30, 0, 1)).areRepeated());
  }

  /** Numbers and blocks are those of the places, whenever each row was read. */
  @Test
  void blocks_areOfPlaces_whateverTheOrder() {
    List<ReadingRow> rows = Ladders.read((range, lot) -> range, 1);
    for (List<ReadingRow> some : List.of(rows, Ladders.dealtAnew(rows, 5))) {
      PingLog log = new PingLog(some);
      Blocks blocks = new Blocks(log);
      assertEquals(10, blocks.count());
      for (int ping = 0; ping < log.size(); ping++) {
        int nearer = 0;
        for (double other : new double[] {0.1, 0.2, 0.35, 0.5, 0.75, 1, 1.4, 1.9, 2.4, 2.8}) {
          nearer += other < log.zM(ping) - 1e-9 ? 1 : 0;
        }
        assertEquals(nearer, blocks.of(ping));
      }
    }
  }

  /** Sixteen readings with 3 mm of noise, placed with 2 mm: 1 + 15 * 4 / 13, of chance a fifth. */
  @Test
  void designEffect_isThatOfTheVariances() {
    assertEquals(5.6, clumping(Ladders.read((range, lot) -> range, sixty(), 16, 0.002, 3)), 1.4);
    assertEquals(1, clumping(Ladders.read((range, lot) -> range, sixty(), 16, 0, 3)), 0.5);
    double far = clumping(Ladders.read((range, lot) -> range, sixty(), 16, 0.03, 3));
    assertTrue(far > 14 && far <= 16, "" + far);
  }

  /** Where placements lie on a line by chance, what the set-up says of its places counts. */
  @Test
  void designEffect_isAtLeastThatOfTheStatedPlaces() {
    SensingSetup stated = Ladders.board(0, 0.002, 0);
    PingLog log = new PingLog(Ladders.read((range, lot) -> range, sixty(), 16, 0, 3));
    CalibratedLog given = new CalibratedLog(stated, List.of(), log);
    Placements placements = new Placements(log);
    assertEquals(1, PlacementScatter.clumping(given, placements), 0.5);
    assertEquals(5.6, PlacementScatter.statedClumping(given, placements), 0.6);
  }

  /**
   * Straight before a wide board a turn changes no range. Where the board's normal is 30 degrees
   * outside the cone, the range d / cos 30 changes by 2/3 d for each radian: for half a degree at d
   * of 0.52 m by 3 mm, as much as the noise, so the effect is 1 + 15 / 2.
   */
  @Test
  void designEffect_isAtLeastThatOfTheStatedHeadings() {
    double[] near = IntStream.range(0, 60).mapToDouble(i -> 0.1 + 0.0125 * i).toArray();
    List<ReadingRow> straight = Ladders.read((range, lot) -> range, near, 16, 0, 3);
    List<ReadingRow> aside = straight.stream().map(PlacementsTest::turned).toList();
    assertEquals(1, statedHeadings(straight), 0.7);
    assertEquals(8.5, statedHeadings(aside), 1);
  }

  private static ReadingRow turned(ReadingRow row) {
    double distance = row.pose().position().zM();
    double noise = ((Echo) row.reading()).rangeM() - distance;
    double headingRad = Math.PI / 2 + Ladders.BOARD.sensor().coneHalfAngleRad() + Math.PI / 6;
    return new ReadingRow(
        row.run(),
        row.sensor(),
        row.timeS(),
        Pose.of(0, distance, headingRad),
        new Echo(distance / Math.cos(Math.PI / 6) + noise));
  }

  private static double statedHeadings(List<ReadingRow> rows) {
    SensingSetup stated = Ladders.board(0, 0, Math.toRadians(0.5));
    PingLog log = new PingLog(rows);
    return PlacementScatter.statedClumping(
        new CalibratedLog(stated, List.of(), log), new Placements(log));
  }

  /** A wrong factor is no error of placements, nor are readings from elsewhere. */
  @Test
  void designEffect_isNotOfTheLaw_norOfStrays() {
    assertEquals(
        5.6, clumping(Ladders.read((range, lot) -> 0.394 * range, sixty(), 16, 0.0051, 3)), 1.6);
    assertEquals(
        5.6,
        clumping(Ladders.read((range, lot) -> lot < 0.1 ? 40 * lot : range, sixty(), 16, 0.002, 3)),
        1.6);
  }
}
