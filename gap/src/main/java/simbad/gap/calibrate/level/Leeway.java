package simbad.gap.calibrate.level;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.BiFunction;
import java.util.stream.IntStream;
import org.hipparchus.linear.ArrayRealVector;
import org.hipparchus.linear.MatrixUtils;
import org.hipparchus.linear.RealMatrix;
import org.jspecify.annotations.Nullable;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.ping.Geometry;

/**
 * How far a reference leaves the level law open. All rows of a log see the same set-up, so that
 * more rows do not make what it is off by an effect: readings are off together as the set-up is,
 * and a log's ranges are as likely as the set-up's most probable move makes them. That is by a
 * normal distribution of the values, with the log's information by its scores (Berndt, Hall, Hall
 * and Hausman 1974).
 */
public final class Leeway {
  /** Half of what differs from one day to the next (docs/method/model-error.md). */
  private static final double DAYS_GAIN_DB = 0.15;

  private static final double DAYS_ABSORPTION_DB_PER_M = 0.05;
  private static final double DAYS_TURN_RAD = Math.toRadians(0.25);
  private static final double DAYS_PLACE_M = 0.002;
  private static final double DAYS_AIR = 0.0009;

  /** An obstacle's echo path is the same over so wide a sector. */
  private static final int SECTORS = 24;

  /** What was read further from every obstacle has to do with none of them. */
  private static final double NEAR_M = 0.2;

  private static final double LEAST_PLACE_DB = 0.05;

  /** What the best step of one score and its square promises. */
  private static final double SCORED_NATS = 0.5;

  private static final int SCALE = 0;
  private static final int WALK = 1;
  private static final int NEAR = WALK + LevelForms.WALK_DB.size();
  private static final int CONSTANT = NEAR + LevelForms.NEAR_M.size() - 1;
  private static final int TARGETS = CONSTANT + 1;

  private final Predictor predictor;
  private final int targets;
  private final RealMatrix excessCovariance;
  private final RealMatrix rangeCovariance;
  private final RealMatrix rangePrecision;

  /** Of the levels' values and, behind them, of what levels are off at each place. */
  private final RealMatrix levelPrecision;

  private Leeway(Known known, RealMatrix excess, RealMatrix range, RealMatrix level) {
    predictor = known.predictor;
    targets = known.ranges.byBearing().size();
    excessCovariance = excess;
    rangeCovariance = range;
    rangePrecision = inverse(range);
    levelPrecision = level;
  }

  /**
   * What a fit knows of its values.
   *
   * @param layout of the values of levels
   * @param predictor of excesses, set to the values
   * @param covariance of the values
   * @param ranges as fitted
   */
  record Known(Layout layout, Predictor predictor, RealMatrix covariance, Ranges ranges) {}

  /**
   * Returns what a fit leaves open, what differs from one day to the next, and where the law is a
   * little wrong.
   *
   * @param known by the fit
   * @param excessDb by how much levels are off at a distance, beyond what the fit knows of itself
   * @param rangeM the same of ranges, metres
   */
  static Leeway of(Known known, double excessDb, double rangeM) {
    RealMatrix excess = withTurns(known.covariance, known.ranges.byBearing().size());
    double off = excessDb * excessDb;
    add(excess, Layout.LEVEL, DAYS_GAIN_DB * DAYS_GAIN_DB);
    add(excess, Layout.ABSORPTION, DAYS_ABSORPTION_DB_PER_M * DAYS_ABSORPTION_DB_PER_M);
    add(excess, known.layout.squint(), DAYS_TURN_RAD * DAYS_TURN_RAD);
    RealMatrix level = ofPlaces(excess, known.ranges.byBearing().size(), off);
    add(excess, Layout.LEVEL, off);
    for (int knot = 0; knot < LevelForms.RECEIVER_M.size(); knot++) {
      add(excess, Layout.RECEIVER + knot, off);
    }
    return new Leeway(known, excess, ofRanges(known.ranges, rangeM), level);
  }

  /**
   * The values' covariance and, behind it, by how much each obstacle is turned otherwise than on
   * the day of the reference: a lobe of a few degrees shows that in its levels.
   */
  private static RealMatrix withTurns(RealMatrix covariance, int targets) {
    int size = covariance.getRowDimension();
    RealMatrix all = MatrixUtils.createRealMatrix(size + targets, size + targets);
    all.setSubMatrix(covariance.getData(), 0, 0);
    for (int target = 0; target < targets; target++) {
      add(all, size + target, DAYS_TURN_RAD * DAYS_TURN_RAD);
    }
    return all;
  }

  /** What levels are off at one place says nothing of the next. */
  private static RealMatrix ofPlaces(RealMatrix excess, int targets, double variance) {
    int size = excess.getRowDimension();
    int places = targets * LevelForms.RECEIVER_M.size();
    RealMatrix precision = MatrixUtils.createRealMatrix(size + places, size + places);
    precision.setSubMatrix(inverse(excess).getData(), 0, 0);
    for (int place = 0; place < places; place++) {
      add(precision, size + place, 1 / Math.max(LEAST_PLACE_DB * LEAST_PLACE_DB, variance));
    }
    return precision;
  }

  private static RealMatrix ofRanges(Ranges ranges, double rangeM) {
    int targets = ranges.byBearing().size();
    int size = TARGETS + targets * (SECTORS + 1);
    RealMatrix range = MatrixUtils.createRealMatrix(size, size);
    range.setSubMatrix(ranges.covariance().getData(), SCALE, SCALE);
    for (int knot = WALK; knot < NEAR; knot++) {
      add(range, knot, rangeM * rangeM);
    }
    add(range, SCALE, DAYS_AIR * DAYS_AIR);
    add(range, CONSTANT, DAYS_PLACE_M * DAYS_PLACE_M + rangeM * rangeM);
    for (int target = 0; target < targets; target++) {
      add(range, constant(target), DAYS_PLACE_M * DAYS_PLACE_M);
      double[] path = ranges.byBearing().get(target).values();
      for (int sector = 0; sector < SECTORS; sector++) {
        add(range, sector(target, sector), variance(path, sector));
      }
    }
    return range;
  }

  private static RealMatrix inverse(RealMatrix matrix) {
    return Matrices.positive(matrix).getSolver().getInverse();
  }

  private static void add(RealMatrix matrix, int at, double variance) {
    matrix.addToEntry(at, at, variance);
  }

  private static int constant(int target) {
    return TARGETS + target * (SECTORS + 1);
  }

  private static int sector(int target, int sector) {
    return constant(target) + 1 + sector;
  }

  private static double variance(double[] path, int sector) {
    int each = LevelForms.BEARINGS / SECTORS;
    int first = LevelForms.BEARINGS + sector * each;
    return Arrays.stream(path, first, first + each).map(own -> own * own).average().orElse(0);
  }

  /**
   * Returns by how many nats a log's ranges would be likelier if the set-up moved.
   *
   * @param pulls of the log under a hypothesis
   * @param perMetre by how much the log probability of each reading rises with its range
   * @param roomNats by how much each may rise at all, at least 0: to certainty
   * @return at least 0
   */
  public double rangeNats(Pulls pulls, double[] perMetre, double[] roomNats) {
    ScoreSums metres = new ScoreSums(rangePrecision.getRowDimension());
    for (int ping = 0; ping < perMetre.length; ping++) {
      if (pulls.range[ping] != null && perMetre[ping] != 0) {
        metres.add(pulls.range[ping], perMetre[ping], share(roomNats[ping]));
      }
    }
    return metres.nats(rangePrecision);
  }

  /**
   * Score and information of one reading promise half a nat at most. One that is nearly certain
   * cannot rise so far: beside the end of its step its slope is steep all the same, and it counts
   * for the share that it can.
   */
  private static double share(double roomNats) {
    return Math.min(1, roomNats / SCORED_NATS);
  }

  /**
   * Moves the set-up's levels to where they and a log are most probable together.
   *
   * @param pulls of the log under a hypothesis
   * @param echoes how likely each reading is where its excess is another
   */
  public Moved moved(Pulls pulls, EchoCurves echoes) {
    LevelMove move =
        new LevelMove(levelPrecision, rows(pulls, echoes, (ping, pull) -> pull), echoes);
    double nats = move.climb();
    return new Moved(nats, move.shiftsDb());
  }

  /** The readings that levels say something of. */
  private List<LevelMove.Row> rows(
      Pulls pulls, EchoCurves echoes, BiFunction<Integer, Pull, Pull> more) {
    int places = excessCovariance.getRowDimension();
    List<LevelMove.Row> rows = new ArrayList<>();
    for (int ping = 0; ping < echoes.size(); ping++) {
      Pull pull = pulls.level[ping];
      if (pull != null && !echoes.isFlat(ping)) {
        Pull own = more.apply(ping, pull.and(places + pulls.place[ping], 1));
        rows.add(new LevelMove.Row(ping, own.index(), own.value()));
      }
    }
    return rows;
  }

  /**
   * Moves the set-up's levels, and lets them wander besides along something that the set-up knows
   * nothing of.
   *
   * @param pulls of the log under a hypothesis
   * @param echoes how likely each reading is where its excess is another
   * @param along what they may wander
   * @param spreadDb how far they do, standard deviation
   */
  public Wandered wandered(Pulls pulls, EchoCurves echoes, Along along, double spreadDb) {
    int own = levelPrecision.getRowDimension();
    RealMatrix precision = MatrixUtils.createRealMatrix(own + along.size(), own + along.size());
    precision.setSubMatrix(levelPrecision.getData(), 0, 0);
    precision.setSubMatrix(along.precision(spreadDb).getData(), own, own);
    List<LevelMove.Row> rows =
        rows(
            pulls,
            echoes,
            (ping, pull) ->
                along.has(ping)
                    ? pull.and(own + along.knot(ping), 1 - along.share(ping))
                        .and(own + along.next(ping), along.share(ping))
                    : pull);
    LevelMove both = new LevelMove(precision, rows, echoes);
    double nats = both.climb();
    return new Wandered(new Moved(nats + both.logShare(), both.shiftsDb()), both.valuesFrom(own));
  }

  /**
   * Returns what the set-up's own values cost where nothing wanders: the logarithm of the share of
   * what they could be before that they still can be, at most 0.
   *
   * @param pulls of the log under a hypothesis
   * @param echoes how likely each reading is where its excess is another
   */
  public double logShare(Pulls pulls, EchoCurves echoes) {
    LevelMove alone =
        new LevelMove(levelPrecision, rows(pulls, echoes, (ping, pull) -> pull), echoes);
    alone.climb();
    return alone.logShare();
  }

  /**
   * Levels that have wandered.
   *
   * @param moved by how many nats the log is likelier, with the cost of all that curve and set-up
   *     might have been; may be below 0
   * @param atKnotsDb by how much levels are more at each knot, decibels
   */
  @SuppressWarnings("ArrayRecordComponent") // read only
  public record Wandered(Moved moved, double[] atKnotsDb) {
    /** Refuses what is no number. */
    public Wandered {
      Checks.numbers("atKnotsDb", atKnotsDb);
    }
  }

  /**
   * Levels that have moved.
   *
   * @param nats by which the log and they are likelier; at least 0
   * @param shiftsDb by how much the excess of what each ping is most about is more, decibels
   */
  @SuppressWarnings("ArrayRecordComponent") // read only
  public record Moved(double nats, double[] shiftsDb) {
    /** Refuses what is no number. */
    public Moved {
      Checks.number("nats", nats);
      Checks.numbers("shiftsDb", shiftsDb);
    }
  }

  /**
   * How the excess and the range of what each ping is most about move with the set-up. Immutable.
   */
  public static final class Pulls {
    private final @Nullable Pull[] level;
    private final @Nullable Pull[] range;
    private final int[] place;
    private final int[] line;

    private Pulls(int size) {
      place = new int[size];
      line = new int[size];
      level = new Pull[size];
      range = new Pull[size];
    }

    /**
     * Returns the line of sight that a ping is most about; negative where it is about no obstacle.
     */
    public int line(int ping) {
      return line[ping];
    }
  }

  /**
   * Finds how a log depends on the set-up.
   *
   * @param geometry of the log under a hypothesis
   * @param added what the hypothesis adds to the excess of each line of sight, decibels
   */
  public Pulls pulls(Geometry geometry, double[] added) {
    int size = geometry.log().size();
    Pulls pulls = new Pulls(size);
    Predictor.Slope slope = new Predictor.Slope();
    for (int ping = 0; ping < size; ping++) {
      int line = line(geometry, ping);
      pulls.line[ping] = line;
      if (line >= 0) {
        boolean read = geometry.log().echo(ping);
        Predictor.Row row =
            predictor.row(Trials.trial(geometry, line, read).plus(added[line], 1, 0));
        Predictor.Excess own = predictor.excess(row);
        predictor.slope(row, own, slope);
        int turn = excessCovariance.getRowDimension() - targets + row.trial().target();
        pulls.level[ping] = pull(slope).and(turn, predictor.perTurnDb(row));
        pulls.place[ping] = place(row.trial());
        if (read) {
          pulls.range[ping] = ofRange(row.trial(), own.decibels());
        }
      }
    }
    return pulls;
  }

  private static int place(Trials.Trial trial) {
    return trial.target() * LevelForms.RECEIVER_M.size()
        + LevelForms.receiverKnot(trial.nearestM());
  }

  private static Pull pull(Predictor.Slope slope) {
    int[] index = new int[slope.size()];
    double[] value = new double[index.length];
    for (int i = 0; i < index.length; i++) {
      index[i] = slope.index(i);
      value[i] = slope.value(i);
    }
    return new Pull(index, value);
  }

  /** What readings of several pings have in common by the set-up. */
  public final class Together {
    private final Pulls pulls;
    private final double[] levels = new double[excessCovariance.getRowDimension()];
    private final double[] metres = new double[rangeCovariance.getRowDimension()];

    private Together(Pulls pulls) {
      this.pulls = pulls;
    }

    /**
     * Adds a ping.
     *
     * @param ping index
     * @param perDecibel by how much what is summed rises with the ping's excess
     * @param perMetre the same with its range
     */
    public void add(int ping, double perDecibel, double perMetre) {
      add(pulls.level[ping], perDecibel, levels);
      add(pulls.range[ping], perMetre, metres);
    }

    private static void add(@Nullable Pull pull, double rise, double[] into) {
      if (pull != null && rise != 0) {
        for (int i = 0; i < pull.index().length; i++) {
          into[pull.index()[i]] += rise * pull.value()[i];
        }
      }
    }

    /** Returns how much the sum varies with the levels that the set-up leaves open. */
    public double levelVariance() {
      return variance(excessCovariance, levels);
    }

    /** Returns the same with the ranges. */
    public double rangeVariance() {
      return variance(rangeCovariance, metres);
    }

    private static double variance(RealMatrix covariance, double[] sum) {
      ArrayRealVector vector = new ArrayRealVector(sum, false);
      return Math.max(0, covariance.operate(vector).dotProduct(vector));
    }
  }

  /**
   * Returns by how much each reading of a log reads longer where the set-up's ranges have moved to
   * where they and the log are likeliest, metres; 0 where a ping is about no obstacle.
   *
   * @param pulls of the log under a hypothesis
   * @param score of each reading: standard normal where the hypothesis is right
   * @param perMetre by how much each score rises with what the set-up adds
   */
  public double[] rangeShiftsM(Pulls pulls, double[] score, double[] perMetre) {
    ScoreSums sums = new ScoreSums(rangePrecision.getRowDimension());
    for (int ping = 0; ping < score.length; ping++) {
      if (pulls.range[ping] != null) {
        sums.addLine(pulls.range[ping], perMetre[ping], -score[ping]);
      }
    }
    double[] move = sums.move(rangePrecision);
    double[] shifts = new double[score.length];
    for (int ping = 0; ping < shifts.length; ping++) {
      shifts[ping] = pulls.range[ping] == null ? 0 : pulls.range[ping].dot(move);
    }
    return shifts;
  }

  /** Returns an empty sum of pings. */
  public Together together(Pulls pulls) {
    return new Together(pulls);
  }

  /** The line of sight that a reading is most about; negative for none. */
  private int line(Geometry geometry, int ping) {
    boolean read = geometry.log().echo(ping);
    int best = -1;
    double least = read ? NEAR_M : Double.POSITIVE_INFINITY;
    for (int target = 0; target < targets; target++) {
      int line = ping * targets + target;
      double nearest = geometry.nearestM(line);
      double off = read ? Math.abs(nearest - geometry.log().rangeM(ping)) : nearest;
      if (off < least) {
        least = off;
        best = line;
      }
    }
    return best;
  }

  private static Pull ofRange(Trials.Trial trial, double excessDb) {
    double[] shared = Ranges.row(trial.nearestM(), excessDb);
    // Knots that the level and the distance do not lie between say nothing.
    int[] some = IntStream.range(0, CONSTANT).filter(at -> shared[at] != 0).toArray();
    double[] value = new double[some.length + 3];
    Arrays.setAll(value, at -> at < some.length ? shared[some[at]] : 1);
    int[] index = Arrays.copyOf(some, value.length);
    int place = (int) (trial.bearingRad() / Angles.TURN_RAD * SECTORS);
    index[some.length] = CONSTANT;
    index[some.length + 1] = constant(trial.target());
    index[some.length + 2] = sector(trial.target(), Math.floorMod(place, SECTORS));
    return new Pull(index, value);
  }
}
