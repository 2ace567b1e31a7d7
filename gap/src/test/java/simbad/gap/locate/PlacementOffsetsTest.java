package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.gap.fixture.Ladders;
import simbad.gap.fixture.Logs;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** A board before a sensor that was put at some distances and read there repeatedly. */
class PlacementOffsetsTest {
  /** Between 10 and 30 of them, as people take ladders. */
  private static double[] distances(int count) {
    return IntStream.range(0, count).mapToDouble(i -> 0.1 + 2.8 * i / count).toArray();
  }

  /** The reading less the distance: what a right model leaves. */
  private static List<PlacementOffset> offsets(List<ReadingRow> rows) {
    PingLog log = new PingLog(rows);
    List<OptionalDouble> off =
        IntStream.range(0, log.size())
            .mapToObj(i -> OptionalDouble.of(log.rangeM(i) - log.zM(i)))
            .toList();
    return PlacementOffsets.of(Ladders.BOARD, log, off, off);
  }

  private static List<ReadingRow> ladder(int places, double thirdOffM, long seed) {
    double third = distances(places)[2];
    return Ladders.read((range, lot) -> range, distances(places), 10, Ladders.TAPE_M, seed).stream()
        .map(row -> row.pose().position().zM() == third ? moved(row, thirdOffM) : row)
        .toList();
  }

  private static ReadingRow moved(ReadingRow row, double byM) {
    double range = ((Echo) row.reading()).rangeM() + byM;
    return new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), new Echo(range));
  }

  @Test
  void misreadTape_isOffAlone() {
    for (double off : new double[] {0.04, -0.04}) {
      List<PlacementOffset> found = offsets(ladder(10, off, 3));
      assertEquals(10, found.size());
      assertEquals(
          List.of(2), IntStream.range(0, 10).filter(i -> found.get(i).isOff()).boxed().toList());
      PlacementOffset third = found.get(2);
      assertEquals(10, third.rows());
      assertEquals(off, third.afterM(), 3 * Ladders.TAPE_M);
      assertTrue(third.after95().low() < third.afterM() && third.afterM() < third.after95().high());
    }
  }

  /** A stretch that reads too long is no tape that was misread twice; two sides are. */
  @Test
  void neighboursToTheSameSide_areNotOffAlone() {
    double fourth = distances(12)[3];
    for (double off : new double[] {0.04, -0.04}) {
      List<PlacementOffset> found =
          offsets(
              ladder(12, 0.05, 4).stream()
                  .map(row -> row.pose().position().zM() == fourth ? moved(row, off) : row)
                  .toList());
      assertEquals(
          off > 0 ? List.of() : List.of(2, 3),
          IntStream.range(0, 12).filter(i -> found.get(i).isOff()).boxed().toList());
    }
  }

  /** 400 ladders without one that is off: at most 4 say so (expected: less than 2). */
  @Test
  void tapeOfTwoMillimetres_putsNoneOff() {
    long alarms =
        IntStream.range(0, 400)
            .filter(
                seed ->
                    offsets(ladder(10 + seed % 21, 0, seed)).stream()
                        .anyMatch(PlacementOffset::isOff))
            .count();
    assertTrue(alarms <= 4, alarms + " of 400");
  }

  /** Of five nobody knows which one is wrong; of two readings both may be of something else. */
  @Test
  void fewPlacements_orFewReadings_putNoneOff() {
    assertTrue(offsets(ladder(5, 0.04, 1)).stream().noneMatch(PlacementOffset::isOff));
    List<ReadingRow> few =
        Ladders.read((range, lot) -> range, distances(10), 2, Ladders.TAPE_M, 1).stream()
            .map(row -> row.pose().position().zM() == distances(10)[2] ? moved(row, 0.04) : row)
            .toList();
    assertTrue(offsets(few).stream().noneMatch(PlacementOffset::isOff));
  }

  @Test
  void driveHasNoPlacements() {
    PingLog log = new PingLog(Logs.drive(100, 1));
    List<OptionalDouble> none = Collections.nCopies(log.size(), OptionalDouble.empty());
    assertEquals(List.of(), PlacementOffsets.of(Logs.ROOM, log, none, none));
  }
}
