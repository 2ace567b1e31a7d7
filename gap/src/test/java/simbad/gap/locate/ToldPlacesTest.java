package simbad.gap.locate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapMeter;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/**
 * Gaps by hand of a sensor that stands before nothing for two minutes and reads ten times a second:
 * blocks of ten seconds, of which the first, third and so on find and the others confirm. Time is
 * cut into steps of five seconds.
 */
class ToldPlacesTest {
  private static final int PINGS = 1200;
  private static final double EXPECTED = 0.1;
  private static final CalibratedLog GIVEN = given();

  private static CalibratedLog given() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < PINGS; i++) {
      rows.add(new ReadingRow("r", "s", 0.1 * i, Pose.of(0, 1, 0), new Echo(1)));
    }
    SensingSetup nothing = new SensingSetup(Worlds.POST.sensor(), new Scene(List.of()), 4);
    return new CalibratedLog(nothing, List.of(), new PingLog(rows));
  }

  /** So much of the gap at a time, in seconds from the start, beyond what is expected. */
  private static GapMeter.Gaps gaps(DoubleUnaryOperator beyond, double expected) {
    double[] observed = new double[PINGS];
    Arrays.setAll(observed, i -> expected + beyond.applyAsDouble(GIVEN.log().timeS(i)));
    double[] own = new double[PINGS];
    Arrays.fill(own, expected);
    return new GapMeter.Gaps(observed, own);
  }

  private static List<Place> places(GapMeter.Gaps before, GapMeter.Gaps after) {
    return Places.find(GIVEN, before, after, new Blocks(GIVEN.log())).thatStandOut();
  }

  private static List<Place> places(DoubleUnaryOperator beyond) {
    return places(gaps(beyond, EXPECTED), gaps(beyond, EXPECTED));
  }

  private static boolean isIn(double t, double from, double to) {
    return t >= from - 1e-6 && t < to - 1e-6;
  }

  private static List<Interval> times(List<Place> places) {
    return places.stream()
        .flatMap(place -> place.conditions().stream())
        .filter(condition -> condition.variable().equals("t_s"))
        .map(condition -> condition.interval().orElseThrow())
        .toList();
  }

  /**
   * From 30 s to 50 s a metre too much: of the confirming half 100 rows from 30 s to 40 s, with 110
   * of 160 metres of its gap.
   */
  @Test
  void place_isSaidInFiguresOfTheConfirmingHalf() {
    List<Place> places =
        places(
            gaps(t -> isIn(t, 30, 50) ? 1 : 0, EXPECTED),
            gaps(t -> isIn(t, 30, 50) ? 0.3 : 0, EXPECTED));
    assertEquals(1, places.size());
    assertEquals(List.of(new Interval(30, 50)), times(places));
    Place place = places.get(0);
    assertEquals(100, place.rows());
    assertEquals(110 / 160.0, place.shareOfGap(), 1e-9);
    assertEquals(110, place.beforeCm(), 1e-9);
    assertEquals(40, place.afterCm(), 1e-9);
    assertTrue(place.qValue() < 1e-9, place::toString);
  }

  /** What is found in one half and not seen in the other is by chance. */
  @Test
  void whatTheOtherHalfDoesNotConfirm_isNoPlace() {
    assertEquals(List.of(), places(t -> isIn(t, 40, 50) ? 1 : 0));
    assertEquals(List.of(), places(t -> isIn(t, 40, 50) ? 1 : isIn(t, 30, 40) ? -1 : 0));
    assertEquals(List.of(), places(t -> isIn(t, 30, 40) ? 1 : 0), "nor what was not found");
  }

  @Test
  void largerShare_comesFirst() {
    List<Place> places =
        places(t -> isIn(t, 10, 30) ? 0.4 : isIn(t, 70, 90) ? 1 : isIn(t, 40, 50) ? -1 : 0);
    assertEquals(List.of(new Interval(70, 90), new Interval(10, 30)), times(places));
    assertEquals(110 / (400 * 0.1 + 110 + 50), places.get(0).shareOfGap(), 1e-9);
  }

  /** However sure it is, an excess of less than a twentieth of what is expected says little. */
  @Test
  void smallExcess_isNotWorthAReadersTime() {
    GapMeter.Gaps less = gaps(t -> isIn(t, 30, 50) ? 0.0049 : 0, EXPECTED);
    assertEquals(List.of(), places(less, less));
    GapMeter.Gaps small = gaps(t -> isIn(t, 30, 50) ? 0.011 : 0, EXPECTED);
    assertEquals(
        List.of(),
        places(small, small),
        "100 * 0.011 m are less than a fiftieth of 60 m and 1.1 m");
    GapMeter.Gaps more = gaps(t -> isIn(t, 30, 50) ? 0.014 : 0, EXPECTED);
    assertEquals(List.of(new Interval(30, 50)), times(places(more, more)));
  }

  /**
   * Between two finding blocks of 1 m each lie one or two of 9 m, which are told first. Of the
   * stretch over all half are covered then, and it is none; or a third, and it is one.
   */
  @Test
  void stretchThatIsMostlyCovered_isNoPlace() {
    List<Interval> two =
        times(places(t -> isIn(t, 40, 80) ? 9 : isIn(t, 20, 40) || isIn(t, 80, 100) ? 1 : 0));
    assertTrue(two.stream().anyMatch(t -> holds(t, 45) && holds(t, 65)), two::toString);
    assertTrue(two.stream().noneMatch(t -> holds(t, 25) && holds(t, 85)), two::toString);
    List<Interval> one =
        times(places(t -> isIn(t, 40, 60) ? 9 : isIn(t, 20, 40) || isIn(t, 60, 80) ? 1 : 0));
    assertTrue(one.stream().anyMatch(t -> holds(t, 25) && holds(t, 65)), one::toString);
  }

  private static boolean holds(Interval times, double t) {
    return times.low() <= t && t < times.high();
  }
}
