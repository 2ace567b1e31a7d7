package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.DoubleFunction;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;

/**
 * Slices of drives that are seen exactly, eight times a second: of a forecast without scatter the
 * score of a window is by how much it is off. All numbers are sums of powers of two.
 */
class MotionPlacesTest {
  private static final double EXACT = 1e-9;
  private static final Command SLOW = new Command(0, 0.125, 0);

  private static TrackPose straight(double timeS, double wayM) {
    return new TrackPose(timeS, wayM, 0, 0);
  }

  private static MotionRun run(
      String name, List<Command> commands, double seconds, DoubleFunction<TrackPose> seen) {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= 8 * seconds; i++) {
      track.add(seen.apply(i / 8.0));
    }
    return new MotionRun(name, commands, track);
  }

  private static MotionRun run(double seconds, DoubleUnaryOperator wayM) {
    return run("a", List.of(SLOW), seconds, t -> straight(t, wayM.applyAsDouble(t)));
  }

  /** Of a model that goes so many times as fast as what is believed. */
  private static List<MotionPlace> places(double times, MotionRun... runs) {
    MotionForecast nominal = MotionForecast.believed(Robot.EXACT_UNICYCLE);
    MotionChain chain =
        MotionChain.EXACT.with(MotionForms.find("speed-scale").orElseThrow().change(times));
    List<MotionChain> folds = Collections.nCopies(MotionSteps.FOLDS, chain);
    List<MotionRun> all = List.of(runs);
    return MotionPlaces.of(all, MotionGap.of(all, nominal, folds));
  }

  private static List<MotionPlace> along(String axis, List<MotionPlace> places) {
    return places.stream()
        .filter(place -> place.axis().equals(axis))
        .sorted((a, b) -> Double.compare(a.low(), b.low()))
        .toList();
  }

  private static void assertPlace(
      MotionPlace place, double low, double high, int rows, double share, double before) {
    assertEquals(low, place.low(), 0);
    assertEquals(high, place.high(), 0);
    assertEquals(rows, place.rows());
    assertEquals(share, place.share(), EXACT);
    assertEquals(before, place.before(), EXACT);
  }

  /** 60 windows are off by 1/16 m, 40 by 3/16: by 180/16 m together, and only along. */
  @Test
  void timeIsCutIntoQuarters() {
    List<MotionPlace> places = places(1, run(50, t -> 0.25 * t + Math.max(0, t - 30) / 4));
    List<MotionPlace> time = along("t_s", places);
    double unit = 100 / 180.0 / 3;

    assertEquals(4, time.size());
    assertPlace(time.get(0), 0, 12, 24, 24 / 180.0, unit);
    assertPlace(time.get(1), 12, 24.5, 25, 25 / 180.0, unit);
    assertPlace(time.get(2), 24.5, 37, 25, 53 / 180.0, 53 / 25.0 * unit);
    assertPlace(time.get(3), 37, 49.5, 26, 78 / 180.0, 3 * unit);
    for (int i = 1; i < places.size(); i++) {
      assertTrue(places.get(i).share() <= places.get(i - 1).share());
    }
    assertEquals(1, places.get(0).share(), EXACT);
    assertEquals(List.of(), along("run", places));
  }

  /** What is equal is not cut: a quarter that is all 1/4 m/s goes into the next. */
  @Test
  void equalValuesStayTogether() {
    List<MotionPlace> places = places(1, run(50, t -> 0.25 * t + Math.max(0, t - 30) / 4));
    List<MotionPlace> speed = along("speed_m_s", places);

    assertEquals(2, speed.size());
    assertPlace(speed.get(0), 0.25, 0.5, 60, 1 / 3.0, 100 / 180.0 / 3);
    assertPlace(speed.get(1), 0.5, 0.5, 40, 2 / 3.0, 100 / 60.0 / 3);
    assertEquals(1, along("turn_rad_s", places).size());
    assertEquals(100, along("turn_rad_s", places).get(0).rows());
  }

  /** Twice as fast is right, but for one pose that is half a metre on. */
  @Test
  void whatIsLeftIsSaidBesideWhatWas() {
    List<MotionPlace> places = places(2, run(50, t -> 0.25 * t + (t == 20 ? 0.5 : 0)));
    List<MotionPlace> time = along("t_s", places);
    // 98 windows are off by 1/16 m, two by half a metre more and less.
    double mean = (98 / 16.0 + 1) / 100;

    assertEquals(0, time.get(0).after(), EXACT);
    assertEquals(1 / 16.0 / mean / 3, time.get(0).before(), EXACT);
    assertEquals((23 / 16.0 + 1) / 25 / mean / 3, time.get(1).before(), EXACT);
    assertEquals(1 / 25.0 / mean / 3, time.get(1).after(), EXACT);
    assertEquals(0, time.get(3).after(), EXACT);
  }

  /**
   * Told to stand: for a quarter it goes ahead, then to its left, then it turns, then it stands.
   */
  private static TrackPose pushed(double t) {
    double x = Math.min(12, t) / 8;
    double y = Math.max(0, Math.min(12.5, t - 12)) / 8;
    return new TrackPose(t, x, y, Math.max(0, Math.min(12.5, t - 24.5)) / 16);
  }

  @Test
  void theComponentIsWhereMostIsOff() {
    List<MotionPlace> time =
        along("t_s", places(1, run("a", List.of(Command.STAND), 50, MotionPlacesTest::pushed)));

    assertEquals(
        List.of("along", "across", "turn", "along"),
        time.stream().map(MotionPlace::component).toList());
    // Each component is a third of all.
    assertPlace(time.get(0), 0, 12, 24, 1 / 3.0, 100 / 3.0 / 24);
    assertPlace(time.get(1), 12, 24.5, 25, 1 / 3.0, 100 / 3.0 / 25);
    assertPlace(time.get(2), 24.5, 37, 25, 1 / 3.0, 100 / 3.0 / 25);
    assertPlace(time.get(3), 37, 49.5, 26, 0, 0);
  }

  @Test
  void runsArePlacesToo() {
    MotionRun right = run("right", List.of(SLOW), 25, t -> straight(t, t / 8));
    MotionRun fast = run("fast", List.of(SLOW), 25, t -> straight(t, t / 2));
    List<MotionPlace> runs =
        places(1, right, fast).stream().filter(p -> p.axis().equals("run")).toList();

    assertEquals(List.of("fast", "right"), runs.stream().map(MotionPlace::name).toList());
    assertPlace(runs.get(0), 0, 0, 50, 1, 2 / 3.0);
    assertPlace(runs.get(1), 0, 0, 50, 0, 0);
  }

  /** Each ten seconds it is told to go an eighth faster, and goes twice as fast as that. */
  private static MotionRun rising() {
    List<Command> commands = new ArrayList<>();
    for (int block = 0; block < 5; block++) {
      commands.add(new Command(10 * block, (block + 1) / 8.0, 0));
    }
    return run(
        "a",
        commands,
        50,
        t -> {
          double way = 0;
          for (int block = 0; block < 5; block++) {
            way += (block + 1) / 4.0 * Math.max(0, Math.min(10, t - 10 * block));
          }
          return straight(t, way);
        });
  }

  private static double chance(double mean, double squares) {
    return 1 - NormalChance.below(mean / Math.sqrt(squares / 4 / 5));
  }

  /**
   * Five blocks of excesses as 1 to 5 have mean 3 and squares 10. Of 20 places one is surer, six
   * are as sure as that and one is less; the others have too few blocks.
   */
  @Test
  void chanceIsToldFromBlocks_andFromHowManyPlacesThereAre() {
    List<MotionPlace> places = places(2, rising());
    double q = chance(3, 10) * 20 / 7;

    assertEquals(20, places.size());
    for (String axis : List.of("turn_rad_s", "speed_change_m_s", "heading_deg", "z_m")) {
      assertEquals(1, along(axis, places).size(), axis);
      assertEquals(q, along(axis, places).get(0).qValue(), 1e-10);
    }
    List<MotionPlace> since = along("since_change_s", places);
    assertEquals(List.of(24, 25, 25, 26), since.stream().map(MotionPlace::rows).toList());
    assertEquals(q, since.get(1).qValue(), 1e-10);
    assertEquals(chance(16, 370) * 20 / 8, since.get(3).qValue(), 1e-10);
    for (String axis : List.of("t_s", "x_m", "speed_m_s")) {
      assertTrue(along(axis, places).stream().allMatch(place -> place.qValue() == 1), axis);
    }
  }

  /** Five windows are a place where nothing is cut; four are none. */
  @Test
  void fewWindowsAreNoPlace() {
    List<MotionPlace> five = places(1, run(2.5, t -> t / 4));

    assertEquals(
        List.of("heading_deg", "speed_change_m_s", "speed_m_s", "turn_rad_s", "z_m"),
        five.stream().map(MotionPlace::axis).sorted().toList());
    assertTrue(five.stream().allMatch(place -> place.rows() == 5 && place.qValue() == 1));
    assertEquals(List.of(), places(1, run(2, t -> t / 4)));
  }

  @Test
  void withoutAGapThereIsNoPlace() {
    assertEquals(List.of(), places(1, run("a", List.of(Command.STAND), 50, t -> straight(t, 1))));
  }
}
