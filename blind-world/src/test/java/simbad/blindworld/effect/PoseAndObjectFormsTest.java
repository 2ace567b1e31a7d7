package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static simbad.blindworld.effect.EffectGround.circumstances;
import static simbad.blindworld.effect.EffectGround.draw;
import static simbad.blindworld.effect.EffectGround.hearing;
import static simbad.blindworld.effect.EffectGround.number;

import java.util.List;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.world.AnyPing;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.TestWorlds;

/** Where a transducer really is, things that are not in the scene, and circumstances. */
class PoseAndObjectFormsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-9;
  private static final double HEARD = 1e-6;

  /** Half a metre a second along x, then down the page; seen each second for 4 s. */
  private static final Recording DRIVE =
      new Recording(
          List.of(
              row(0, -3, 1, 0),
              row(1, -2.5, 1, 0),
              row(2, -2, 1, 0),
              row(3, -2, 1.5, -0.5),
              row(4, -2, 2, -1)));

  private static Row row(double tS, double xM, double zM, double headingRad) {
    return new Row("r", "s", tS, new Pose(xM, zM, headingRad));
  }

  private static List<Pose> moved(
      String name, String form, double strength, RandomGenerator chance) {
    Circumstances c = new Circumstances(EffectGround.SCENE, DRIVE, true, chance, strength);
    return Vocabulary.draw(name, form, c)
        .change()
        .poses(DRIVE, DRIVE.rows().stream().map(Row::pose).toList(), new FixedChance(0.75));
  }

  private static List<Pose> moved(String name, String form, double strength) {
    return moved(name, form, strength, new FixedChance(0.5));
  }

  private static void assertPose(double xM, double zM, double headingRad, Pose pose) {
    assertEquals(xM, pose.xM(), NEAR);
    assertEquals(zM, pose.zM(), NEAR);
    assertEquals(headingRad, pose.headingRad(), NEAR);
  }

  /** At least 1.2 pings, which are 1.2 s here; 0.4 s times the size from 3 on. */
  @Test
  void latency_isWhereItWas() {
    List<Pose> late = moved("latency", "seconds", 1);
    assertPose(-3, 1, 0, late.get(0));
    assertPose(-3, 1, 0, late.get(1));
    assertPose(-3 + 0.4, 1, 0, late.get(2));
    assertPose(-2.1, 1, 0, late.get(3));
    assertPose(-2, 1.4, -0.4, late.get(4));
    assertPose(-2, 1, 0, moved("latency", "seconds", 5).get(4));
    assertEquals(DRIVE.rows().get(3).pose(), moved("latency", "seconds", 0).get(3));
    assertPose(-2, 1.5, -0.5, moved("latency", "pings", 1).get(4));
    assertPose(-3, 1, 0, moved("latency", "pings", 5).get(2));
    // Chance of three quarters is half of the 15 per cent more.
    assertPose(-2, 1.5 - 0.5 * 0.29, -0.5 + 0.5 * 0.29, moved("latency", "jittered", 1).get(4));
  }

  @Test
  void latency_ofJitterIsRestless() {
    assertTrue(draw("latency", "jittered", 1).change().restless());
    assertFalse(draw("latency", "pings", 1).change().restless());
    assertEquals(0.15 * 1.2, number(draw("latency", "jittered", 1), "jitter_s"), NEAR);
    assertEquals(2, number(draw("latency", "pings", 5), "pings"));
    assertEquals(2, number(draw("latency", "pings", 5), "s"), NEAR);
  }

  /** It believes 1.06 m where it made one. */
  @Test
  void odometry_believesTooMuch() {
    List<Pose> scaled = moved("odometry-scale", "from the start", 1);
    assertPose(-3, 1, 0, scaled.get(0));
    assertPose(-3 + 1 / 1.06, 1 + 1 / 1.06, -1, scaled.get(4));
    // 2 m of way are 2 / 1.07: 0.869 down the second leg.
    assertPose(-2, 2 / 1.07, 1 - 2 / 1.07, moved("odometry-scale", "along the path", 1).get(4));
    assertPose(-2, 2, -1, moved("odometry-scale", "along the path", 0).get(4));
  }

  /** 8 degrees over the 4 s of the log. */
  @Test
  void heading_drifts() {
    double most = Math.toRadians(8);
    assertPose(-2, 1.5, -0.5 + 0.75 * most, moved("heading-drift", "in place", 1).get(3));
    FixedChance down = new FixedChance(0.5).coins(false);
    assertPose(-2, 2, -1 - most, moved("heading-drift", "in place", 1, down).get(4));
    // With a constant of 0.4 of the log it levels off at 1.2 times as much.
    double level = 1.2 * most * (1 - Math.exp(-4 / 1.6));
    assertPose(-2, 2, -1 + level, moved("heading-drift", "levelling off", 1).get(4));
    assertPose(-2, 2, -1 + Math.toRadians(4), moved("heading-drift", "by the way", 1).get(4));
  }

  /** Each step is turned by what the heading is off at its end, counter-clockwise. */
  @Test
  void heading_leadsAstray() {
    double perS = Math.toRadians(2);
    double x = -3 + 0.5 * (Math.cos(perS) + Math.cos(2 * perS)) + 0.5 * Math.sin(3 * perS);
    double z = 1 - 0.5 * (Math.sin(perS) + Math.sin(2 * perS)) + 0.5 * Math.cos(3 * perS);
    Pose third = moved("heading-drift", "dead reckoning", 1).get(3);
    assertPose(x, z, -0.5 + 3 * perS, third);
  }

  /** Poses are those of each track by itself: a second transducer has a path of its own. */
  @Test
  void clock_stretches() {
    List<Pose> stretched = moved("clock-stretch", "linear", 1);
    // 4 s are 3.52 s.
    assertPose(-2, 1.76, -0.76, stretched.get(4));
    assertPose(-3 + 0.44, 1, 0, stretched.get(1));
  }

  /**
   * Beside the second obstacle, the box at (0, 50), half of a turn round and 1.1 m away, it faces
   * back: along x. It is 0.45 m to each side, seen within 0.75 of the half-angle of 0.3 rad.
   */
  @Test
  void board_answersFromItsFoot() {
    Effect board = draw("unmodelled-object", "board", 1);
    assertEquals(-1.1, number(board, "x"), NEAR);
    assertEquals(50, number(board, "z"), NEAR);
    assertEquals(0.45, number(board, "halfwidth"), NEAR);
    assertEquals(Math.toDegrees(0.225), number(board, "square_deg"), NEAR);
    assertEquals(0.925, number(board, "p"), NEAR);
    assertEquals(1.1, seen(board, NONE, 0, 50, Math.PI, 0.92), NEAR);
    assertEquals(1.1, seen(board, NONE, 0, 50.4, Math.PI - 0.22, 0.92), NEAR);
    assertEquals(NONE, seen(board, NONE, 0, 50, Math.PI, 0.93), "not by chance");
    assertEquals(NONE, seen(board, NONE, 0, 50.5, Math.PI, 0.92), "beside it");
    assertEquals(NONE, seen(board, NONE, 0, 50, Math.PI - 0.23, 0.92), "askew");
    assertEquals(1, seen(board, 1, 0, 50, Math.PI, 0.92), "behind something nearer");
    assertEquals(NONE, seen(board, NONE, 2.1, 50, Math.PI, 0.92), "further than 3.1 m");
    Effect wall = draw("unmodelled-object", "wall", 1);
    assertEquals(1000, number(wall, "halfwidth"));
    assertEquals(0, number(draw("unmodelled-object", "wall", 0), "halfwidth"));
  }

  private static double seen(
      Effect effect, double distanceM, double xM, double zM, double headingRad, double chance) {
    return hearing(effect)
        .echoM(distanceM, AnyPing.from(new FixedChance(chance), new Pose(xM, zM, headingRad)));
  }

  /** At (-1.05, 50), 5 cm thick, heard to 1.9 m within 0.8 of 0.3 rad. */
  @Test
  void post_answersFromItsSide() {
    Effect post = draw("unmodelled-object", "post", 1);
    assertEquals(-1.05, number(post, "x"), NEAR);
    assertEquals(0.05, number(post, "radius"), NEAR);
    assertEquals(1.9, number(post, "reach"), NEAR);
    assertEquals(1, seen(post, NONE, 0, 50, Math.PI, 0.92), NEAR);
    assertEquals(1, seen(post, NONE, 0, 50, Math.PI + 0.23, 0.92), NEAR);
    assertEquals(NONE, seen(post, NONE, 0, 50, Math.PI + 0.25, 0.92));
    assertEquals(1, seen(post, NONE, -1.05, 51.05, Math.PI / 2, 0.92), NEAR);
    assertEquals(NONE, seen(post, NONE, 0.91, 50, Math.PI, 0.92), "out of reach");
    assertEquals(NONE, seen(post, NONE, 0, 50, Math.PI, 0.93), "not by chance");
    assertEquals(NONE, seen(post, NONE, -0.99, 50, Math.PI, 0.92), "too near");
    assertEquals(0.5, seen(post, 0.5, 0, 50, Math.PI, 0.92));
    assertEquals(0, number(draw("unmodelled-object", "post", 0), "reach"));
  }

  /** Ten pings at 1.0 to 1.9 m. */
  @Test
  void circumstances_knowWhatIsHeard() {
    Circumstances c = circumstances(new FixedChance(0.25, 0.75).coins(true, false), 2);
    assertEquals(1, c.echoShare());
    assertEquals(1.0, c.distanceM(0), HEARD);
    assertEquals(1.4, c.distanceM(0.45), HEARD);
    assertEquals(1.9, c.distanceM(1), HEARD);
    assertEquals(0.6, c.sized(0.3), NEAR);
    assertEquals(0.6, c.eitherWay(0.3), NEAR);
    assertEquals(-0.6, c.eitherWay(0.3), NEAR);
    assertEquals(3.5, c.between(3, 5), NEAR);
    assertEquals(6, c.whole(3, 6));
    assertEquals(0, c.obstacle());
    assertEquals("t", c.transducer());
    assertEquals("post", c.someObstacle().name());
    assertEquals(2, c.strength());
    assertTrue(c.driven() && c.severalSensors() && c.someUniform() && c.someTable());
    Circumstances drive =
        new Circumstances(EffectGround.SCENE, DRIVE, false, new FixedChance(0.5), 1);
    assertFalse(drive.severalSensors() || drive.driven());
    assertThrows(IllegalArgumentException.class, () -> circumstances(new FixedChance(0.5), -1));
  }

  /** A post heard until 1.5 m is heard on five of ten pings; one that is deaf on none. */
  @Test
  void circumstances_countWhatIsProbable() {
    Scene near = new Scene(5, EffectGround.SENSOR, List.of(TestWorlds.post("p", 0, 0, 1.47)));
    Circumstances half = new Circumstances(near, EffectGround.ROWS, true, new FixedChance(0.5), 1);
    assertEquals(0.5, half.echoShare());
    assertEquals(1.4, half.distanceM(1), HEARD);
    assertFalse(half.someTable());
    Scene deaf = new Scene(5, EffectGround.SENSOR, List.of(TestWorlds.post("p", 0, 0, 0)));
    Circumstances none = new Circumstances(deaf, EffectGround.ROWS, true, new FixedChance(0.5), 1);
    assertEquals(0, none.echoShare());
    assertEquals(1, none.distanceM(0.5));
    Scene table = new Scene(5, EffectGround.SENSOR, List.of(EffectGround.BOX));
    assertFalse(
        new Circumstances(table, EffectGround.ROWS, true, new FixedChance(0.5), 1).someUniform());
  }

  /** Forms that need a robot, several transducers, a table or a second obstacle. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "latency",
        "obstacle-turn",
        "one-gain",
        "crossed-wires",
        "second-echo",
        "speed-loss",
      })
  void forms_needTheirCircumstances(String name) {
    Scene one = new Scene(5, EffectGround.SENSOR, List.of(TestWorlds.post("p", 0, 0, 3)));
    Circumstances bench = new Circumstances(one, DRIVE, false, new FixedChance(0.5), 1);
    assertFalse(Vocabulary.applies(name, bench));
    assertTrue(Vocabulary.applies(name, circumstances(new FixedChance(0.5), 1)));
    String form = Vocabulary.forms(name).get(0);
    assertThrows(IllegalArgumentException.class, () -> Vocabulary.draw(name, form, bench));
    assertTrue(Vocabulary.applies("gain", bench));
  }

  @Test
  void vocabulary_drawsAndSorts() {
    Effect last = Vocabulary.draw("gain", circumstances(new FixedChance(0.99), 1));
    assertEquals("fluttering", last.parameters().get("form"));
    assertEquals(List.of("form", "flutter", "k"), List.copyOf(last.parameters().keySet()));
    Effect noise = draw("range-noise", "even", 1);
    Effect pose = draw("latency", "pings", 1);
    Effect map = draw("obstacle-turn", "all", 1);
    assertEquals(
        List.of(pose, map, last, noise), Vocabulary.inOrder(List.of(noise, last, map, pose)));
    assertTrue(Vocabulary.isSameStage("gain", "absorption"));
    assertFalse(Vocabulary.isSameStage("gain", "latency"));
    assertFalse(Vocabulary.isSameStage("wind-shear", "wind-shear"));
    assertEquals(Vocabulary.outside().stream().sorted().distinct().toList(), Vocabulary.outside());
    assertFalse(Vocabulary.outside().contains("gain"));
    assertFalse(Vocabulary.names().contains("wind-shear"));
  }
}
