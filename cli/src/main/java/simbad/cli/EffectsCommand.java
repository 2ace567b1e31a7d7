package simbad.cli;

import java.text.DecimalFormat;
import java.text.DecimalFormatSymbols;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;
import simbad.definition.Effect;
import simbad.definition.Parameter;
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
      "List the effects of a sensor that a diagnosis can name: a line for each.",
      "With names, explain these: what happens, what causes it, and the forms with "
          + "their parameters.",
      "A form is a formula for how the effect acts; at its neutral values it changes "
          + "nothing. The forms shown are those for one SRF04 and one obstacle. Jars on "
          + "the class path can bring more effects."
    },
    footer = {
      "",
      "Example: simbad effects",
      "Example: simbad effects gain early-timeout",
      "Effects of a robot's motion: docs/guide/motion.md. An effect of your own: "
          + "docs/guide/own-effect.md"
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
    List<Definition> asked = new ArrayList<>();
    for (String word : words) {
      asked.add(Definitions.of(Definitions.find(word).orElseThrow(() -> unknown(word))));
    }
    if (asked.isEmpty()) {
      Definitions.all().forEach(this::list);
    }
    asked.forEach(this::explain);
  }

  private RuntimeException unknown(String word) {
    List<String> known = Definitions.effects().stream().map(Effect::word).toList();
    return wrongUsage(
        "'" + word + "' is not the name of an effect" + SimilarWords.suggestion(word, known));
  }

  private void list(Definition definition) {
    out().printf(Locale.ROOT, "%-20s %s%n", definition.effect(), definition.happens());
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
    return parameter.name()
        + " "
        + text(parameter.low())
        + " to "
        + text(parameter.high())
        + ", neutral at "
        + text(parameter.neutral());
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
