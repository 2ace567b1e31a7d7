package simbad.experiments.blindcheck;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Function;
import java.util.stream.Stream;
import simbad.experiments.blindcheck.CheckScores.Estimate;
import simbad.experiments.blindcheck.CheckScores.Figures;
import simbad.sonar.check.Checks;

/**
 * One line of the scoring table.
 *
 * @param name of the csv files
 * @param words for people
 * @param unit in which it is shown
 * @param reach what is to be reached where the set-up is as believed; nothing where it is reported
 *     only
 * @param of the figures
 */
public record Measure(
    String name,
    String words,
    Unit unit,
    OptionalDouble reach,
    Function<Figures, Optional<Estimate>> of) {
  /** Checks what is to be reached. */
  public Measure {
    Checks.number("reach", reach);
  }

  /** How a figure is written, and whether more of it is better. */
  public enum Unit {
    /** Of cases that are answered rightly, shown in per cent; more is better. */
    SHARE,
    /** What is gained of what could be, shown in per cent; more is better. */
    GAIN,
    /** Of cases that are answered wrongly, shown in per cent; less is better. */
    FAULT,
    /** From 0 to 1; more is better. */
    AREA,
    /** From 0 to 1; less is better. */
    ERROR,
    /** Percentage points; less is better. */
    POINTS
  }

  /** With a set-up that is itself a little off nine tenths of each share are to be reached. */
  private static final double OFF_SHARE = 0.9;

  /** Those with a figure to reach, in the order of the issue, and what stands beside them. */
  public static final List<Measure> ALL =
      Stream.of(
              new Measure(
                  "mean of the classes",
                  "mean of the classes: right",
                  Unit.SHARE,
                  OptionalDouble.empty(),
                  Figures::classMean),
              new Measure(
                  "probability of the truth",
                  "mean probability given to the truth",
                  Unit.AREA,
                  OptionalDouble.empty(),
                  Figures::probabilityOfTruth),
              share("none called none", "no effect: called none", 39 / 40.0),
              share("singles named and explained", "one effect: explained, and named", 0.95),
              share("pairs both found and explained", "two effects: explained, both named", 0.8),
              share(
                  "outside called unexplained",
                  "outside the vocabulary: called unexplained",
                  7 / 8.0),
              share("withheld called unexplained", "withheld effect: called unexplained"),
              measure("unknown AUROC", "AUROC of unknown_probability", Unit.AREA, 0.95)
                  .from(Figures::auroc),
              measure("verdict ECE", "verdict: calibration error (ECE)", Unit.ERROR, 0.05)
                  .from(f -> f.calibration("verdict_calibration").error()),
              measure("verdict log score", "verdict: log score better by", Unit.GAIN, 0.6)
                  .from(Figures::verdictLogScore),
              measure("first effect ECE", "first effect: calibration error (ECE)", Unit.ERROR, 0.05)
                  .from(f -> f.calibration("first_named_calibration").error()),
              measure("first effect log score", "first effect: log score better by", Unit.GAIN, 0.6)
                  .from(f -> f.calibration("first_named_calibration").betterBy()),
              measure(
                      "shrink claimed vs sealed",
                      "shrinkage: claimed and sealed differ by (median)",
                      Unit.POINTS,
                      5)
                  .from(f -> f.median("shrink_claimed_minus_sealed_points")),
              measure(
                      "share of the true removal",
                      "share of the true model's removal (median)",
                      Unit.GAIN,
                      0.9)
                  .from(f -> f.median("share_of_oracle_removal")),
              share("parameter intervals cover", "parameters: 95 % intervals hold the true value"),
              share("parameter intervals of 90 % cover", "parameters: the same, narrowed to 90 %"),
              share("places larger on sealed rows", "places: more can go there on sealed rows"),
              share("all verdicts right", "all cases: verdict right"),
              fault("all wrongly explained", "all cases: wrongly explained"),
              share("all right", "all cases: right, by the table of verdicts"),
              fault("all cautious", "all cases: cautious, by the table"),
              fault("all wrong", "all cases: wrong, by the table"),
              share("singles called explained", "one effect: called explained"),
              share("singles detected", "one effect: not called none"),
              share("singles named exactly, of detected", "of these: named exactly"),
              share("singles family right, of detected", "of these: a name of the same stage"),
              share("singles truth in named set, of detected", "of these: among names and ties"),
              share("pairs called explained", "two effects: called explained"),
              share("pairs both found", "two effects: both named, whatever the verdict"),
              share("pairs at least one found", "two effects: at least one named"),
              share("unknown flagged at 5 % false", "unknown: flagged where 5 % of known are"),
              share("none without a place", "no effect: no place of the gap is told"),
              share("shrinkage interval covers", "shrinkage: claimed interval holds the sealed"),
              share("answered", "answered"))
          .toList();

  /** How many of {@link #ALL} stand on the first screen. */
  public static final int FIRST = 22;

  private static Measure share(String name, String words, double reach) {
    return measure(name, words, Unit.SHARE, reach).from(figures -> figures.share(name));
  }

  private static Measure share(String name, String words) {
    return new Measure(
        name, words, Unit.SHARE, OptionalDouble.empty(), figures -> figures.share(name));
  }

  private static Measure fault(String name, String words) {
    return new Measure(
        name, words, Unit.FAULT, OptionalDouble.empty(), figures -> figures.share(name));
  }

  /** A measure that still lacks where its figure stands. */
  private record Begun(String name, String words, Unit unit, double reach) {
    Measure from(Function<Figures, Optional<Estimate>> of) {
      return new Measure(name, words, unit, OptionalDouble.of(reach), of);
    }
  }

  private static Begun measure(String name, String words, Unit unit, double reach) {
    return new Begun(name, words, unit, reach);
  }

  /** True when less is better. */
  public boolean isCost() {
    return unit == Unit.ERROR || unit == Unit.POINTS || unit == Unit.FAULT;
  }

  /** What is to be reached; shares of right answers are a tenth less with a set-up that is off. */
  public OptionalDouble reach(boolean off) {
    boolean lowered = off && (unit == Unit.SHARE || unit == Unit.AREA);
    return reach.isPresent() && lowered
        ? OptionalDouble.of(OFF_SHARE * reach.getAsDouble())
        : reach;
  }

  /** A figure in this measure's unit, without it. */
  public String number(double value) {
    return switch (unit) {
      case SHARE, FAULT, GAIN -> fixed(100 * value, 0);
      case AREA, ERROR -> fixed(value, 3);
      case POINTS -> fixed(value, 1);
    };
  }

  /** The figure with its unit. */
  public String text(double value) {
    return number(value)
        + switch (unit) {
          case SHARE, FAULT, GAIN -> "\u00a0%";
          case POINTS -> "\u00a0points";
          case AREA, ERROR -> "";
        };
  }

  /** A share in per cent, without decimals. */
  public static String percent(double share) {
    return fixed(100 * share, 0) + "\u00a0%";
  }

  private static String fixed(double value, int decimals) {
    BigDecimal rounded =
        new BigDecimal(Double.toString(value)).setScale(decimals, RoundingMode.HALF_UP);
    String text = rounded.signum() == 0 ? rounded.abs().toPlainString() : rounded.toPlainString();
    return text.replace('-', '\u2212');
  }
}
