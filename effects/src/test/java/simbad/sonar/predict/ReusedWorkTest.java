package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.stream.IntStream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import simbad.definition.Parameter;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.Form;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.level.Curve;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.NearEcho;
import simbad.sonar.ping.NearField;
import simbad.sonar.ping.NearRange;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.sensing.ReadingRow;

/** What is taken over from before, or left out as not asked for, changes no bit of the rest. */
class ReusedWorkTest {
  private static final List<String> SENSORS = List.of("sonar");
  private static final int PINGS = 30;

  private final List<Change> law = new ArrayList<>();
  private final List<Change> nearFields = new ArrayList<>();
  private SensingSetup setup = new SensingSetup(Sonars.noisy(0, 0, 0, 0), Scenes.any(random(0)), 6);

  private static Random random(long seed) {
    return new Random(seed);
  }

  /** A world that is heard by one law or the other, and looked at from a few places. */
  private PingLog world(Random random) {
    law.clear();
    nearFields.clear();
    setup = new SensingSetup(Sonars.noisy(0.05, 0.03, 0.1, 0.1), Scenes.any(random), 6.5);
    if (random.nextBoolean()) {
      setup = setup.under(SensorLaw.Model.LEVEL);
      Form form = LevelForms.law(setup);
      law.add(form.with(form.neutral()));
      Obstacle first = setup.scene().obstacles().get(0);
      nearFields.add(new NearEcho(Optional.empty(), Optional.of(new NearField(first, 700))));
      nearFields.add(new NearEcho(Optional.empty(), Optional.of(new NearField(first, 350))));
      nearFields.add(new NearRange(Curve.of(0.1, -0.03, 2, 0)));
    }
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < PINGS; i++) {
      Pose pose =
          Pose.of(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-4, 4));
      OptionalDouble range =
          random.nextInt(3) > 0 ? Logs.SILENCE : OptionalDouble.of(0.05 * random.nextInt(2, 60));
      rows.add(Logs.row(0.1 * i, pose, range));
    }
    return new PingLog(rows);
  }

  /** The law with up to two changes of different effects. */
  private List<Change> changes(Random random) {
    List<Form> forms = Logs.forms(setup, SENSORS);
    List<Change> changes = new ArrayList<>(law);
    Form first = forms.get(random.nextInt(forms.size()));
    Form second = forms.get(random.nextInt(forms.size()));
    changes.add(change(first, random));
    if (random.nextBoolean() && !first.of().equals(second.of())) {
      changes.add(change(second, random));
    }
    int field = random.nextInt(4);
    if (field < nearFields.size()) {
      changes.add(law.size(), nearFields.get(field));
    }
    return changes;
  }

  private static Change change(Form form, Random random) {
    List<Parameter> parameters = form.parameters();
    return form.with(
        parameters.stream()
            .mapToDouble(p -> p.tries().get(random.nextInt(p.tries().size())))
            .toArray());
  }

  @Property(tries = 1500, seed = "17")
  void geometryLikeAnotherOne_isTheSameAsAnew(@ForAll long seed) {
    Random random = random(seed);
    PingLog log = world(random);
    List<Change> before = changes(random);
    List<Change> now = changes(random);
    if (random.nextBoolean()) {
      // Often only one change is missing.
      now = new ArrayList<>(before);
      now.remove(now.size() - 1);
    }
    ChangedModel model = new ChangedModel(setup, now);
    Geometry known = new ChangedModel(setup, before).geometry(log);
    IntStream.range(0, log.size() * known.obstacles())
        .filter(line -> random.nextInt(3) > 0)
        .forEach(line -> seen(known, line));
    Geometry expected = model.geometry(log);
    Geometry found = model.geometryLike(known);
    for (int line = 0; line < log.size() * expected.obstacles(); line++) {
      assertArrayEquals(seen(expected, line), seen(found, line), 0, now + " after " + before);
    }
    for (int ping = 0; ping < log.size(); ping++) {
      assertEquals(expected.isEmpty(ping), found.isEmpty(ping));
    }
  }

  /** Models that look back are asked with all pings, all others with those that count alone. */
  @Property(tries = 1500, seed = "19")
  void geometryOfSomePings_readsThemAsAmongAll(@ForAll long seed) {
    Random random = random(seed);
    PingLog log = world(random);
    ChangedModel model = new ChangedModel(setup, changes(random));
    boolean[] only = some(random);
    Geometry known = new ChangedModel(setup, changes(random)).geometry(log);
    Geometry again = model.geometryLike(model.geometryLike(known, only), only);
    double[] expected = new double[PINGS];
    double[] found = new double[PINGS];
    model.likelihood(model.geometry(log), expected, null, only, new Answers());
    model.likelihood(
        model.looksBack() ? model.geometry(log) : again, found, null, only, new Answers());
    for (int ping = 0; ping < PINGS; ping++) {
      assertEquals(only[ping] ? expected[ping] : 0, only[ping] ? found[ping] : 0);
    }
  }

  private static boolean[] some(Random random) {
    boolean[] only = new boolean[PINGS];
    for (int ping = 0; ping < PINGS; ping++) {
      only[ping] = random.nextInt(3) == 0;
    }
    return only;
  }

  private static double[] seen(Geometry geometry, int line) {
    boolean heard = geometry.ears() != null && geometry.nearestM(line) < Double.POSITIVE_INFINITY;
    return new double[] {
      geometry.nearestM(line),
      geometry.centreDistanceM(line),
      geometry.bearingRad(line),
      geometry.bearingCos(line),
      geometry.bearingSin(line),
      geometry.thresholdM(line),
      geometry.offAxisRad(line),
      geometry.outlineOffAxisRad(line),
      geometry.echoOffAxisRad(line),
      heard ? geometry.excessDb(line) : 0,
      heard ? geometry.excessDeviationDb(line) : 0,
      heard ? geometry.pathM(line) : 0,
      heard ? geometry.pathDeviationM(line) : 0
    };
  }

  @Property(tries = 1500, seed = "18")
  void pingsThatAreAskedFor_areAsAmongAll(@ForAll long seed) {
    Random random = random(seed);
    PingLog log = world(random);
    ChangedModel model = new ChangedModel(setup, changes(random));
    Geometry geometry = model.geometry(log);
    double[] all = new double[PINGS];
    double[] allEchoes = new double[PINGS];
    model.likelihood(geometry, all, allEchoes, null, new Answers());
    boolean[] only = some(random);
    double[] some = new double[PINGS];
    double[] someEchoes = new double[PINGS];
    model.likelihood(geometry, some, someEchoes, only, new Answers());
    for (int ping = 0; ping < PINGS; ping++) {
      if (only[ping]) {
        assertEquals(all[ping], some[ping], 0, model.changes().toString());
        assertEquals(log.echo(ping) ? allEchoes[ping] : 0, log.echo(ping) ? someEchoes[ping] : 0);
      }
    }
  }

  /** As a fit does: most models differ from the one before in one change, or in its values. */
  @Property(tries = 800, seed = "20")
  void answersThatOtherModelsFound_areThoseFoundAnew(@ForAll long seed) {
    Random random = random(seed);
    PingLog log = world(random);
    Answers known = new Answers();
    List<Change> changes = changes(random);
    Geometry geometry = new ChangedModel(setup, changes).geometry(log);
    for (int step = 0; step < 6; step++) {
      ChangedModel model = new ChangedModel(setup, changes);
      boolean[] only = random.nextBoolean() ? null : some(random);
      double[] expected = new double[PINGS];
      double[] expectedEchoes = new double[PINGS];
      model.likelihood(geometry, expected, expectedEchoes, only, new Answers());
      double[] found = new double[PINGS];
      double[] foundEchoes = new double[PINGS];
      model.likelihood(geometry, found, foundEchoes, only, known);
      assertArrayEquals(expected, found, 0, changes.toString());
      assertArrayEquals(expectedEchoes, foundEchoes, 0, changes.toString());
      List<Change> next = withAnotherLast(changes, random);
      boolean looksElsewhere = !deciding(next).equals(deciding(changes));
      geometry = looksElsewhere ? new ChangedModel(setup, next).geometry(log) : geometry;
      changes = next;
    }
  }

  private List<Change> withAnotherLast(List<Change> changes, Random random) {
    int last = Math.max(law.size(), changes.size() - 1);
    List<Change> next = new ArrayList<>(changes.subList(0, last));
    List<Change> others = changes(random);
    Change other = others.get(others.size() - 1);
    // Of some kinds a model holds one.
    if (next.stream().noneMatch(change -> change.getClass() == other.getClass())) {
      next.add(other);
    }
    return next;
  }

  private static List<Change> deciding(List<Change> changes) {
    return changes.stream().filter(Geometry::dependsOn).toList();
  }
}
