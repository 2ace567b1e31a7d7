package simbad.figures.plot;

import java.util.List;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import simbad.sonar.check.Checks;

/**
 * The error axis, in centimetres.
 *
 * @param isLog whether the axis is logarithmic
 * @param bottomCm where it begins
 * @param topCm where it ends
 * @param isClamped whether errors below the bottom are drawn on it
 */
public record ErrorScale(boolean isLog, double bottomCm, double topCm, boolean isClamped) {
  /** Checks the ends. */
  public ErrorScale {
    Checks.finite("bottomCm", bottomCm);
    Checks.atLeast("topCm", topCm, bottomCm);
  }

  /** A tenth of a millimetre: what lies below is nought to any sonar. */
  private static final double LEAST_LOG_CM = 0.01;

  /** Where the largest error is this many times the least, a linear axis would hide the least. */
  private static final double LOG_RATIO = 20;

  /** From this ratio of top to bottom on, labels at 2 and 5 would crowd. */
  private static final double WIDE = 1000;

  private static final int TICKS = 6;

  /**
   * Returns the scale that suits a set of errors; 0 to 1 cm where there are none.
   *
   * @param errorsCm at least 0
   */
  public static ErrorScale of(double... errorsCm) {
    Checks.numbers("errorsCm", errorsCm);
    double largest = DoubleStream.of(errorsCm).max().orElse(0);
    double least = DoubleStream.of(errorsCm).filter(e -> e > 0).min().orElse(largest);
    double bottom = Math.max(LEAST_LOG_CM, least);
    return largest > LOG_RATIO * bottom ? log(bottom, largest, errorsCm) : linear(largest);
  }

  private static ErrorScale log(double bottom, double largest, double... errorsCm) {
    double bottomCm = Steps.roundDown(bottom);
    boolean isClamped = DoubleStream.of(errorsCm).anyMatch(e -> e < bottomCm);
    return new ErrorScale(true, bottomCm, Steps.roundUp(largest * 1.1), isClamped);
  }

  private static ErrorScale linear(double largest) {
    double reach = largest > 0 ? largest * 1.05 : 1;
    double step = Steps.step(reach, TICKS);
    return new ErrorScale(false, 0, step * Steps.count(reach, step), false);
  }

  /** Returns where an error is drawn: not below the axis. */
  public double clamped(double errorCm) {
    return Math.max(bottomCm, errorCm);
  }

  /** Returns the error that lies at a share of the axis's length. */
  double at(double share) {
    return isLog
        ? bottomCm * Math.pow(topCm / bottomCm, share)
        : bottomCm + share * (topCm - bottomCm);
  }

  /** Returns where labels stand. */
  public List<Double> ticks() {
    if (!isLog) {
      return Steps.multiples(0, topCm, Steps.step(topCm, TICKS));
    }
    List<Double> decades = topCm / bottomCm > WIDE ? decades(1) : decades(1, 2, 5);
    // The bottom has a label in any case, as values may be drawn there that lie below.
    return Stream.concat(Stream.of(bottomCm), decades.stream()).distinct().toList();
  }

  /** Returns the label at a tick: the bottom one says when less is drawn there. */
  public String label(double cm) {
    return (isClamped && cm == bottomCm ? "≤" : "") + Steps.label(cm);
  }

  /** Where faint lines help the eye between the labels. */
  List<Double> fineLines() {
    return isLog ? decades(1, 2, 3, 4, 5, 6, 7, 8, 9) : List.of();
  }

  private List<Double> decades(double... digits) {
    int first = (int) Math.floor(Math.log10(bottomCm));
    int last = (int) Math.ceil(Math.log10(topCm));
    return IntStream.rangeClosed(first, last)
        .boxed()
        .flatMap(k -> DoubleStream.of(digits).map(d -> Steps.clean(d * Math.pow(10, k))).boxed())
        .filter(v -> v >= bottomCm * 0.999 && v <= topCm * 1.001)
        .toList();
  }
}
