package simbad.figures.blindcheck;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.function.Predicate;
import simbad.experiments.blindcheck.Calibration;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.figures.plot.AgreementPlot;
import simbad.figures.plot.AgreementPoint;
import simbad.figures.plot.Caption;
import simbad.figures.plot.Figure;

/** The pictures of a check. */
final class CheckFigures {
  private static final double SHRINK_STEP = 0.2;
  private static final double LEAST_SHRINK = -1;

  private CheckFigures() {}

  /** The reliability diagram of the verdict's probability. */
  static Figure verdict(Figures figures) {
    return reliability(
        "Probability of the verdict", figures, figures.calibration("verdict_calibration"));
  }

  /** The reliability diagram of the first effect's probability. */
  static Figure firstEffect(Figures figures) {
    return reliability(
        "Probability of the effect listed first",
        figures,
        figures.calibration("first_named_calibration"));
  }

  private static Figure reliability(String title, Figures figures, Calibration calibration) {
    List<AgreementPoint> points =
        calibration.bins().stream()
            .map(
                bin ->
                    new AgreementPoint(
                        bin.stated(), bin.share(), bin.low(), bin.high(), bin.of() + ""))
            .toList();
    return new AgreementPlot(
            new Caption(title, figures.part() + "; n = " + calibration.claims()),
            new AgreementPlot.Axes("probability stated", "share that was so", 0, 1),
            "cases of like probability, their number, 95 % interval",
            points)
        .figure();
  }

  /**
   * Claimed and sealed shrinkage of each case.
   *
   * @param part of the cases, for the caption
   * @param cases those that the plot shall show
   */
  static Figure shrinkage(String part, List<JsonNode> cases) {
    List<AgreementPoint> points =
        cases.stream()
            .filter(has("shrink_claimed").and(has("shrink_sealed")))
            .map(
                one ->
                    AgreementPoint.of(
                        one.path("shrink_claimed").asDouble(),
                        one.path("shrink_sealed").asDouble()))
            .toList();
    double least =
        points.stream()
            .mapToDouble(point -> Math.min(point.claimed(), point.found()))
            .map(value -> SHRINK_STEP * Math.floor(value / SHRINK_STEP))
            .min()
            .orElse(0);
    return new AgreementPlot(
            new Caption("Shrinkage of the gap", part + "; n = " + points.size()),
            new AgreementPlot.Axes(
                "shrinkage claimed",
                "shrinkage on the sealed rows",
                Math.max(LEAST_SHRINK, Math.min(0, least)),
                1),
            "cases with something named or left unexplained",
            points)
        .figure();
  }

  private static Predicate<JsonNode> has(String name) {
    return one -> one.has(name) && !one.path("verdict").asText().equals("none");
  }
}
