package simbad.gap.calibrate;

import java.util.Arrays;
import java.util.Optional;
import simbad.definition.Parameter;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;

/**
 * By how much a log under a set of effects would be likelier if the set-up moved as far as its
 * reference leaves open: 0 under the threshold rule.
 */
public final class SetupLeave {
  /** A form of more values has places or a table, which no parabola follows. */
  private static final int MOST_VALUES = 3;

  /** Steps of a value: shares of what it is away from nothing, or of its interval. */
  private static final double STEP_SHARE = 0.12;

  private static final double INTERVAL_SHARE = 0.02;

  /** A parabola is trusted no further. */
  private static final double MOST_STEPS = 3;

  private final CalibratedLog given;
  private final Calibration calibration;

  /**
   * Asks a calibration.
   *
   * @param given the log before it
   * @param calibration of the set-up
   */
  public SetupLeave(CalibratedLog given, Calibration calibration) {
    this.given = given;
    this.calibration = calibration;
  }

  /** Returns how far the set-up may move; none under the threshold rule. */
  public Optional<Leeway> leeway() {
    return calibration.leeway();
  }

  /** Returns the nats for a set whose values stay as they are. */
  public double nats(Hypothesis set) {
    return calibration.leewayNats(given, set);
  }

  /**
   * Returns the nats for a set whose values move as well: they were fitted before a set-up that
   * stood still. One step of each value in turn, by a parabola.
   */
  public double natsWithValues(Hypothesis set) {
    Together start = together(set);
    double here = start.nats();
    if (calibration.leeway().isPresent()) {
      Hypothesis best = set;
      for (int form = 0, at = 0; form < set.forms().size(); form++) {
        int size = set.forms().get(form).parameters().size();
        for (int i = at; i < at + size && size <= MOST_VALUES; i++) {
          Hypothesis moved = stepped(best, i, here);
          double there = moved.equals(best) ? here : together(moved).nats();
          best = there > here ? moved : best;
          here = Math.max(here, there);
        }
        at += size;
      }
    }
    return here - start.alone;
  }

  private Hypothesis stepped(Hypothesis set, int value, double here) {
    Parameter parameter = set.parameters().get(value);
    double own = set.values()[value];
    double step = step(parameter, own);
    double room = Math.min(own - parameter.low(), parameter.high() - own);
    if (!(step > 0) || room < step) {
      return set;
    }
    double up = together(moved(set, value, own + step)).nats();
    double down = together(moved(set, value, own - step)).nats();
    double bend = up + down - 2 * here;
    double steps = bend < 0 ? (down - up) / (2 * bend) : Math.signum(up - down) * MOST_STEPS;
    double most = Math.min(MOST_STEPS, room / step);
    return moved(set, value, own + step * Math.max(-most, Math.min(most, steps)));
  }

  private static double step(Parameter parameter, double own) {
    double away = Math.abs(own - parameter.neutral());
    return Double.isFinite(away) && away > 0
        ? STEP_SHARE * away
        : INTERVAL_SHARE * (parameter.high() - parameter.low());
  }

  private static Hypothesis moved(Hypothesis set, int value, double to) {
    double[] values = set.values();
    values[value] = to;
    return set.with(values);
  }

  /**
   * How likely a log is under a set of effects.
   *
   * @param alone before the set-up as it is, natural
   * @param moved by how much more before one that moves
   */
  private record Together(double alone, double moved) {
    double nats() {
      return alone + moved;
    }
  }

  private Together together(Hypothesis set) {
    Optional<Leeway> open = calibration.leeway();
    if (open.isEmpty()) {
      return new Together(sum(given.logLikelihood(set)), 0);
    }
    // Both look from the same places: to find what is seen from them takes as long as the rest.
    SetupMove move = new SetupMove(open.get(), given, set);
    double alone = sum(given.logLikelihood(set.changes(), move.geometry()));
    return new Together(alone, move.nats(move.levels()));
  }

  private static double sum(double[] logLikelihood) {
    return Arrays.stream(logLikelihood).sum();
  }
}
