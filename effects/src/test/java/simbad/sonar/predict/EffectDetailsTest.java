package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.change.HeadingDrift;
import simbad.sonar.change.HeadingDriftByWay;
import simbad.sonar.change.Latency;
import simbad.sonar.change.MixedMultipath;
import simbad.sonar.change.Multipath;
import simbad.sonar.change.NearerByPrevious;
import simbad.sonar.change.OdometryScale;
import simbad.sonar.change.PathScale;
import simbad.sonar.change.PingDelay;
import simbad.sonar.change.SoundSpeed;
import simbad.sonar.change.UnmodelledObject;
import simbad.sonar.change.WalkingCrosstalk;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.Moment;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** What no reading of one ping before one box shows: found by changing the program (PIT). */
class EffectDetailsTest {
  private static SensingSetup setup(double stepM, Scene scene) {
    return new SensingSetup(Sonars.noisy(stepM, 0.02, 0.1, 0.1), scene, 6.5);
  }

  private static final SensingSetup EMPTY = setup(0.05, Scenes.of());
  private static final SensingSetup BOX = setup(0.05, Scenes.of(Scenes.box(1, 0, 1.2)));

  /** In binary 0.3 / 0.1 is a little less than 3, and 0.6 / 0.2 too. */
  @ParameterizedTest
  @ValueSource(doubles = {0.1, 0.2, 0.05, 0.01})
  void wholeSteps_areReportedAsTheyAre(double stepM) {
    ChangedModel model = new ChangedModel(setup(stepM, Scenes.of()), List.of());
    for (int steps = 0; steps < 60; steps++) {
      assertEquals(steps * stepM, model.reportedM(steps * stepM), 1e-9);
      assertEquals(steps * stepM, model.reportedM((steps + 0.5) * stepM), 1e-9);
    }
  }

  /** The foot of the perpendicular lies ahead and to the side, or a corner does. */
  @Test
  void angleToTheNearestPoint_isThatOfTheFootOrTheCorner() {
    double heading = Math.toRadians(10);
    assertEquals(heading, nearestOffAxis(Pose.of(0, 0.05, heading)), 1e-9);
    assertEquals(heading, nearestOffAxis(Pose.of(0, -0.05, -heading)), 1e-9);
    double across = Math.toRadians(90);
    assertEquals(heading, nearestOffAxis(Pose.of(1.04, 0.5, across - heading)), 1e-9);
    assertEquals(heading, nearestOffAxis(Pose.of(0.94, -0.5, -across + heading)), 1e-9);
    // From beside, the corner at (0.875, 0.125): 0.375 m across and 0.875 m ahead.
    assertEquals(Math.atan2(0.375, 0.875), nearestOffAxis(Pose.of(0, 0.5, 0)), 1e-9);
    // It has left the cone of 27.5 degrees: what is nearest of the rest lies on the cone's edge.
    assertEquals(Math.toRadians(27.5), nearestOffAxis(Pose.of(0, 0.6, -0.1)), 1e-9);
  }

  private static double nearestOffAxis(Pose pose) {
    PingLog log = new PingLog(List.of(Logs.row(0, pose, Logs.SILENCE)));
    return Math.abs(new ChangedModel(BOX, List.of()).geometry(log).echoOffAxisRad(0));
  }

  /** From 0.625 m by 0.15 m a ping; at 1.125 m, 0.6 m from where it began, round again. */
  @Test
  void walkingCrosstalk_walksRound() {
    Change walk = new WalkingCrosstalk(1, 0.525, 0.6, 0.15, 0.625, 0.015);
    double[] expected = {0.6, 0.75, 0.9, 1.05, 0.6, 0.75};
    List<ReadingRow> rows =
        IntStream.range(0, expected.length)
            .mapToObj(i -> Logs.row(i, Pose.of(0, 0, 0), OptionalDouble.of(expected[i])))
            .toList();
    for (double probability : Logs.likelihood(EMPTY, rows, List.of(walk))) {
      // 0.015 and the sensor's 0.02 make 0.025: the step's ends are 1 deviation away.
      assertEquals(0.6826895, probability, 1e-6);
    }
  }

  /** The root of the squares of half of 3 cm, half of 2 cm, and 1 cm. */
  @Test
  void spreadOfAReflectionOfThePingBefore_addsInSquares() {
    Mixture mixture = new Mixture();
    mixture.add(1, 0.03, 0.8);
    Mixture before = new Mixture();
    before.add(0.6, 0.02, 1);
    PingLog log = new PingLog(List.of(Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE)));
    Moment moment = new Moment(new ChangedModel(EMPTY, List.of()).geometry(log));
    moment.set(0, before);
    new NearerByPrevious(0.25, 0.5, 0.5, 0.1, 0.01).apply(moment, mixture);
    assertEquals(2, mixture.size());
    assertEquals(0.5 + 0.3 - 0.1, mixture.meanM(1), 1e-12);
    assertEquals(
        Math.sqrt(0.015 * 0.015 + 0.01 * 0.01 + 0.01 * 0.01), mixture.deviationM(1), 1e-12);
    assertEquals(0.2, mixture.share(1), 1e-12);
    assertEquals(0.6, mixture.share(0), 1e-12);
  }

  /** The way is longer, and all of it is taken for twice as long: (0.875 + 0.1) 2, not 1.85. */
  @Test
  void longWays_areMeasuredWithTheSpeedOfSound() {
    Multipath added = new Multipath(1, 1, 0.1, 0);
    Multipath none = new Multipath(0, 1.5, 0, 0);
    List<ReadingRow> ping = List.of(Logs.row(0, Pose.of(0, 0, 0), OptionalDouble.of(1.95)));
    for (Change longer : List.of(added, new MixedMultipath(added, none))) {
      double read = Logs.likelihood(BOX, ping, List.of(new SoundSpeed(2), longer))[0];
      // 1.95 m begins the step of which half of the readings, 1.95 m in the mean, lie.
      assertEquals(0.5, read / echoes(longer), 0.01, longer.toString());
    }
  }

  private static double echoes(Change change) {
    List<ReadingRow> ping = List.of(Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE));
    return 1 - Logs.likelihood(BOX, ping, List.of(change))[0];
  }

  /** A file may name what moves the sensor in any order: what happens has one. */
  @Test
  void changesOfThePose_haveAnOrderOfTheirOwn() {
    List<Change> all =
        List.of(
            new BeamMisalignment(0.2, Optional.empty()),
            new Latency(0.15),
            new PingDelay(1.5),
            new OdometryScale(1.1),
            new PathScale(0.9),
            new HeadingDrift(0.05, true),
            new HeadingDriftByWay(0.2));
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      rows.add(Logs.row(0.1 * i, Pose.of(0.08 * i, 0.03 * i * i, 0.1 * i), Logs.SILENCE));
    }
    for (Change one : all) {
      for (Change other : all) {
        if (one.getClass() != other.getClass()) {
          String which = one + " and " + other;
          assertArrayEquals(poses(rows, one, other), poses(rows, other, one), 1e-12, which);
        }
      }
    }
  }

  private static double[] poses(List<ReadingRow> rows, Change one, Change other) {
    ChangedModel model = new ChangedModel(BOX, List.of(one, other));
    Geometry geometry = model.geometry(new PingLog(rows));
    double[] values = new double[3 * rows.size()];
    for (int i = 0; i < rows.size(); i++) {
      values[3 * i] = geometry.xM(i);
      values[3 * i + 1] = geometry.zM(i);
      values[3 * i + 2] = geometry.headingRad(i);
    }
    return values;
  }

  /** Any angle on the page: a face 2.975 m ahead, half a metre to either side. */
  @ParameterizedTest
  @ValueSource(doubles = {0, 35, 90, 145, 180, 260, 330})
  void face_answersFromItsEnd_whereThatIsInTheCone(double turnDeg) {
    double turn = Math.toRadians(turnDeg);
    double cos = Math.cos(turn);
    double sin = Math.sin(turn);
    Change face =
        new UnmodelledObject(
            2.975 * cos, -2.975 * sin, Math.PI + turn, 0.5, Math.toRadians(40), 9, 0.8);
    // From 0.6 m to the right of its middle its end lies 1.9 degrees to the left of straight ahead.
    Pose left = Pose.of(0.6 * sin, 0.6 * cos, turn + Math.toRadians(26.5));
    Pose right = Pose.of(0.6 * sin, 0.6 * cos, turn - Math.toRadians(26.5));
    assertEquals(0.2, silent(left, face), 1e-9, "24.6 degrees off");
    assertEquals(1, silent(right, face), 1e-9, "28.4 degrees off");
    assertEquals(0.2, silent(Pose.of(0, 0, turn), face), 1e-9);
    assertEquals(1, silent(Pose.of(0, 0, turn + Math.toRadians(41)), face), 1e-9);
  }

  private static double silent(Pose pose, Change change) {
    List<ReadingRow> ping = List.of(Logs.row(0, pose, Logs.SILENCE));
    return Logs.likelihood(EMPTY, ping, List.of(change))[0];
  }

  @Test
  void parameter_saysWhatItMayBe() {
    Parameter timeout = Parameter.of("end_m", Double.POSITIVE_INFINITY, 0.3, 6, 1, 2);
    assertEquals("in [0.3, 6.0] or Infinity", timeout.domain());
    assertTrue(timeout.permits(Double.POSITIVE_INFINITY) && timeout.permits(0.3));
    assertFalse(timeout.permits(6.1) || timeout.permits(0.2) || timeout.permits(Double.NaN));
    Parameter gain = Parameter.of("gain", 1, 0.5, 1, 0.9);
    assertEquals("in [0.5, 1.0]", gain.domain());
    assertTrue(gain.permits(1));
    assertEquals("in [0.0, 1.0]", Parameter.of("share", 0, 0, 1, 0.1).domain());
    assertFalse(gain.permits(1.1));
  }

  private static List<String> names(Effect effect, List<String> sensors, Obstacle... obstacles) {
    return Forms.all(setup(0.05, Scenes.of(obstacles)), sensors).stream()
        .filter(form -> form.effect() == effect)
        .map(Form::name)
        .toList();
  }

  /** What is of one obstacle or transducer and what is of all are two forms where there are two. */
  @Test
  void forms_areOfOneOrOfAll() {
    Obstacle box = Scenes.box(1, 0, 1.2);
    Obstacle other = Scenes.box(-1, 0, 1.2);
    List<String> one = List.of("left");
    List<String> two = List.of("left", "right");
    assertEquals(List.of("all"), names(Effect.OBSTACLE_OFFSET, one, box));
    assertEquals(3, names(Effect.OBSTACLE_OFFSET, one, box, other).size());
    assertEquals(List.of("all"), names(Effect.BEAM_MISALIGNMENT, one, box));
    assertEquals(
        List.of("all", "only:left", "only:right"), names(Effect.BEAM_MISALIGNMENT, two, box));
    assertFalse(names(Effect.ORIENTATION_SHADOW, one, box).contains("tables#0"));
    assertTrue(names(Effect.ORIENTATION_SHADOW, one, box, other).contains("tables#0,1"));
  }

  /** Laws by the angle to the centre, to the outline, and to the nearest point. */
  @Test
  void forms_areAllOfTheirKind() {
    List<String> patterns = names(Effect.BEAM_PATTERN, List.of("s"), Scenes.box(1, 0, 1.2));
    assertTrue(patterns.stream().anyMatch(name -> name.endsWith("-nearest")), patterns::toString);
    assertTrue(names(Effect.STALE_READING, List.of("s")).containsAll(List.of("count", "time")));
    assertTrue(names(Effect.PREVIOUS_PING, List.of("s")).contains("read-nearer"));
  }
}
