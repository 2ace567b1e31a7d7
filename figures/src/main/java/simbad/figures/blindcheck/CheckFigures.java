package simbad.figures.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.function.Predicate;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.experiments.blindcheck.StatedProbabilities;
import simbad.figures.page.Numbers;
import simbad.figures.page.PagePicture;
import simbad.figures.page.Svg.Spot;
import simbad.figures.page.Table;

/** The pictures of a check. */
final class CheckFigures {
  private static final double SHRINK_STEP = 0.2;
  private static final double LEAST_SHRINK = -1;

  private CheckFigures() {}

  /** The reliability diagram of the verdict's probability. */
  static PagePicture verdict(Figures figures) {
    return reliability(
        "Probability of the verdict", figures, figures.calibration("verdict_calibration"));
  }

  /** The reliability diagram of the first effect's probability. */
  static PagePicture firstEffect(Figures figures) {
    return reliability(
        "Probability of the effect listed first",
        figures,
        figures.calibration("first_named_calibration"));
  }

  private static PagePicture reliability(
      String title, Figures figures, StatedProbabilities calibration) {
    String words = title + "; " + figures.part() + "; n = " + calibration.claims();
    AgreementGraph graph =
        new AgreementGraph(words, "probability stated", "share that was true", 0);
    Table table = Table.of("#stated", "#cases", "#so", "#share", "#95\u00a0% interval");
    for (StatedProbabilities.Bin bin : calibration.bins()) {
      String interval = Numbers.percent(bin.low()) + " to " + Numbers.percent(bin.high());
      String stated = Numbers.percent(bin.stated(), 1);
      graph.group(
          bin.stated(),
          bin.share(),
          bin.low(),
          bin.high(),
          "stated " + stated + ": " + bin.hits() + " of " + bin.of() + " were so, " + interval);
      table.row(stated, bin.of(), bin.hits(), Numbers.percent(bin.share()), interval);
    }
    return new PagePicture(
            title,
            graph.html(),
            figures.part()
                + "; n = "
                + calibration.claims()
                + ". Each point is a group of cases with similar probability; bars are 95\u00a0% "
                + "intervals.")
        .with("As a table", table);
  }

  /**
   * Claimed and sealed shrinkage of each case.
   *
   * @param part of the cases, for the caption
   * @param cases those that the plot shall show
   */
  static PagePicture shrinkage(String part, List<JsonNode> cases) {
    List<Spot> claims =
        cases.stream()
            .filter(has("shrink_claimed").and(has("shrink_sealed")))
            .map(
                one ->
                    new Spot(
                        one.path("shrink_claimed").asDouble(),
                        one.path("shrink_sealed").asDouble()))
            .toList();
    String words = part + "; n = " + claims.size();
    AgreementGraph graph =
        new AgreementGraph(
            "Shrinkage of the gap; " + words,
            "shrinkage claimed",
            "shrinkage on the sealed rows",
            least(claims));
    graph.cloud(claims, claims.size() + " cases");
    return new PagePicture(
        "Shrinkage of the gap",
        graph.html(),
        words + ". Only cases with a named effect, or with a gap that is unexplained.");
  }

  private static double least(List<Spot> claims) {
    double least =
        claims.stream()
            .mapToDouble(claim -> Math.min(claim.x(), claim.y()))
            .map(value -> SHRINK_STEP * Math.floor(value / SHRINK_STEP))
            .min()
            .orElse(0);
    return Math.max(LEAST_SHRINK, Math.min(0, least));
  }

  private static Predicate<JsonNode> has(String name) {
    return one -> one.has(name) && !one.path("verdict").asText().equals("none");
  }
}
