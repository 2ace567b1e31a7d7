package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import simbad.motion.Command;
import simbad.motion.MotionRun;

/**
 * What has no name and leaves a trace: plain regressions of what an explanation leaves over on
 * time, heading, size and the commands of the last second. What they foretell of left-out blocks
 * has a cause that is not named.
 */
final class Strangers {
  private static final int LAGS = 6;
  private static final double LAG_S = 0.2;
  private static final double RIDGE = 1e-3;

  private final Evidence evidence;
  private final Scored best;
  private final double[][] expected;

  Strangers(Evidence evidence, Scored best) {
    this.evidence = evidence;
    this.best = best;
    expected = evidence.expected(best.hypothesis().chain());
  }

  /** A kind of trace. */
  enum Kind {
    TIME("it changes with time"),
    HEADING("it depends on the heading"),
    SIZE("it does not grow in proportion to the command"),
    RESPONSE("it follows commands otherwise than any name says");

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
    return Arrays.stream(Kind.values()).map(kind -> trace(kind, nominal)).toList();
  }

  private Trace trace(Kind kind, double[][] nominal) {
    List<double[][]> raw = columns(kind);
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
    Linear with = new Linear(evidence, white, all);
    double nats = Arrays.stream(with.heldOut()).sum() - best.heldOut();
    double[] values = with.move(block -> true, RIDGE);
    return new Trace(
        kind,
        nats,
        raw.size(),
        share(raw, Arrays.copyOfRange(values, own.length, all.length), nominal));
  }

  private double share(List<double[][]> raw, double[] values, double[][] nominal) {
    double most = 0;
    for (int c = 0; c < nominal.length; c++) {
      double foretold = 0;
      double all = 0;
      for (int i = 0; i < evidence.size(); i++) {
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
    }
    return columns;
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
    double[][] column = new double[Evidence.COMPONENTS][evidence.size()];
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
    return evidence.step(step).durationS();
  }

  private double heading(int step) {
    return evidence.step(step).from().headingRad();
  }

  private double minutes(int step) {
    MotionRun run = evidence.runs().get(evidence.step(step).run());
    return (evidence.step(step).from().timeS() - run.commands().get(0).timeS()) / 60;
  }

  private Command held(int step, double beforeS) {
    List<Command> commands = evidence.runs().get(evidence.step(step).run()).commands();
    double timeS = evidence.step(step).to().timeS() - beforeS;
    int low = 0;
    int high = commands.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      if (commands.get(middle).timeS() <= timeS) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return commands.get(low);
  }
}
