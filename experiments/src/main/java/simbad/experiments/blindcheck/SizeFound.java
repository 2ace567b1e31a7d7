package simbad.experiments.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.sonar.check.Checks;

/**
 * From which size on an effect is found. Sizes are in units of a practical one.
 *
 * @param effect its name
 * @param right cases with this effect alone in which it was found
 * @param cases with this effect alone
 * @param least size that was put in
 * @param greatest size that was put in
 * @param half the size that is found in 50 of 100
 * @param most the size that is found in 90 of 100
 * @param below cases below the first size that were wrongly explained, of how many
 * @param above the same above it
 */
public record SizeFound(
    String effect,
    int right,
    int cases,
    double least,
    double greatest,
    Estimate half,
    Estimate most,
    String below,
    String above) {
  /** Checks that sizes are numbers. */
  public SizeFound {
    Checks.number("least", least);
    Checks.number("greatest", greatest);
  }

  static final List<String> FIELDS =
      List.of(
          "effect",
          "right",
          "cases",
          "size_50",
          "size_50_low95",
          "size_50_high95",
          "size_90",
          "size_90_low95",
          "size_90_high95",
          "wrongly_explained_below",
          "wrongly_explained_above");

  /** Returns the effects of which enough cases were answered, by name. */
  public static List<SizeFound> of(Figures figures) {
    return StreamSupport.stream(figures.figures().path("sizes").spliterator(), false)
        .map(SizeFound::of)
        .toList();
  }

  private static SizeFound of(JsonNode line) {
    return new SizeFound(
        line.path("effect").asText(),
        line.path("right").path("hits").asInt(),
        line.path("right").path("of").asInt(),
        line.path("least").asDouble(),
        line.path("greatest").asDouble(),
        size(line, "size_50"),
        size(line, "size_90"),
        counted(line.path("wrongly_explained_below")),
        counted(line.path("wrongly_explained_above")));
  }

  private static Estimate size(JsonNode line, String name) {
    JsonNode interval = line.path(name + "_ci95");
    return new Estimate(
        line.path(name).asDouble(), interval.path(0).asDouble(), interval.path(1).asDouble(), "");
  }

  private static String counted(JsonNode share) {
    return share.path("hits").asInt() + " of " + share.path("of").asInt();
  }

  List<String> fields() {
    return Stream.of(
            effect,
            right,
            cases,
            half.value(),
            half.low(),
            half.high(),
            most.value(),
            most.low(),
            most.high(),
            below,
            above)
        .map(String::valueOf)
        .toList();
  }
}
