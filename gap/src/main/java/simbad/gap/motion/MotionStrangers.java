package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

/**
 * What has no name and leaves a trace: plain regressions of what an explanation leaves over on
 * time, heading, size and the commands of the last second. What they foretell of left-out blocks
 * has a cause that is not named.
 */
final class MotionStrangers {
  private static final int LAGS = 6;
  private static final double LAG_S = 0.2;
  private static final double RIDGE = 1e-3;

  /** What loses more with the noise as it was gains nothing with another. */
  private static final double HOPELESS_NATS = -5;

  /** The smallest and largest wheel that is looked for, as the way of a turn, and how finely. */
  private static final double SHORTEST_M = 0.06;

  private static final double LONGEST_M = 1.6;
  private static final double FINE = 1.002;

  /** The best of so many lengths gains by chance what so many values do: twice their logarithm. */
  private static final int SCANNED = 16;

  private final MotionSteps given;
  private final ScoredMotion best;
  private final double[][] expected;

  MotionStrangers(MotionSteps given, ScoredMotion best) {
    this.given = given;
    this.best = best;
    expected = given.expected(best.hypothesis().chain());
  }

  /** A kind of trace. */
  enum Kind {
    TIME("it changes with time"),
    HEADING("it depends on the heading"),
    SIZE("it does not grow in proportion to the command"),
    SIDE("left differs from right, or forwards from backwards"),
    PLACE("it depends on the place"),
    RIPPLE("it comes again after a certain distance, as if a wheel were not round"),
    RESPONSE("it depends on the commands in a way that no named effect describes");

    private final String words;

    Kind(String words) {
      this.words = words;
    }

    String words() {
      return words;
    }
  }

  /**
   * What a kind of trace foretells.
   *
   * @param kind of the trace
   * @param nats by which left-out blocks are likelier with it
   * @param values that were fitted
   * @param share of the mean square of what the nominal model leaves over, the component where it
   *     is greatest
   */
  record Trace(Kind kind, double nats, int values, double share) {}

  List<Trace> traces(double[][] nominal) {
    double without = withItsNoise(best.slopes().linear(), List.of());
    return Arrays.stream(Kind.values()).map(kind -> trace(kind, nominal, without)).toList();
  }

  /** Returns the log density of left-out blocks with a kind of trace beside the explanation. */
  double heldOut(Kind kind) {
    return Arrays.stream(beside(columns(kind)).heldOut()).sum();
  }

  /** The values of the explanation, and those of a trace behind them. */
  private Linear beside(List<double[][]> raw) {
    Whitening[] white = best.slopes().white();
    double[][][] own = best.slopes().columns();
    double[][][] all = Arrays.copyOf(own, own.length + raw.size());
    for (int k = 0; k < raw.size(); k++) {
      double[][] column = new double[white.length][];
      for (int c = 0; c < column.length; c++) {
        column[c] = white[c].of(raw.get(k)[c]);
      }
      all[own.length + k] = column;
    }
    return new Linear(given, white, all);
  }

  private Trace trace(Kind kind, double[][] nominal, double without) {
    List<double[][]> raw = columns(kind);
    int own = best.slopes().columns().length;
    Linear with = beside(raw);
    double nats = Arrays.stream(with.heldOut()).sum() - best.heldOut();
    nats = nats > HOPELESS_NATS ? Math.max(nats, withItsNoise(with, raw) - without) : nats;
    double[] values = with.move(block -> true, RIDGE);
    return new Trace(
        kind,
        nats,
        raw.size() + (kind == Kind.RIPPLE ? SCANNED : 0),
        share(raw, Arrays.copyOfRange(values, own, values.length), nominal));
  }

  /**
   * The log density of left-out blocks with the noise that is left then: what lasts as long as a
   * command does was taken for the robot's own scatter, and hides what foretells it.
   */
  private double withItsNoise(Linear with, List<double[][]> raw) {
    double[][][] own = best.slopes().raw();
    double[][] moves = new double[MotionSteps.FOLDS][];
    Arrays.setAll(moves, with::withoutFold);
    double[][] left = new double[MotionSteps.COMPONENTS][given.size()];
    for (int c = 0; c < left.length; c++) {
      for (int i = 0; i < given.size(); i++) {
        double[] move = moves[given.foldOf(given.block(i))];
        left[c][i] = best.fit().residuals()[c][i];
        for (int k = 0; k < move.length; k++) {
          double[][] column = k < own.length ? own[k] : raw.get(k - own.length);
          left[c][i] -= move[k] * column[c][i];
        }
      }
    }
    return Whitening.logDensity(given, NoiseFit.afresh(given, left), left);
  }

  private double share(List<double[][]> raw, double[] values, double[][] nominal) {
    double most = 0;
    for (int c = 0; c < nominal.length; c++) {
      double foretold = 0;
      double all = 0;
      for (int i = 0; i < given.size(); i++) {
        double sum = 0;
        for (int k = 0; k < values.length; k++) {
          sum += values[k] * raw.get(k)[c][i];
        }
        foretold += sum * sum;
        all += nominal[c][i] * nominal[c][i];
      }
      most = all > 0 ? Math.max(most, foretold / all) : most;
    }
    return most;
  }

  private List<double[][]> columns(Kind kind) {
    return switch (kind) {
      case TIME -> time();
      case HEADING -> heading();
      case SIZE -> size();
      case SIDE -> side();
      case PLACE -> place();
      case RIPPLE -> ripple();
      case RESPONSE -> response();
    };
  }

  private List<double[][]> time() {
    return List.of(
        column(0, i -> minutes(i) * along(i)),
        column(2, i -> minutes(i) * turn(i)),
        column(2, i -> minutes(i) * along(i)),
        column(2, i -> minutes(i) * seconds(i)));
  }

  private List<double[][]> heading() {
    List<double[][]> columns = new ArrayList<>();
    for (double turned : new double[] {0, Math.PI / 2}) {
      columns.add(column(0, i -> seconds(i) * Math.cos(heading(i) - turned)));
      columns.add(column(1, i -> seconds(i) * Math.cos(heading(i) - turned)));
      columns.add(column(0, i -> along(i) * Math.cos(heading(i) - turned)));
      columns.add(column(2, i -> along(i) * Math.cos(heading(i) - turned)));
      // Axes that are of unequal length, or not square.
      columns.add(column(0, i -> along(i) * Math.cos(2 * heading(i) - turned)));
      columns.add(column(1, i -> along(i) * Math.cos(2 * heading(i) - turned)));
      columns.add(column(2, i -> turn(i) * Math.cos(2 * heading(i) - turned)));
    }
    return columns;
  }

  private List<double[][]> side() {
    return List.of(
        column(0, i -> Math.abs(along(i))),
        column(0, i -> Math.abs(turn(i))),
        column(2, i -> Math.abs(turn(i))),
        column(2, i -> Math.abs(along(i))));
  }

  /** What is slower in a part of the room, or is pulled to a point of it. */
  private List<double[][]> place() {
    List<double[][]> columns = new ArrayList<>();
    for (double turned : new double[] {0, Math.PI / 2}) {
      columns.add(column(0, i -> along(i) * position(i, turned)));
      columns.add(column(2, i -> turn(i) * position(i, turned)));
      columns.add(column(0, i -> seconds(i) * position(i, heading(i) + turned)));
      columns.add(column(1, i -> seconds(i) * position(i, heading(i) + turned)));
      columns.add(column(0, i -> seconds(i) * Math.cos(heading(i) - turned)));
      columns.add(column(1, i -> seconds(i) * Math.cos(heading(i) - turned)));
    }
    return columns;
  }

  /** What comes again after the way that shows it most. */
  private List<double[][]> ripple() {
    double[] way = way();
    double most = 0;
    List<double[][]> best = List.of();
    for (double lengthM = SHORTEST_M; lengthM < LONGEST_M; lengthM *= FINE) {
      for (int component : new int[] {0, 2}) {
        List<double[][]> columns = waves(way, component, 2 * Math.PI / lengthM);
        double size = size(component, columns);
        if (size > most) {
          most = size;
          best = columns;
        }
      }
    }
    return best.isEmpty() ? waves(way, 0, 2 * Math.PI) : best;
  }

  private List<double[][]> waves(double[] way, int component, double perM) {
    return List.of(
        column(component, i -> along(i) * Math.cos(perM * way[i])),
        column(component, i -> along(i) * Math.sin(perM * way[i])));
  }

  /** The square of the wave that fits, in nats but for a factor. */
  private double size(int component, List<double[][]> columns) {
    double size = 0;
    double[] residuals = best.slopes().white()[component].white;
    for (double[][] column : columns) {
      double[] white = best.slopes().white()[component].of(column[component]);
      double both = 0;
      double own = 1e-30;
      for (int i = 0; i < white.length; i++) {
        double weight = best.slopes().white()[component].weights[i];
        both += weight * white[i] * residuals[i];
        own += weight * white[i] * white[i];
      }
      size += both * both / own;
    }
    return size;
  }

  /** The way driven at the middle of each step, of its run. */
  private double[] way() {
    double[] way = new double[given.size()];
    double sum = 0;
    for (int i = 0; i < way.length; i++) {
      sum = i > 0 && given.step(i).run() != given.step(i - 1).run() ? 0 : sum;
      way[i] = sum + along(i) / 2;
      sum += along(i);
    }
    return way;
  }

  /** The place as seen along a direction. */
  private double position(int step, double rad) {
    TrackPose from = given.step(step).from();
    return from.xM() * Math.cos(rad) + from.yM() * Math.sin(rad);
  }

  private List<double[][]> size() {
    return List.of(
        column(0, i -> along(i) * Math.abs(along(i)) / seconds(i)),
        column(0, i -> along(i) * Math.abs(turn(i)) / seconds(i)),
        column(1, i -> along(i) * turn(i) / seconds(i)),
        column(2, i -> turn(i) * Math.abs(turn(i)) / seconds(i)),
        column(2, i -> turn(i) * Math.abs(along(i)) / seconds(i)));
  }

  private List<double[][]> response() {
    List<double[][]> columns = new ArrayList<>();
    for (int lag = 0; lag < LAGS; lag++) {
      double before = lag * LAG_S;
      columns.add(column(0, i -> seconds(i) * held(i, before).speedMPerS()));
      columns.add(column(2, i -> seconds(i) * held(i, before).turnRadPerS()));
    }
    return columns;
  }

  private interface Value {
    double at(int step);
  }

  private double[][] column(int component, Value value) {
    double[][] column = new double[MotionSteps.COMPONENTS][given.size()];
    Arrays.setAll(column[component], value::at);
    return column;
  }

  private double along(int step) {
    return expected[0][step];
  }

  private double turn(int step) {
    return expected[2][step];
  }

  private double seconds(int step) {
    return given.step(step).durationS();
  }

  private double heading(int step) {
    return given.step(step).from().headingRad();
  }

  private double minutes(int step) {
    MotionRun run = given.runs().get(given.step(step).run());
    return (given.step(step).from().timeS() - run.commands().get(0).timeS()) / 60;
  }

  private Command held(int step, double beforeS) {
    List<Command> commands = given.runs().get(given.step(step).run()).commands();
    double timeS = given.step(step).to().timeS() - beforeS;
    return CommandTrail.held(commands, timeS);
  }
}
