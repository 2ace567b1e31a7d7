package simbad.sonar.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.definition.Effect;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** Where fits start, and what a log can show, of a log of which half the readings are strange. */
class StartsTest {
  private static final List<String> SENSORS = List.of("s");

  /** Their values are those of the clues, which are made up here. */
  private static final Set<Effect> OF_CLUES =
      Set.of(Effect.ORIENTATION_SHADOW, Effect.UNMODELLED_OBJECT);

  private static final SonarSpec SENSOR =
      new SonarSpec("test", Math.toRadians(20), 0.03, 4, 0.15, 343, 0.01, 0.004, 0.005, 0.02, 0.05);
  private static final SensingSetup SETUP =
      new SensingSetup(
          SENSOR,
          new Scene(
              List.of(
                  new Obstacle(
                      "post",
                      new Placement(0, 0, 0),
                      Outline.of(
                          List.of(
                              new Point(0.01, 0.01),
                              new Point(0.01, -0.01),
                              new Point(-0.01, -0.01),
                              new Point(-0.01, 0.01))),
                      new UniformDetection(2)))),
          4);

  /** Twice the distance where the index is even, 3.97 m now and then, else the distance. */
  private static PingLog log() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      double distance = 0.5 + 0.02 * i;
      double read = i % 5 == 0 ? 3.97 : i % 2 == 0 ? 2 * distance : distance;
      rows.add(new ReadingRow("r", "s", 0.05 * i, Pose.of(-distance, 0, 0), new Echo(read)));
    }
    return new PingLog(rows);
  }

  /** Posts of the area that is believed, turned all the ways that a square can be. */
  @Test
  void flatSidedPosts_startAsSquaresOfTheSameArea() {
    Definition shadow = Definitions.of(Effect.ORIENTATION_SHADOW);
    Form post = shadow.levelForms(SETUP, List.of("s")).get(0);
    double areaM2 = Math.abs(SETUP.scene().obstacles().get(0).outline().signedAreaM2());
    List<double[]> starts = shadow.starts(post, new HalfStrange());
    assertEquals(30, starts.size());
    for (int i = 0; i < starts.size(); i++) {
      assertEquals(areaM2, starts.get(i)[0] * starts.get(i)[1], 1e-9);
      assertEquals(3.0 * i - 45, starts.get(i)[2]);
    }
  }

  private static final class HalfStrange implements Clues {
    private final PingLog log = StartsTest.log();

    @Override
    public PingLog log() {
      return log;
    }

    @Override
    public int obstacles() {
      return 1;
    }

    @Override
    public IntStream strangeEchoes() {
      return IntStream.range(0, log.size()).filter(i -> i % 2 == 0 || i % 5 == 0);
    }

    @Override
    public IntStream echoesInCone() {
      return IntStream.range(0, log.size());
    }

    @Override
    public double nearestM(int ping) {
      return 0.5 + 0.02 * ping;
    }

    @Override
    public DoubleStream audibleM() {
      return echoesInCone().mapToDouble(this::nearestM);
    }

    @Override
    public boolean hasEchoBefore(int ping) {
      return ping > 0;
    }

    @Override
    public List<Double> steps() {
      return List.of(0.03, 0.05);
    }

    @Override
    public List<Line> lines(int... echoes) {
      return List.of(new Line(1, 0.3, echoes.length), new Line(0.5, 0, 3));
    }

    @Override
    public List<double[]> posts(double mostReachM) {
      return List.of(new double[] {1, 1, 0.1, mostReachM / 2, 0.5, 0});
    }

    @Override
    public List<double[]> faces(Form form) {
      return List.of(form.neutral());
    }

    @Override
    public List<double[]> walks(Form form) {
      return List.of(form.neutral());
    }

    @Override
    public double[] tables(int... obstacles) {
      return new double[72 * obstacles.length];
    }

    @Override
    public double[] waves(int obstacle) {
      return new double[15];
    }
  }

  static List<Definition> definitions() {
    return Definitions.all();
  }

  @ParameterizedTest
  @MethodSource("definitions")
  void starts_haveAValueForEachParameter(Definition definition) {
    for (Form form : Forms.of(definition, SETUP, SENSORS)) {
      List<double[]> starts = definition.starts(form, new HalfStrange());
      assertFalse(starts.isEmpty(), form.toString());
      for (double[] start : starts) {
        if (!form.isTable() && !OF_CLUES.contains(form.effect())) {
          assertEquals(form.parameters().size(), start.length, form.toString());
          for (int i = 0; i < start.length; i++) {
            assertTrue(form.parameters().get(i).permits(start[i]), form + " " + start[i]);
          }
        }
      }
    }
  }

  @Test
  void aNumberForNothing_startsAtTheOneThatIsReadAgainAndAgain() {
    Form far = Forms.find(Effect.NO_ECHO_CODE, "far", SETUP, SENSORS).orElseThrow();
    double[] first = Definitions.of(Effect.NO_ECHO_CODE).starts(far, new HalfStrange()).get(0);
    assertEquals(3.97, first[0], 1e-9);
  }

  private static boolean canShow(Effect effect, LogDesign design) {
    return Forms.all(SETUP, SENSORS).stream()
        .filter(form -> form.effect().equals(effect))
        .anyMatch(form -> Definitions.of(effect).canShow(form, design));
  }

  @Test
  void whatALogCanShow_dependsOnHowItWasTaken() {
    LogDesign drive = new LogDesign(SETUP, log(), false, false, true, 8, Set.of(), false);
    LogDesign ladder = new LogDesign(SETUP, log(), true, true, false, 0, Set.of("post"), false);
    LogDesign slow = new LogDesign(SETUP, log(), false, false, true, 100, Set.of(), false);

    assertFalse(canShow(Effect.PLACEMENT_ERROR, drive));
    assertTrue(canShow(Effect.PLACEMENT_ERROR, ladder));
    LogDesign stated = new LogDesign(SETUP, log(), true, false, false, 0, Set.of("post"), false);
    assertFalse(canShow(Effect.PLACEMENT_ERROR, stated), "no further off than said");
    assertTrue(canShow(Effect.RANGE_NOISE, drive));
    assertFalse(canShow(Effect.RANGE_NOISE, ladder));
    assertTrue(canShow(Effect.PREVIOUS_PING, drive));
    assertFalse(canShow(Effect.PREVIOUS_PING, slow));
    assertTrue(canShow(Effect.OBSTACLE_TURN, drive));
    assertFalse(canShow(Effect.OBSTACLE_TURN, ladder));
    assertTrue(canShow(Effect.NO_ECHO_CODE, drive), "3.97 m is read twelve times");
  }

  private static LogDesign looking(double zM, int... degrees) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < degrees.length; i++) {
      Pose pose = Pose.of(-1, i * zM, Math.toRadians(degrees[i]));
      rows.add(new ReadingRow("r", "s", i, pose, NoEcho.NO_ECHO));
    }
    return new LogDesign(SETUP, new PingLog(rows), false, false, true, 8, Set.of(), false);
  }

  /** A sensor that looks around: past an obstacle that is aside, or turned itself. */
  @Test
  void ofOnePlace_turnsAndPlacesAreAlike() {
    LogDesign once = looking(0, 340, 350, 0, 0, 10);
    LogDesign backAndForth = looking(0, 340, 0, 10, 0, 340);
    LogDesign twiceRound = looking(0, 0, 120, 240, 0, 120, 240, 0);
    LogDesign moving = looking(0.01, 340, 350, 0, 10);
    for (LogDesign design : List.of(once, backAndForth, twiceRound)) {
      assertEquals(
          Set.of(Effect.BEAM_MISALIGNMENT), Definitions.of(Effect.OBSTACLE_OFFSET).twins(design));
      assertEquals(
          Set.of(Effect.OBSTACLE_OFFSET), Definitions.of(Effect.BEAM_MISALIGNMENT).twins(design));
    }
    assertEquals(Set.of(), Definitions.of(Effect.OBSTACLE_OFFSET).twins(moving));
    assertFalse(canShow(Effect.HEADING_DRIFT, once));
    assertFalse(canShow(Effect.LATENCY, once));
    assertTrue(canShow(Effect.HEADING_DRIFT, backAndForth));
    assertTrue(canShow(Effect.LATENCY, backAndForth));
    assertTrue(canShow(Effect.HEADING_DRIFT, twiceRound));
    assertTrue(canShow(Effect.HEADING_DRIFT, moving));
  }

  @Test
  void aNumberForNothing_isReadAsOftenAsNothing() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 7; i++) {
      Pose pose = Pose.of(-1, 0, 0);
      rows.add(new ReadingRow("r", "s", i, pose, i < 3 ? new Echo(0) : NoEcho.NO_ECHO));
    }
    PingLog rarer = new PingLog(rows);
    PingLog often = new PingLog(rows.subList(0, 6));
    assertFalse(
        canShow(
            Effect.NO_ECHO_CODE,
            new LogDesign(SETUP, rarer, false, false, true, 8, Set.of(), false)));
    assertTrue(
        canShow(
            Effect.NO_ECHO_CODE,
            new LogDesign(SETUP, often, false, false, true, 8, Set.of(), false)));
  }
}
