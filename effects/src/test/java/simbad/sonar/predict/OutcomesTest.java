package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.CoarseResolution;
import simbad.sonar.change.CoarseResolution.Reported;
import simbad.sonar.change.EarlyCrosstalk;
import simbad.sonar.change.NearClamp;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.effect.Form;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** What a ping may read adds up to 1, whatever is changed and whatever was read before. */
class OutcomesTest {
  private static final int PINGS = 5;

  /** Any set of up to 4 forms at any values. */
  record Case(SensingSetup setup, List<ReadingRow> rows, List<Change> changes, List<String> forms) {

    static Case any(Random random, double resolutionM) {
      SensingSetup setup =
          new SensingSetup(
              Sonars.noisy(
                  resolutionM,
                  random.nextInt(3) == 0 ? 0 : random.nextDouble(0.2),
                  random.nextDouble(0.3),
                  random.nextInt(3) == 0 ? 0 : random.nextDouble(0.3)),
              Scenes.any(random),
              6.5);
      List<ReadingRow> rows = new ArrayList<>();
      double time = 0;
      double last = 1;
      for (int i = 0; i < PINGS; i++) {
        double x = random.nextDouble(-2, 2);
        double z = random.nextDouble(-2, 2);
        Pose pose = Pose.of(x, z, random.nextDouble(-4, 4));
        last = random.nextInt(3) > 0 ? last : random.nextInt(8) * Math.max(0.1, resolutionM);
        OptionalDouble range = random.nextInt(3) == 0 ? Logs.SILENCE : OptionalDouble.of(last);
        rows.add(Logs.row(time, pose, range));
        time += random.nextInt(4) == 0 ? 0 : random.nextDouble(0.3);
      }
      return withChanges(setup, rows, random);
    }

    private static Case withChanges(SensingSetup setup, List<ReadingRow> rows, Random random) {
      List<Form> forms = new ArrayList<>(Logs.forms(setup, List.of("sonar")));
      Collections.shuffle(forms, random);
      List<Change> changes = new ArrayList<>();
      List<String> names = new ArrayList<>();
      Set<Optional<Effect>> effects = new HashSet<>();
      for (Form form : forms.subList(0, 1 + random.nextInt(4))) {
        if (form.of().isEmpty() || effects.add(form.of())) {
          changes.add(form.with(values(form, random)));
          names.add(form.toString());
        }
      }
      return new Case(setup, rows, changes, names);
    }

    private static double[] values(Form form, Random random) {
      return form.parameters().stream().mapToDouble(p -> value(p, random)).toArray();
    }

    /** Anywhere between the bounds, or at one of them. */
    private static double value(Parameter parameter, Random random) {
      return switch (random.nextInt(8)) {
        case 0 -> parameter.low();
        case 1 -> parameter.high();
        default -> random.nextDouble(parameter.low(), parameter.high());
      };
    }

    double probability(OptionalDouble lastRangeM) {
      List<ReadingRow> read = new ArrayList<>(rows);
      ReadingRow last = read.remove(PINGS - 1);
      read.add(Logs.row(last.timeS(), last.pose(), lastRangeM));
      return Logs.likelihood(setup, read, changes)[PINGS - 1];
    }
  }

  private static void assertAddsUp(Case some, double resolutionM, double greatestM) {
    double sum = some.probability(Logs.SILENCE);
    for (int step = 0; step * resolutionM < greatestM; step++) {
      double probability = some.probability(OptionalDouble.of(step * resolutionM));
      assertTrue(probability >= 0 && probability <= 1 + 1e-12, some.forms + " " + probability);
      sum += probability;
    }
    assertEquals(1, sum, 1e-9, some.forms.toString());
  }

  @Property(tries = 150, seed = "20140617")
  void anyForms_probabilitiesAddUpToOne(@ForAll long seed) {
    assertAddsUp(Case.any(new Random(seed), 0.5), 0.5, 150);
  }

  /** Fine steps, in which clamps and coarse steps have their ends. */
  @Property(tries = 60, seed = "20140617")
  void outputForms_probabilitiesAddUpToOne(@ForAll long seed) {
    Random random = new Random(seed);
    Case plain = Case.any(random, 0.03);
    List<Change> changes =
        List.of(
            new CoarseResolution(
                random.nextDouble(0.5), random.nextBoolean() ? Reported.NEAREST : Reported.CENTRE),
            new NearClamp(random.nextDouble(1)),
            new RangeOffset(random.nextDouble(-1, 1)),
            new EarlyCrosstalk(random.nextDouble(), random.nextDouble(2), 2 + random.nextDouble()));
    assertAddsUp(new Case(plain.setup, plain.rows, changes, List.of(changes.toString())), 0.03, 12);
  }

  @Property(tries = 400, seed = "20140617")
  void anyForms_forecastIsADistribution(@ForAll long seed) {
    Random random = new Random(seed);
    Case some = Case.any(random, List.of(0.0, 0.01, 0.1).get(random.nextInt(3)));
    double noEcho = random.nextDouble(0.5, 7);
    for (ReadingDistribution one : Logs.forecast(some.setup, some.rows, some.changes)) {
      double silent = one.noEchoProbability();
      assertTrue(silent >= 0 && silent <= 1, some.forms + " " + silent);
      assertEquals(1, silent + one.echoUpTo(Double.POSITIVE_INFINITY), 1e-9, some.forms.toString());
      double before = 0;
      for (double range = 0; range < 20; range += 0.173) {
        double upTo = one.echoUpTo(range);
        assertTrue(upTo >= before - 1e-12, some.forms + " at " + range);
        before = upTo;
      }
      double last = 0;
      for (int level = 1; level < 20; level++) {
        double quantile = one.quantileM(level / 20.0, noEcho);
        assertTrue(quantile >= last, some.forms + " level " + level + ": " + quantile);
        last = quantile;
      }
      assertTrue(last < 1000, some.forms + " reads " + last);
    }
  }

  /** Changes are a set: their order in a list is of no interest. */
  @Property(tries = 200, seed = "20140617")
  void anyForms_inAnyOrder(@ForAll long seed) {
    Random random = new Random(seed);
    Case some = Case.any(random, 0.1);
    List<Change> shuffled = new ArrayList<>(some.changes);
    Collections.shuffle(shuffled, random);
    double[] expected = Logs.likelihood(some.setup, some.rows, some.changes);
    double[] found = Logs.likelihood(some.setup, some.rows, shuffled);
    for (int ping = 0; ping < expected.length; ping++) {
      assertEquals(expected[ping], found[ping], 1e-12, some.forms.toString());
    }
  }
}
