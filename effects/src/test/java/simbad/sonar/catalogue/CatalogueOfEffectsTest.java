package simbad.sonar.catalogue;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
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
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** What every definition owes those who read it. */
class CatalogueOfEffectsTest {
  private static final List<String> SENSORS = List.of("left", "right");
  private static final SonarSpec SENSOR =
      new SonarSpec("test", Math.toRadians(20), 0.03, 4, 0.15, 343, 0.01, 0.004, 0.005, 0.02, 0.05);
  private static final SensingSetup SETUP =
      new SensingSetup(SENSOR, new Scene(List.of(post("one", 0), post("two", 1))), 4);

  private static Obstacle post(String name, double xM) {
    Outline square =
        Outline.of(
            List.of(
                new Point(0.01, 0.01),
                new Point(0.01, -0.01),
                new Point(-0.01, -0.01),
                new Point(-0.01, 0.01)));
    return new Obstacle(name, new Placement(xM, 0, 0), square, new UniformDetection(2));
  }

  static List<Definition> definitions() {
    return Definitions.all();
  }

  /** In the order of the constants, which is that of all results. */
  @Test
  void vocabulary_isThatOfTheProject_inItsOrder() {
    assertEquals(33, Definitions.all().size());
    assertEquals(Effect.SOUND_SPEED, Definitions.effects().get(0));
    assertEquals(Effect.GAIN, Definitions.effects().get(7));
    assertEquals(Effect.WAVE_HOP, Definitions.effects().get(29));
    assertEquals(Effect.RANGE_DRIFT, Definitions.effects().get(32));
    assertEquals(List.copyOf(new TreeSet<>(Definitions.effects())), Definitions.effects());
  }

  @ParameterizedTest
  @MethodSource("definitions")
  void words_areSentencesWithoutAFullStop(Definition definition) {
    for (String words : List.of(definition.happens(), definition.briefly(), definition.cause())) {
      assertTrue(words.matches("[a-z].*[a-z0-9]"), definition.effect() + ": " + words);
      assertFalse(words.contains("|"), "a table shows it: " + words);
    }
    assertEquals(
        Definitions.all().size(),
        Definitions.all().stream().map(Definition::happens).distinct().count());
  }

  @ParameterizedTest
  @MethodSource("definitions")
  void forms_areOfTheEffect_underEitherLaw(Definition definition) {
    List<Form> forms = new ArrayList<>(definition.forms(SETUP, SENSORS));
    assertFalse(forms.isEmpty());
    assertEquals(forms.stream().distinct().toList(), forms);
    forms.addAll(definition.levelForms(SETUP, SENSORS));
    for (Form form : forms) {
      assertEquals(definition.effect(), form.effect());
      assertEquals(form, Forms.find(form.effect(), form.name(), SETUP, SENSORS).orElseThrow());
    }
  }

  @ParameterizedTest
  @MethodSource("definitions")
  void probes_areOfTheEffect(Definition definition) {
    PingLog log =
        new PingLog(List.of(new ReadingRow("r", "left", 0, Pose.of(-1, 0, 0), new Echo(0.9))));
    List<Probe> probes = definition.probes(SETUP, log);
    assertFalse(probes.isEmpty());
    for (Probe probe : probes) {
      assertEquals(definition.effect(), probe.form().effect());
    }
  }

  @ParameterizedTest
  @MethodSource("definitions")
  void remedy_hasTheNumbersOfEveryForm(Definition definition) {
    List<Form> forms = new ArrayList<>(definition.forms(SETUP, SENSORS));
    forms.addAll(definition.levelForms(SETUP, SENSORS));
    for (Form form : forms) {
      Map<String, Double> values = new HashMap<>();
      for (Parameter parameter : form.parameters()) {
        values.put(parameter.name(), parameter.high());
      }
      String remedy = definition.remedy(new FittedValues(values, SENSOR));
      assertFalse(remedy.isEmpty() || remedy.contains("NaN") || remedy.endsWith("."), remedy);
      assertTrue(
          manyOrNone(form) || remedy.chars().anyMatch(Character::isDigit),
          form.effect().word() + " " + form.name() + ": " + remedy);
    }
  }

  /** A table has no one number, nor has what no parameter tells. */
  private static boolean manyOrNone(Form form) {
    return form.parameters().size() > 5 || form.parameters().isEmpty();
  }

  /** What a definition of a jar has, which says no more than it must. */
  @Test
  void defaults_takeTheTriesOfTheFirstForm() {
    Effect effect = Effect.named("of-a-jar");
    Form form =
        Form.of(
            effect,
            "only",
            v -> Definitions.of(Effect.DROPOUT).forms(SETUP, SENSORS).get(0).with(v[0]),
            Parameter.of("share", 0, 0, 1, 0.3, 0.1),
            Parameter.of("other", 0, 0, 1, 0.5));
    Definition plain = new Plain(effect, form);
    assertEquals(plain.happens(), plain.briefly());
    assertEquals(List.of(form), plain.levelForms(SETUP, SENSORS));
    assertEquals(2, Tries.all(form).size());
    Probe probe = plain.probes(SETUP, new PingLog(List.of())).get(0);
    assertEquals(0.1, probe.practical());
    assertEquals(0.5, probe.others().get(0)[1]);
    assertTrue(plain.traits().isEmpty() && !plain.isWithinDays(form, 0, 0));
  }

  private record Plain(Effect effect, Form form) implements Definition {
    @Override
    public String happens() {
      return "nothing";
    }

    @Override
    public String cause() {
      return "nobody knows";
    }

    @Override
    public List<Form> forms(SensingSetup setup, List<String> sensors) {
      return List.of(form);
    }

    @Override
    public String remedy(FittedValues values) {
      return "wait";
    }
  }

  @Test
  void effectsOfJars_standBehindTheProjects_byName() {
    Effect jar = Effect.named("a-jar-brings-it");
    assertTrue(jar.compareTo(Effect.RANGE_DRIFT) > 0);
    assertTrue(jar.compareTo(Effect.named("another")) < 0);
    assertEquals(jar, Effect.named("a-jar-brings-it"));
    assertEquals(Effect.GAIN, Effect.named("gain"));
    assertTrue(Definitions.find("a-jar-brings-it").isEmpty(), "nothing defines it");
    assertThrows(IllegalArgumentException.class, () -> Definitions.of(jar));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "Gain", "slow ramp", "-a", "a-", "a--b", "1a", "gain/x"})
  void names_areWordsWithHyphens(String word) {
    assertThrows(IllegalArgumentException.class, () -> Effect.named(word));
  }
}
