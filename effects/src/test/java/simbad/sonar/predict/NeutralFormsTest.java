package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Parameter;
import simbad.sonar.effect.Form;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** At its neutral values every form, and any set of forms, is the nominal model to the last bit. */
class NeutralFormsTest {
  private static final List<String> SENSORS = List.of("s0", "s1");

  private static void assertNominal(
      SensingSetup setup, List<ReadingRow> rows, List<Change> changes, String what) {
    assertArrayEquals(
        Logs.likelihood(setup, rows, List.of()), Logs.likelihood(setup, rows, changes), 0, what);
    PingLog log = new PingLog(rows);
    NominalModel nominal = new NominalModel(setup.sensor(), setup.scene());
    List<ReadingDistribution> forecast = Logs.forecast(setup, rows, changes);
    for (int ping = 0; ping < log.size(); ping++) {
      ReadingDistribution expected = nominal.distribution(rows.get(log.row(ping)).pose());
      assertSame(expected, forecast.get(ping), setup, what + " ping " + ping);
    }
  }

  private static void assertSame(
      ReadingDistribution expected, ReadingDistribution found, SensingSetup setup, String what) {
    assertEquals(expected.noEchoProbability(), found.noEchoProbability(), 0, what);
    for (double range = -0.1; range < setup.sensor().maxRangeM() + 0.1; range += 0.0317) {
      assertEquals(expected.echoUpTo(range), found.echoUpTo(range), 0, what + " to " + range);
    }
    for (double level = 0.05; level < 0.96; level += 0.1) {
      assertEquals(
          expected.quantileM(level, setup.noEchoM()),
          found.quantileM(level, setup.noEchoM()),
          what);
    }
  }

  private static List<ReadingRow> rows(String golden, SensingSetup setup)
      throws DataFormatException {
    return Logs.rows(golden, setup, new Random(golden.hashCode()));
  }

  @ParameterizedTest
  @ValueSource(strings = {"p000", "step-edge", "table36-turned", "two", "uniform"})
  void everyForm_atNeutral(String golden) throws DataFormatException {
    SensingSetup setup = Logs.setup(golden);
    List<ReadingRow> rows = rows(golden, setup);
    List<Form> forms = Logs.forms(setup, SENSORS);
    assertTrue(forms.size() > 50, forms.toString());
    for (Form form : forms) {
      assertNominal(setup, rows, List.of(form.with(form.neutral())), form.toString());
    }
  }

  @Property(tries = 40, seed = "4")
  void anySetOfForms_atNeutral(@ForAll long seed) throws DataFormatException {
    Random random = new Random(seed);
    String golden = List.of("p009", "two", "uniform").get(random.nextInt(3));
    SensingSetup setup = Logs.setup(golden);
    List<Change> changes = new ArrayList<>();
    List<Form> forms = new ArrayList<>();
    for (Form form : Logs.forms(setup, SENSORS)) {
      if (random.nextInt(4) == 0) {
        forms.add(form);
        changes.add(random.nextInt(changes.size() + 1), form.with(form.neutral()));
      }
    }
    assertNominal(setup, rows(golden, setup), changes, forms.toString());
  }

  @ParameterizedTest
  @ValueSource(strings = {"p018", "p027", "two", "table36-turned"})
  void withoutChanges_likelihood_isTheNominalProbability(String golden) throws DataFormatException {
    SensingSetup setup = Logs.setup(golden);
    List<ReadingRow> rows = rows(golden, setup);
    NominalModel nominal = new NominalModel(setup.sensor(), setup.scene());
    PingLog log = new PingLog(rows);
    double[] found = Logs.likelihood(setup, rows, List.of());
    int echoes = 0;
    for (int ping = 0; ping < found.length; ping++) {
      ReadingRow row = rows.get(log.row(ping));
      ReadingDistribution expected = nominal.distribution(row.pose());
      double probability =
          row.reading() instanceof Echo echo
              ? expected.probabilityOfStep(echo.rangeM())
              : expected.noEchoProbability();
      echoes += row.reading() instanceof Echo ? 1 : 0;
      assertEquals(probability, found[ping], 1e-10, "ping " + ping);
    }
    assertTrue(echoes > 5, "echoes of " + golden + ": " + echoes);
  }

  @Test
  void neutral_isInItsInterval_orOutsideAllOfIt() throws DataFormatException {
    for (Form form : Logs.forms(Logs.setup("two"), SENSORS)) {
      for (Parameter parameter : form.parameters()) {
        assertTrue(parameter.low() < parameter.high(), form + " " + parameter);
        assertTrue(Double.isFinite(parameter.low()) && Double.isFinite(parameter.high()));
        parameter.tries().forEach(value -> assertEquals(value, parameter.clamp(value)));
      }
    }
  }
}
