package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * What happens now and then: steps that are far off. A wheel that slips makes the way shorter, or
 * the turn less; what makes it longer as often is something else. What is off in that component
 * whose command has just changed may only have come at an unsteady moment.
 *
 * @param shorter times that less way or less turn was made than expected
 * @param late times that something was off just as its own command had changed
 * @param other times that more was made, or that it turned without being told
 * @param slips the stretches of those that are shorter
 * @param heavy mean square of all steps, in units of what their median says; 1 of Gaussian ones
 */
record Events(int shorter, int late, int other, List<MotionSteps.Stretch> slips, double heavy) {
  /** Of Gaussian steps one in 400,000 is farther off. */
  private static final double FAR = 4.7;

  /** What follows within this time belongs to the same event. */
  private static final double ONE_EVENT_S = 1.2;

  /** Longer than what is late by an unsteady time; what is off for longer is something else. */
  private static final double CHANGED_S = 0.8;

  private static final int ALONG = 0;
  private static final int TURN = 2;

  static Events of(MotionSteps given, MotionFit fit) {
    double[][] expected = given.expected(fit.hypothesis().chain());
    double[][] white = new double[MotionSteps.COMPONENTS][];
    for (int c = 0; c < white.length; c++) {
      white[c] = scaled(new Whitening(given, fit.noises()[c], fit.residuals()[c]).white);
    }
    List<Event> events = new ArrayList<>();
    for (int i = 0; i < given.size(); i++) {
      if (Math.abs(white[ALONG][i]) <= FAR && Math.abs(white[TURN][i]) <= FAR) {
        continue;
      }
      MotionSteps.Step step = given.step(i);
      int last = events.size() - 1;
      if (last >= 0 && events.get(last).goesOnIn(step)) {
        events.set(last, events.get(last).until(step));
      } else {
        events.add(
            new Event(
                kind(given, i, white, expected),
                new MotionSteps.Stretch(
                    step.run(), step.from().timeS(), step.to().timeS() + ONE_EVENT_S)));
      }
    }
    return new Events(
        count(events, Kind.SHORTER),
        count(events, Kind.LATE),
        count(events, Kind.OTHER),
        events.stream().filter(one -> one.kind == Kind.SHORTER).map(Event::stretch).toList(),
        Math.max(meanSquare(white[ALONG]), meanSquare(white[TURN])));
  }

  private static double meanSquare(double[] white) {
    return Arrays.stream(white).map(z -> z * z).average().orElse(1);
  }

  private static int count(List<Event> events, Kind kind) {
    return (int) events.stream().filter(one -> one.kind == kind).count();
  }

  private record Event(Kind kind, MotionSteps.Stretch stretch) {
    boolean goesOnIn(MotionSteps.Step step) {
      return stretch.meets(step.run(), step.from().timeS(), step.to().timeS());
    }

    Event until(MotionSteps.Step step) {
      boolean lasts = step.to().timeS() - stretch.fromS() > CHANGED_S;
      return new Event(
          kind == Kind.LATE && lasts ? Kind.OTHER : kind,
          new MotionSteps.Stretch(stretch.run(), stretch.fromS(), step.to().timeS() + ONE_EVENT_S));
    }
  }

  private enum Kind {
    SHORTER,
    LATE,
    OTHER
  }

  private static Kind kind(MotionSteps given, int i, double[][] white, double[][] expected) {
    boolean turns = Math.abs(white[ALONG][i]) <= FAR;
    int component = turns ? TURN : ALONG;
    if (white[component][i] * Math.signum(expected[component][i]) < -FAR) {
      return Kind.SHORTER;
    }
    return hasChanged(given, given.step(i), turns) ? Kind.LATE : Kind.OTHER;
  }

  /** Tells whether the command of the turn, or of the speed, changed shortly before or within. */
  private static boolean hasChanged(MotionSteps given, MotionSteps.Step step, boolean turns) {
    return CommandTrail.changed(
            given.runs().get(step.run()).commands(),
            turns,
            step.from().timeS() - CHANGED_S,
            step.to().timeS())
        > 0;
  }

  /** In units in which most of them are standard normal. */
  private static double[] scaled(double[] white) {
    double[] sizes = Arrays.stream(white).map(Math::abs).sorted().toArray();
    double scale = sizes.length == 0 ? 1 : sizes[sizes.length / 2] / NormalChance.MEDIAN;
    return Arrays.stream(white).map(z -> z / scale).toArray();
  }
}
