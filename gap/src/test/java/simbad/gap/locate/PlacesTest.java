package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.gap.diagnosis.GapKind;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapMeter;
import simbad.gap.slice.Axis;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;

class PlacesTest {
  private static final Placing POST = new Placing();

  private static List<ReadingRow> nominal(long seed) {
    return Worlds.read(Worlds.poses(1500, 0.3, 2.2, seed), Hypothesis.NONE, seed + 1);
  }

  private static List<Place> places(List<ReadingRow> rows, Hypothesis diagnosed) {
    CalibratedLog given = Worlds.given(rows);
    GapMeter meter = new GapMeter(given);
    return Places.find(
            given,
            meter.measure(given, Hypothesis.NONE),
            meter.measure(given, diagnosed),
            new Blocks(given.log()))
        .thatStandOut();
  }

  private static List<ReadingRow> planted(
      List<ReadingRow> rows, Predicate<ReadingRow> where, Reading reading) {
    List<ReadingRow> changed = new ArrayList<>();
    for (ReadingRow row : rows) {
      changed.add(
          where.test(row)
              ? new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading)
              : row);
    }
    return changed;
  }

  /** Rows in both over rows in either. */
  private static double overlap(
      List<ReadingRow> rows, Predicate<ReadingRow> one, Predicate<ReadingRow> other) {
    long both = rows.stream().filter(one.and(other)).count();
    return (double) both / rows.stream().filter(one.or(other)).count();
  }

  /** What a reader of the diagnosis computes of a row of this scene. */
  private static final class Placing {
    double bearingDeg(ReadingRow row) {
      double deg =
          Math.toDegrees(Math.atan2(row.pose().position().xM(), row.pose().position().zM()));
      return deg < 0 ? deg + 360 : deg;
    }

    double distanceM(ReadingRow row) {
      return Math.hypot(row.pose().position().xM(), row.pose().position().zM());
    }

    Predicate<ReadingRow> in(Place place) {
      Map<String, Interval> by =
          place.conditions().stream()
              .filter(condition -> condition.interval().isPresent())
              .collect(
                  Collectors.toMap(
                      Place.Condition::variable, condition -> condition.interval().orElseThrow()));
      return row ->
          holds(by.get("bearing_deg"), bearingDeg(row))
              && holds(by.get("distance_m"), distanceM(row))
              && holds(by.get("t_s"), row.timeS());
    }

    private static boolean holds(
        @org.jspecify.annotations.Nullable Interval interval, double value) {
      return interval == null || (value >= interval.low() && value < interval.high());
    }
  }

  @Test
  void region_whereEchoesAreMissed_isFound() {
    Predicate<ReadingRow> region =
        row ->
            POST.bearingDeg(row) >= 60
                && POST.bearingDeg(row) < 130
                && POST.distanceM(row) >= 0.5
                && POST.distanceM(row) < 1.1;
    List<ReadingRow> rows = planted(nominal(1), region, NoEcho.NO_ECHO);
    List<Place> places = places(rows, Hypothesis.NONE);
    Place first = places.get(0);
    assertTrue(overlap(rows, region, POST.in(first)) > 0.7, places::toString);
    assertEquals(GapKind.MISSED_ECHO, first.kind());
    assertTrue(first.qValue() < 1e-4, first::toString);
    assertTrue(first.shareOfGap() > 0.5 && first.shareOfGap() <= 1, first::toString);
  }

  @Test
  void time_inWhichSomethingElseAnswers_isFound() {
    Predicate<ReadingRow> region =
        row -> row.timeS() >= 15 && row.timeS() < 60 && POST.distanceM(row) > 1.7;
    List<ReadingRow> rows = planted(nominal(3), region, new Echo(0.8));
    Place first = places(rows, Hypothesis.NONE).get(0);
    assertTrue(overlap(rows, region, POST.in(first)) > 0.7, first::toString);
    assertEquals(GapKind.PHANTOM_ECHO, first.kind());
  }

  @Test
  void rangesThatAreOff_areARangeError_andTheEffectHealsThem() {
    Hypothesis offset = Worlds.effect(Effect.RANGE_OFFSET, "constant", 0.1);
    List<ReadingRow> rows = Worlds.read(Worlds.poses(1500, 0.3, 2.2, 5), offset, 6);
    Place first = places(rows, offset).get(0);
    Predicate<ReadingRow> audible = row -> POST.distanceM(row) < 1.5;
    assertTrue(overlap(rows, audible, POST.in(first)) > 0.7, first::toString);
    assertEquals(GapKind.RANGE_ERROR, first.kind());
    assertTrue(first.afterCm() < 0.5 * first.beforeCm(), first::toString);
  }

  /** What is off by as much everywhere has no place, and all rows are none. */
  @Test
  void gapThatIsTheSameEverywhere_hasNoPlace() {
    List<ReadingRow> off = new ArrayList<>();
    for (ReadingRow row : nominal(7)) {
      if (row.reading() instanceof Echo echo && POST.distanceM(row) < 1.2) {
        Reading longer = new Echo(echo.rangeM() + 0.1);
        off.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), longer));
      }
    }
    assertTrue(off.size() > 300, () -> "" + off.size());
    assertEquals(List.of(), places(off, Hypothesis.NONE));
    CalibratedLog given = Worlds.given(off);
    GapMeter.Gaps gaps = new GapMeter(given).measure(given, Hypothesis.NONE);
    Place all = Places.find(given, gaps, gaps, new Blocks(given.log())).anywhere().get(0);
    assertTrue(all.shareOfGap() > 0.8 && all.qValue() < 1e-4, "but it is no chance: " + all);
    // Half of them are right: then the others are a place.
    List<ReadingRow> half = new ArrayList<>();
    for (ReadingRow row : off) {
      Reading before = new Echo(((Echo) row.reading()).rangeM() - 0.1);
      Reading reading = POST.bearingDeg(row) < 180 ? row.reading() : before;
      half.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading));
    }
    Place first = places(half, Hypothesis.NONE).get(0);
    assertTrue(overlap(half, row -> POST.bearingDeg(row) < 180, POST.in(first)) > 0.9);
  }

  /** Where all but a twentieth of the rows are off, all of them are. */
  @Test
  void gapOfNearlyAllRows_hasNoPlace() {
    List<ReadingRow> nearly = new ArrayList<>();
    for (ReadingRow row : nominal(7)) {
      if (row.reading() instanceof Echo echo && POST.distanceM(row) < 1.2) {
        double off = POST.bearingDeg(row) < 18 ? 0 : 0.1;
        Reading reading = new Echo(echo.rangeM() + off);
        nearly.add(new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading));
      }
    }
    assertEquals(List.of(), places(nearly, Hypothesis.NONE));
  }

  /** A post at the origin and another 3 m to the right. */
  private static SensingSetup twoPosts() {
    Obstacle near = Worlds.POST.scene().obstacles().get(0);
    Obstacle far = new Obstacle("far", new Placement(3, 0, 0), near.outline(), near.detection());
    return new SensingSetup(
        Worlds.POST.sensor(), new Scene(List.of(near, far)), Worlds.POST.noEchoM());
  }

  /** Distances and angles are to the obstacle that the ping belongs to. */
  @Test
  void distance_isToTheObstacleInTheCone() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 10; i++) {
      Pose pose =
          Pose.of(i % 2 == 0 ? 0.5 + 0.05 * i : 2.2 + 0.05 * i, 0, i % 2 == 0 ? Math.PI : 0);
      rows.add(new ReadingRow("r", "s", 0.1 * i, pose, NoEcho.NO_ECHO));
    }
    CalibratedLog given = new CalibratedLog(twoPosts(), List.of(), new PingLog(rows));
    Axis distance =
        Cuts.of(given.geometry(given.model(Hypothesis.NONE))).stream()
            .map(cut -> cut.axes().get(0))
            .filter(axis -> axis.condition(0, 1).variable().equals("distance_m"))
            .findFirst()
            .orElseThrow();
    for (int i = 0; i < 10; i++) {
      double metres = i % 2 == 0 ? 0.5 + 0.05 * i : 0.8 - 0.05 * i;
      int bin = distance.bin(i);
      Interval range = distance.condition(bin, bin + 1).interval().orElseThrow();
      assertTrue(range.low() <= metres + 1e-9 && metres - 1e-9 <= range.high(), i + ": " + range);
    }
  }

  /** Of two posts 3 m apart only one is deaf: the place names it. */
  @Test
  void obstacle_thatIsNotHeard_isNamed() {
    SensingSetup two = twoPosts();
    List<ReadingRow> poses = new ArrayList<>(Worlds.poses(900, 0.3, 1.4, 31));
    for (ReadingRow row : Worlds.poses(900, 0.3, 1.4, 33)) {
      Pose pose = row.pose();
      Pose there =
          Pose.of(pose.position().xM() + 3, pose.position().zM(), pose.heading().radians());
      poses.add(new ReadingRow("r", "s", 45 + row.timeS(), there, row.reading()));
    }
    List<ReadingRow> rows =
        planted(
            Worlds.read(two, poses, Hypothesis.NONE, 35),
            row -> row.pose().position().xM() > 1.5 && row.timeS() % 0.2 < 0.1,
            NoEcho.NO_ECHO);
    CalibratedLog given = new CalibratedLog(two, List.of(), new PingLog(rows));
    GapMeter meter = new GapMeter(given);
    GapMeter.Gaps gap = meter.measure(given, Hypothesis.NONE);
    List<Place> places = Places.find(given, gap, gap, new Blocks(given.log())).thatStandOut();
    assertTrue(
        places.stream()
            .flatMap(place -> place.conditions().stream())
            .anyMatch(condition -> condition.name().filter("far"::equals).isPresent()),
        places::toString);
  }

  @ParameterizedTest
  @ValueSource(longs = {11, 13, 15, 17, 19, 21, 23, 25})
  void nominalReadings_haveNoPlace(long seed) {
    assertEquals(List.of(), places(nominal(seed), Hypothesis.NONE));
  }

  @Test
  void noReadings_haveNoPlace() {
    assertEquals(List.of(), places(List.of(), Hypothesis.NONE));
  }

  @Test
  void oneReading_hasNoPlace() {
    assertEquals(List.of(), places(nominal(1).subList(0, 1), Hypothesis.NONE));
  }
}
