package simbad.cli;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;

/** {@code simbad effects}: what a diagnosis can name. */
@Command(
    name = "effects",
    description = {
      "List the effects that a diagnosis can name, a line for each: first those of a "
          + "sensor, then those of a robot's motion.",
      "With names, explain these: what happens, what causes it (for a sensor's effects), "
          + "and the forms with their parameters.",
      "A form is a formula for how the effect acts; at its neutral values it changes "
          + "nothing. The forms shown are those for one SRF04 and one obstacle. Jars on "
          + "the class path can bring more effects."
    },
    footer = {
      "",
      "Example: simbad effects",
      "Example: simbad effects gain early-timeout",
      "Example: simbad effects turn-bias",
      "More on motion: docs/guide/motion.md. An effect of your own: docs/guide/own-effect.md"
    })
final class EffectsCommand extends Subcommand {
  private static final List<String> SENSORS = List.of("sonar");
  private static final double UNIFORM_M = 2.5;

  @Parameters(
      paramLabel = "EFFECT",
      arity = "0..*",
      completionCandidates = EffectWords.class,
      description = "Effects to explain. Default: list all.")
  private List<String> words = List.of();

  @Override
  protected void run() {
    if (words.isEmpty()) {
      Definitions.all().forEach(one -> list(one.effect().word(), one.happens()));
      out().println();
      out().println("Effects of a robot's motion:");
      MotionForms.vocabulary().forEach(word -> list(word, MotionForms.happens(word)));
    }
    List<Runnable> answers = words.stream().map(this::answer).toList();
    answers.forEach(Runnable::run);
  }

  /** All names are looked up before anything is printed. */
  private Runnable answer(String word) {
    Optional<Effect> effect = Definitions.find(word);
    if (effect.isEmpty() && MotionForms.vocabulary().contains(word)) {
      return () -> explainMotion(word);
    }
    Definition definition = Definitions.of(effect.orElseThrow(() -> unknown(word)));
    return () -> explain(definition);
  }

  private RuntimeException unknown(String word) {
    List<String> known = new ArrayList<>(MotionForms.vocabulary());
    Definitions.effects().forEach(effect -> known.add(effect.word()));
    return wrongUsage(
        "EFFECT: '"
            + word
            + "' is not the name of an effect; simbad effects lists them"
            + SimilarWords.suggestion(word, known));
  }

  private void list(String word, String happens) {
    out().printf(Locale.ROOT, "%-20s %s%n", word, happens);
  }

  private void explainMotion(String word) {
    out().println(word + ": " + MotionForms.happens(word));
    MotionForms.ALL.stream()
        .filter(form -> form.effect().equals(word))
        .forEach(form -> out().println("  form " + text(form)));
  }

  private static String text(MotionForm form) {
    return form.parameters().stream()
        .map(one -> text(one.name(), one.low(), one.high(), one.neutral()))
        .collect(Collectors.joining("; ", form.form() + ": ", ""));
  }

  private void explain(Definition definition) {
    out().println(definition.effect() + ": " + definition.happens());
    out().println("  cause: " + definition.cause());
    SensingSetup setup = setup();
    List<Form> forms = definition.forms(setup, SENSORS);
    forms.forEach(form -> out().println("  form " + text(form)));
    definition.levelForms(setup, SENSORS).stream()
        .filter(form -> !forms.contains(form))
        .forEach(form -> out().println("  form of the level model " + text(form)));
  }

  private static String text(Form form) {
    List<Parameter> first = form.parameters().subList(0, Math.min(form.parameters().size(), 6));
    String shown = first.stream().map(EffectsCommand::text).collect(Collectors.joining("; "));
    int more = form.parameters().size() - first.size();
    return form.name() + ": " + shown + (more > 0 ? "; and " + more + " more" : "");
  }

  private static String text(Parameter parameter) {
    return text(parameter.name(), parameter.low(), parameter.high(), parameter.neutral());
  }

  private static String text(String name, double low, double high, double neutral) {
    return name + " " + text(low) + " to " + text(high) + ", neutral at " + text(neutral);
  }

  private static String text(double value) {
    return Double.isInfinite(value)
        ? "infinity"
        : new DecimalFormat("0.####", DecimalFormatSymbols.getInstance(Locale.ROOT)).format(value);
  }

  private static SensingSetup setup() {
    SonarSpec sensor = Catalogue.srf04();
    ObstacleType square = Catalogue.find("square").orElseThrow();
    Obstacle obstacle =
        new Obstacle(
            "obstacle", new Placement(0, 0, 0), square.outline(), new UniformDetection(UNIFORM_M));
    return new SensingSetup(sensor, new Scene(List.of(obstacle)), sensor.maxRangeM());
  }
}
