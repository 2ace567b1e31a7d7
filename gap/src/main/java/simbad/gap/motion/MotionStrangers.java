package simbad.gap.motion;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/**
 * What has no name and leaves a trace: plain regressions of what an explanation leaves over on
 * time, heading, size and the commands of the last second. What they foretell of left-out blocks
 * has a cause that is not named.
 */
final class MotionStrangers {
  private static final int LAGS = 6;
  private static final double LAG_S = 0.2;
  private static final double RIDGE = 1e-3;

  private static final MotionForm LATER = MotionForms.find("actuation-latency").orElseThrow();
  private static final double LATER_S = 0.02;

  /** What loses more with the noise as it was gains nothing with another. */
  private static final double HOPELESS_NATS = -5;

  /** The smallest and largest wheel that is looked for, as the way of a turn, and how finely. */
  private static final double SHORTEST_M = 0.06;

  private static final double LONGEST_M = 1.6;
  private static final double FINE = 1.002;
  private static final int LENGTHS = (int) (Math.log(LONGEST_M / SHORTEST_M) / Math.log(FINE));

  /** Lengths up to a fifth longer or shorter, most of which a wave does not reach. */
  private static final int ABOUT = (int) (Math.log(1.2) / Math.log(FINE));

  /** The best of so many lengths gains by chance what so many values do: twice their logarithm. */
  private static final int SCANNED = 16;

  /** Kinds that no plain regression shows. */
  private static final Set<Kind> SHOWN_OTHERWISE =
      Set.of(Kind.RIPPLE, Kind.DRIFT, Kind.SCATTER, Kind.LOST, Kind.LATE);

  private final MotionSteps given;
  private final List<MotionRun> sent;

  /** By how many times blocks pull apart more than by chance. */
  private final double clumping;

  private final ScoredMotion best;
  private final double[][] expected;

  /** What is expected were commands to act a little later. */
  private final double[][] later;

  /** By how many times waves of about the length that was found are larger than by chance. */
  private double rippleLevel = 1;

  MotionStrangers(Told told, ScoredMotion best) {
    given = told.given();
    sent = told.sent();
    clumping = told.odds().clumping();
    this.best = best;
    MotionChain chain = best.hypothesis().chain();
    expected = given.expected(chain);
    later = given.expected(chain.with(LATER.change(LATER_S)));
  }

  /** A kind of trace. */
  enum Kind {
    TIME("it changes with time"),
    HEADING("it depends on the heading"),
    SIZE("it does not grow in proportion to the command"),
    SIDE("left differs from right, or forwards from backwards"),
    PLACE("it depends on the place"),
    RIPPLE("it comes again after a certain distance, as if a wheel were not round"),
    DRIFT("it wanders for minutes"),
    LOST("now and then a command is not carried out"),
    LATE("its commands act sooner for some seconds and later for others"),
    SCATTER("its way scatters and its turns do not, or the other way round"),
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
   * @param raw nats by which left-out blocks are likelier with it
   * @param nats the same over how many times more than by chance blocks pull apart
   * @param values that were fitted
   * @param share of the mean square of what the nominal model leaves over, the component where it
   *     is greatest
   */
  record Trace(Kind kind, double raw, double nats, int values, double share) {}

  /**
   * Returns a trace of each kind.
   *
   * @param nominal what the nominal model leaves over
   */
  List<Trace> traces(double[][] nominal) {
    Beside alone = new Beside(List.of());
    Trace ripple = trace(Kind.RIPPLE, alone, nominal);
    // What comes again as a wheel turns is no trace of anything else.
    Beside base = MotionUnknown.gain(ripple) > 0 ? new Beside(columns(Kind.RIPPLE)) : alone;
    List<Trace> traces =
        new ArrayList<>(List.of(ripple, drift(nominal), lost(nominal), late(nominal)));
    for (Kind kind : Kind.values()) {
      if (!SHOWN_OTHERWISE.contains(kind)) {
        traces.add(trace(kind, base, nominal));
      }
    }
    return traces;
  }

  /** What changes for minutes, back and forth perhaps: scales, veering and turning by itself. */
  private Trace drift(double[][] nominal) {
    List<double[][]> raw = columns(Kind.DRIFT);
    Linear linear = new Beside(raw).linear;
    Linear.Drift drift = linear.drift(best.slopes().columns().length);
    if (drift.freedoms() == 0) {
      return new Trace(Kind.DRIFT, 0, 0, 0, 0);
    }
    double[][] values = new double[linear.parts()][];
    for (int part = 0; part < values.length; part++) {
      int own = part;
      double[] all = linear.move(block -> linear.part(block) == own, RIDGE);
      values[part] = Arrays.copyOfRange(all, all.length - raw.size(), all.length);
    }
    double chance = Math.min(1, drift.freedoms() / drift.square());
    double share = share(raw, step -> values[linear.part(given.block(step))], nominal);
    return new Trace(Kind.DRIFT, 0, drift.square() / 2, drift.freedoms(), (1 - chance) * share);
  }

  private Trace lost(double[][] nominal) {
    LostCommands lost = new LostCommands(given, sent, best.hypothesis().chain());
    double nats = lost.gain() / Math.max(1, clumping);
    return new Trace(Kind.LOST, lost.gain(), nats, 1, share(lost.part(), nominal));
  }

  private Trace late(double[][] nominal) {
    Lateness late = new Lateness(given, best.fit().residuals(), lateness(step -> 1));
    double nats = late.hangsTogether() / 2;
    return new Trace(Kind.LATE, nats, nats, Lateness.LAGS, share(late.part(), nominal));
  }

  /** Returns the log density of left-out blocks with a kind of trace beside the explanation. */
  double heldOut(Kind kind) {
    return kind == Kind.LOST
        ? new LostCommands(given, sent, best.hypothesis().chain()).logDensity()
        : new Beside(columns(kind)).heldOut();
  }

  /** The explanation, with columns beside its own. */
  private final class Beside {
    private final List<double[][]> raw;
    private final Linear linear;

    Beside(List<double[][]> raw) {
      this.raw = raw;
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
      linear = new Linear(given, white, all);
    }

    Beside with(List<double[][]> more) {
      List<double[][]> all = new ArrayList<>(raw);
      all.addAll(more);
      return new Beside(all);
    }

    double heldOut() {
      return Arrays.stream(linear.heldOut()).sum();
    }
  }

  private Trace trace(Kind kind, Beside base, double[][] nominal) {
    List<double[][]> raw = columns(kind);
    Beside with = base.with(raw);
    double nats = with.heldOut() - base.heldOut();
    nats = nats > HOPELESS_NATS ? Math.max(nats, withItsNoise(with) - withItsNoise(base)) : nats;
    double chance = kind == Kind.RIPPLE ? rippleLevel : 1;
    double[] values = with.linear.move(block -> true, RIDGE);
    double[] own = Arrays.copyOfRange(values, values.length - raw.size(), values.length);
    return new Trace(
        kind,
        nats,
        nats / Math.max(chance, with.linear.lasting()),
        raw.size() + (kind == Kind.RIPPLE ? SCANNED : 0),
        share(raw, step -> own, nominal));
  }

  /**
   * The log density of left-out blocks with the noise that is left then: what lasts as long as a
   * command does was taken for the robot's own scatter, and hides what foretells it.
   */
  private double withItsNoise(Beside with) {
    List<double[][]> raw = with.raw;
    double[][][] own = best.slopes().raw();
    double[][] moves = new double[MotionSteps.FOLDS][];
    Arrays.setAll(moves, with.linear::withoutFold);
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

  private double share(List<double[][]> raw, IntFunction<double[]> values, double[][] nominal) {
    double[][] foretold = new double[MotionSteps.COMPONENTS][given.size()];
    for (int c = 0; c < foretold.length; c++) {
      for (int i = 0; i < given.size(); i++) {
        double[] own = values.apply(i);
        for (int k = 0; k < own.length; k++) {
          foretold[c][i] += own[k] * raw.get(k)[c][i];
        }
      }
    }
    return share(foretold, nominal);
  }

  /**
   * Returns how much of the mean square of what the nominal model leaves over a part of it accounts
   * for, in the component where it is most.
   *
   * @param part by component and step
   * @param nominal what the nominal model leaves over
   */
  static double share(double[][] part, double[][] nominal) {
    double most = 0;
    for (int c = 0; c < nominal.length; c++) {
      double all = square(nominal[c]);
      most = all > 0 ? Math.max(most, square(part[c]) / all) : most;
    }
    return most;
  }

  private static double square(double[] values) {
    double sum = 0;
    for (double value : values) {
      sum += value * value;
    }
    return sum;
  }

  private List<double[][]> columns(Kind kind) {
    return switch (kind) {
      case TIME -> time();
      case HEADING -> heading();
      case SIZE -> size();
      case SIDE -> side();
      case PLACE -> place();
      case RIPPLE -> ripple();
      case DRIFT -> plain();
      case LOST, LATE, SCATTER -> List.of();
      case RESPONSE -> response();
    };
  }

  private List<double[][]> time() {
    return List.of(
        column(0, i -> minutes(i) * along(i)),
        column(2, i -> minutes(i) * turn(i)),
        column(2, i -> minutes(i) * along(i)),
        column(2, i -> minutes(i) * seconds(i)),
        lateness(this::minutes));
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

  private List<double[][]> plain() {
    return List.of(
        column(0, this::along),
        column(2, this::turn),
        column(2, this::seconds),
        lateness(step -> 1));
  }

  /** How steps change as commands act later, times something. */
  private double[][] lateness(Value times) {
    double[][] column = new double[MotionSteps.COMPONENTS][given.size()];
    for (int c = 0; c < column.length; c++) {
      for (int i = 0; i < given.size(); i++) {
        double change = MotionSteps.wrapped(later[c][i] - expected[c][i]);
        column[c][i] = change / LATER_S * times.at(i);
      }
    }
    return column;
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

  /**
   * What comes again after the way that shows it most. Scatter that lasts shows every long way more
   * than chance does: what counts is how far one stands out of those of about its length.
   */
  private List<double[][]> ripple() {
    double[] way = way();
    double most = 0;
    List<double[][]> found = waves(way, 0, 2 * Math.PI);
    for (int component : new int[] {0, 2}) {
      double[] sizes = new double[LENGTHS];
      for (int k = 0; k < LENGTHS; k++) {
        List<double[][]> columns = waves(way, component, perM(k));
        sizes[k] = size(component, columns);
      }
      for (int k = 0; k < LENGTHS; k++) {
        double level = level(sizes, k);
        if (sizes[k] / level > most) {
          most = sizes[k] / level;
          rippleLevel = level;
          found = waves(way, component, perM(k));
        }
      }
    }
    return found;
  }

  private static double perM(int length) {
    return 2 * Math.PI / (SHORTEST_M * Math.pow(FINE, length));
  }

  /** By how many times sizes about one are larger than by chance (chi-square of 2), at least 1. */
  private static double level(double[] sizes, int at) {
    int from = Math.max(0, Math.min(sizes.length - 2 * ABOUT, at - ABOUT));
    double[] about = Arrays.copyOfRange(sizes, from, Math.min(sizes.length, from + 2 * ABOUT));
    Arrays.sort(about);
    return Math.max(1, about[about.length / 2] / (2 * Math.log(2)));
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
