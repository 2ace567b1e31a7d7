package simbad.figures.page;

import java.math.BigDecimal;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.check.Checks;

/**
 * A linear axis from round number to round number.
 *
 * @param low at its begin
 * @param high at its end, above low
 * @param step between its ticks: 1, 2 or 5 times a power of ten
 */
public record AxisScale(double low, double high, double step) implements ChartAxis {
  /** Checks the ends and the step. */
  public AxisScale {
    Checks.finite("low", low);
    Checks.above("high", high, low);
    Checks.positive("step", step);
  }

  private static final double[] ROUND = {1, 2, 5, 10};

  /**
   * Covers an interval; an empty one becomes one step.
   *
   * @param low its begin
   * @param high its end
   * @param ticks about how many there shall be
   */
  public static AxisScale over(double low, double high, int ticks) {
    Checks.finite("low", low);
    Checks.finite("high", high);
    double step = roundStep((high - low) / ticks);
    double from = Math.floor(low / step + 1e-9) * step;
    double to = Math.ceil(high / step - 1e-9) * step;
    return new AxisScale(from, to > from ? to : from + step, step);
  }

  /** Returns the least round step that is not below a size. */
  public static double roundStep(double size) {
    if (!(size > 0)) {
      return 1;
    }
    double power = Math.pow(10, Math.floor(Math.log10(size)));
    for (double factor : ROUND) {
      if (factor * power >= size * (1 - 1e-9)) {
        return factor * power;
      }
    }
    return 10 * power;
  }

  @Override
  public double share(double value) {
    return (value - low) / (high - low);
  }

  /** Returns the ticks, begin and end included. */
  @Override
  public List<Double> ticks() {
    List<Double> ticks = new ArrayList<>();
    for (int i = 0; low + i * step <= high + step * 1e-6; i++) {
      ticks.add(low + i * step);
    }
    return ticks;
  }

  /** Returns a tick as text, with as many decimals as the step needs and a true minus. */
  @Override
  public String label(double tick) {
    int decimals = Math.max(0, (int) Math.ceil(-Math.log10(step) - 1e-9));
    BigDecimal rounded = new BigDecimal(tick).setScale(decimals, java.math.RoundingMode.HALF_EVEN);
    String text = rounded.signum() == 0 ? "0" : rounded.toPlainString();
    return text.replace('-', '\u2212');
  }
}
