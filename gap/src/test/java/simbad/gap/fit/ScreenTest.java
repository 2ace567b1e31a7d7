package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** Of the forms of an effect the one that drew the log is found, where others come near. */
class ScreenTest {
  private static SensingSetup twoPosts() {
    Obstacle post = Worlds.POST.scene().obstacles().get(0);
    Obstacle other =
        new Obstacle("other", new Placement(0.5, 0.4, 0), post.outline(), post.detection());
    return new SensingSetup(
        Worlds.POST.sensor(), new Scene(List.of(post, other)), Worlds.POST.noEchoM());
  }

  private static Form form(SensingSetup setup, Effect effect, String name) {
    return Forms.find(effect, name, setup, List.of("s")).orElseThrow();
  }

  /** Anywhere within 1.3 m and looking anywhere. */
  private static List<ReadingRow> lookingRound() {
    Random random = new Random(33);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 1500; i++) {
      double x = 2.6 * random.nextDouble() - 1.3;
      double z = 2.6 * random.nextDouble() - 1.3;
      Pose pose = Pose.of(x, z, 2 * Math.PI * random.nextDouble());
      rows.add(new ReadingRow("r", "s", 0.05 * i, pose, NoEcho.NO_ECHO));
    }
    return rows;
  }

  private static Fit screened(SensingSetup setup, Hypothesis truth, List<ReadingRow> poses) {
    PingLog log = new PingLog(Worlds.read(setup, poses, truth, 32));
    CalibratedLog given = new CalibratedLog(setup, List.of(), log);
    Effect effect = truth.effects().get(0);
    Fit nominal = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    List<Form> forms =
        Forms.all(setup, log.sensors()).stream().filter(f -> f.effect() == effect).toList();
    Fit found = Objects.requireNonNull(new Screen(given, nominal).all(forms).get(effect));
    double atTruth = new Fitter(given, Fold.ALL).logLikelihood(truth);
    assertTrue(
        found.logLikelihood() > atTruth - 40,
        found.logLikelihood() + " found, " + atTruth + " where it was drawn");
    return found;
  }

  @Test
  void shadowsOfSeveralObstacles_areFoundTogether() {
    SensingSetup setup = twoPosts();
    double[] tables = new double[2 * Forms.TABLE_SIZE];
    Arrays.setAll(tables, i -> i % Forms.TABLE_SIZE < Forms.TABLE_SIZE / 2 ? 0.5 : 1.5);
    Form form = form(setup, Effect.ORIENTATION_SHADOW, "tables#0,1");
    Fit found =
        screened(setup, Hypothesis.NONE.and(form, tables), Worlds.poses(4000, 0.7, 2.6, 31));
    assertEquals(List.of(form), found.hypothesis().forms());
  }

  /**
   * A post is read 3,000 times. Each fiftieth echo is missed, and the reading before stands for it;
   * four times the sensor looks away for three pings, and the third of them reads nothing: a
   * reading is held for two pings. No such third ping is among those by which starts are chosen.
   */
  @Test
  void whatFewReadingsTell_isFoundByAllOfThem() {
    int pings = 3000;
    Fold some = new Thinned(pings, 3);
    Random random = new Random(34);
    List<ReadingRow> rows = new ArrayList<>();
    int last = 0;
    int away = 0;
    double read = 0;
    for (int ping = 0; ping < pings; ping++) {
      boolean begins = ping > last + 600 && ping % 50 == 5 && !some.holds(ping + 2);
      last = begins ? ping : last;
      away = begins ? 3 : Math.max(0, away - 1);
      boolean isMissed = away > 0 || ping % 50 == 25;
      read = isMissed ? read : Math.rint(100 * (0.95 + 0.005 * random.nextGaussian())) / 100;
      Pose pose = Pose.of(-1, 0, away > 0 ? Math.PI : 0);
      rows.add(
          new ReadingRow("r", "s", 0.05 * ping, pose, away == 1 ? NoEcho.NO_ECHO : new Echo(read)));
    }
    PingLog log = new PingLog(rows);
    CalibratedLog given = new CalibratedLog(Worlds.POST, List.of(), log);
    Fit nominal = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    Form count = form(Worlds.POST, Effect.STALE_READING, "count");
    Fit found = new Screen(given, nominal).all(List.of(count)).get(Effect.STALE_READING);
    assertEquals(2, Math.floor(Objects.requireNonNull(found).hypothesis().values()[0]));
  }

  /** The form with a value more fits at least as well: it holds the other. */
  @ParameterizedTest
  @CsvSource({"dropout, single, 0.2, bursts", "range-offset, constant, 0.04, scattered"})
  void ofFormsThatFitAlike_theSimplerIsTaken(
      Effect effect, String simple, double value, String wider) {
    assertTrue(
        form(Worlds.POST, effect, wider).parameters().size()
            > form(Worlds.POST, effect, simple).parameters().size());
    Fit found =
        screened(
            Worlds.POST, Worlds.effect(effect, simple, value), Worlds.poses(600, 0.3, 1.6, 36));
    assertEquals(simple, found.hypothesis().forms().get(0).name());
  }

  /** The angle at which it is heard no more is a gate: between its pings nothing changes. */
  @Test
  void gateOfAFace_isFound() {
    Hypothesis truth =
        Worlds.effect(Effect.UNMODELLED_OBJECT, "face", -1.5, 0, 0, 2, 0.97, 13, 2.4);
    Fit found = screened(Worlds.POST, truth, lookingRound());
    assertEquals("face", found.hypothesis().forms().get(0).name());
    assertEquals(13, found.hypothesis().values()[5], 0.7);
  }

  @Test
  void postBesideItsCell_isFound() {
    Hypothesis truth =
        Worlds.effect(Effect.UNMODELLED_OBJECT, "post", 0.913, -0.627, 0.053, 2.2, 0.95, 16);
    Fit found = screened(Worlds.POST, truth, lookingRound());
    assertEquals("post", found.hypothesis().forms().get(0).name());
    assertEquals(0.913, found.hypothesis().values()[0], 0.004);
    assertEquals(-0.627, found.hypothesis().values()[1], 0.004);
  }

  /** A square post in the place of a round one: its size, and which way it is turned. */
  @Test
  void postWithFlatSides_isFoundWhereARoundOneWas() {
    SensingSetup pole = Worlds.POST.under(SensorLaw.Model.LEVEL).with(round());
    Form law = LevelForms.law(pole);
    Form post = form(pole, Effect.ORIENTATION_SHADOW, "post:post#0");
    Hypothesis truth = Hypothesis.NONE.and(law, law.neutral()).and(post, 0.06, 0.045, 20);
    PingLog log = new PingLog(Worlds.read(pole, Worlds.poses(1200, 0.3, 2.5, 37), truth, 32));
    CalibratedLog given = new CalibratedLog(pole, List.of(law.with(law.neutral())), log);
    Fit nominal = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    Fit found =
        Objects.requireNonNull(
            new Screen(given, nominal).all(List.of(post)).get(Effect.ORIENTATION_SHADOW));
    assertArrayEquals(new double[] {0.06, 0.045, 20}, found.hypothesis().values(), 0.5);
    assertEquals(0.06, found.hypothesis().values()[0], 0.002);
    assertEquals(0.045, found.hypothesis().values()[1], 0.002);
  }

  private static Scene round() {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 48; i++) {
      double angle = Math.toRadians(7.5 * i);
      corners.add(new Point(0.03 * Math.sin(angle), 0.03 * Math.cos(angle)));
    }
    Obstacle post = Worlds.POST.scene().obstacles().get(0);
    return new Scene(
        List.of(
            new Obstacle(
                post.name(), post.worldFromObstacle(), Outline.of(corners), post.detection())));
  }

  /** The centres of steps are odd multiples of half a step, which keeps their beat as well. */
  @ParameterizedTest
  @CsvSource({"start, 0.061", "centre, 0.046", "nearest, 0.073"})
  void stepsOfNoRoundLength_areFound(String reported, double stepM) {
    Hypothesis truth = Worlds.effect(Effect.COARSE_RESOLUTION, reported, stepM);
    Fit found = screened(Worlds.POST, truth, Worlds.poses(800, 0.3, 1.6, 35));
    assertEquals(reported, found.hypothesis().forms().get(0).name());
    assertEquals(stepM, found.hypothesis().values()[0], 5e-4);
  }

  /** Whatever is strange lies nearer than any round of a walk is long. */
  @Test
  void walkOfStrangeEchoesCloseBy_isLookedFor() {
    List<ReadingRow> rows = new ArrayList<>();
    for (ReadingRow row : Worlds.read(lookingRound(), Hypothesis.NONE, 34)) {
      int turn = rows.size() % 40;
      rows.add(
          turn < 12
              ? new ReadingRow(
                  row.run(), row.sensor(), row.timeS(), row.pose(), new Echo(0.03 + 0.01 * turn))
              : row);
    }
    CalibratedLog given = Worlds.given(rows);
    Fit nominal = new Fitter(given, Fold.ALL).refine(Hypothesis.NONE, 0);
    List<Form> walks =
        Forms.all(Worlds.POST, List.of("s")).stream()
            .filter(form -> form.name().startsWith("walking"))
            .toList();
    Fit found =
        Objects.requireNonNull(new Screen(given, nominal).all(walks).get(walks.get(0).effect()));
    assertTrue(found.logLikelihood() > nominal.logLikelihood() + 50, () -> "found " + found);
  }
}
