package simbad.gap.unexplained;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import simbad.gap.calibrate.level.Leeway;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.slice.Axis;
import simbad.gap.slice.Slice;
import simbad.sonar.check.Checks;
import simbad.sonar.ping.PingLog;

/** How far a hypothesis is off in any slice of a log. */
public final class Misfit {
  /** How many of the greatest misfits count. */
  public static final int TOP = 5;

  private static final double LEAST_SUPPORT = 2;
  private static final int LEAST_ROWS = 12;

  private final List<Off> slices = new ArrayList<>();

  /** In what a slice is off. */
  public enum Kind {
    /** The number of echoes. */
    ECHO,
    /** Where ranges lie. */
    RANGE,
    /** How much ranges scatter. */
    SCATTER,
    /** The number of echoes where no reading is known. */
    FORECAST
  }

  /**
   * A slice that is off in one way.
   *
   * @param slice one bin of an axis
   * @param kind in what
   * @param z standard normal where the hypothesis is right
   * @param size share of echoes off, or normal scores off on average
   * @param rows in the slice
   */
  public record Off(Slice.Range slice, Kind kind, double z, double size, int rows) {
    /** Refuses what is no number. */
    public Off {
      Checks.number("z", z);
      Checks.number("size", size);
    }

    boolean isOfRanges() {
      return kind == Kind.RANGE || kind == Kind.SCATTER;
    }
  }

  /** What is counted once: the worst slice of an axis, in one way. */
  private record Way(Axis axis, Kind kind) {}

  private Misfit(
      CalibratedLog given, Hypothesis hypothesis, boolean ahead, Optional<Openness> open) {
    List<Axis> cuts = look(new Surprise(given, hypothesis), open);
    if (ahead && given.model(hypothesis).hasMemory()) {
      Foresight foresight = Foresight.of(given, hypothesis);
      cuts.forEach(cut -> lookAhead(given.log(), foresight, cut, open));
    }
    sort();
  }

  private Misfit(Surprise surprise) {
    look(surprise, Optional.empty());
    sort();
  }

  /** Looks at what was got wrong of the pings of a log. */
  public static Misfit of(Surprise surprise) {
    return new Misfit(surprise);
  }

  private void sort() {
    slices.sort(Comparator.comparingDouble(slice -> -Math.abs(slice.z)));
  }

  private List<Axis> look(Surprise surprise, Optional<Openness> open) {
    Scores read = new Scores(surprise.log, surprise.score);
    Scores left = open.map(own -> new Scores(surprise.log, own.moved(surprise.score))).orElse(read);
    List<Axis> cuts = new Slicing(surprise.log, surprise.geometry).all();
    for (Axis cut : cuts) {
      look(surprise, cut, read, left, open);
    }
    return cuts;
  }

  /**
   * Looks at all slices, and at what a hypothesis with memory expects where no reading is known.
   */
  public static Misfit of(CalibratedLog given, Hypothesis hypothesis) {
    return new Misfit(given, hypothesis, true, Optional.empty());
  }

  /**
   * Looks at all slices before a set-up that a reference leaves open: what all pings of a slice
   * have in common by it is no misfit.
   */
  static Misfit of(CalibratedLog given, Hypothesis hypothesis, Leeway leeway) {
    Openness open = Openness.of(given, hypothesis, leeway);
    return new Misfit(given, hypothesis, true, Optional.of(open));
  }

  /** Looks at all slices, ping by ping alone: far quicker where a hypothesis has memory. */
  public static Misfit ofPings(CalibratedLog given, Hypothesis hypothesis) {
    return new Misfit(given, hypothesis, false, Optional.empty());
  }

  /** Returns all slices, the most off first. */
  public List<Off> slices() {
    return List.copyOf(slices);
  }

  /** Returns the mean of the greatest of a number of slices, each cut and kind counted once. */
  public double top(int count) {
    return top(count, 1, 1);
  }

  /**
   * Returns the mean of the greatest where readings hang together.
   *
   * @param count of slices, each cut and kind counted once
   * @param echoes by how much more than by chance sums of echoes vary, at least 1
   * @param ranges by how much more sums of ranges do, at least 1
   */
  public double top(int count, double echoes, double ranges) {
    Map<Way, Double> greatest = new HashMap<>();
    for (Off slice : slices) {
      double more = slice.isOfRanges() ? ranges : echoes;
      Way way = new Way(slice.slice.axis(), slice.kind);
      greatest.merge(way, Math.abs(slice.z) / Math.sqrt(more), Math::max);
    }
    return greatest.values().stream()
        .sorted(Comparator.reverseOrder())
        .limit(count)
        .mapToDouble(z -> z)
        .average()
        .orElse(0);
  }

  /** Normal scores of ranges, their mean square, and the deviation of their squares. */
  private static final class Scores {
    private final double[] score;
    private final double meanSquare;
    private final double deviation;

    Scores(PingLog log, double[] score) {
      this.score = score;
      double sum = 0;
      double squares = 0;
      int count = 0;
      for (int i = 0; i < score.length; i++) {
        if (log.echo(i)) {
          double square = score[i] * score[i];
          sum += square;
          squares += square * square;
          count++;
        }
      }
      double mean = count > 0 ? sum / count : 1;
      double variance = count > 1 ? squares / count - mean * mean : 1;
      meanSquare = Math.max(1e-6, mean);
      deviation = Math.sqrt(Math.max(1e-6, variance));
    }
  }

  private void look(Surprise s, Axis cut, Scores read, Scores left, Optional<Openness> open) {
    Tally[] tallies = new Tally[cut.count()];
    for (int i = 0; i < s.log.size(); i++) {
      int at = cut.bin(i);
      if (at >= 0) {
        if (tallies[at] == null) {
          tallies[at] = new Tally(open);
        }
        tallies[at].add(s, i, left.score[i]);
      }
    }
    for (int at = 0; at < tallies.length; at++) {
      if (tallies[at] != null) {
        tallies[at].tell(range(cut, at), read, left, slices);
      }
    }
  }

  private void lookAhead(PingLog log, Foresight foresight, Axis cut, Optional<Openness> open) {
    boolean[] echo = new boolean[log.size()];
    int[] rows = new int[cut.count()];
    Leeway.@Nullable Together[] together = new Leeway.Together[cut.count()];
    for (int i = 0; i < echo.length; i++) {
      echo[i] = log.echo(i);
      int at = cut.bin(i);
      if (at >= 0) {
        rows[at]++;
        if (open.isPresent()) {
          if (together[at] == null) {
            together[at] = open.get().slice();
          }
          together[at].add(i, open.get().chancePerDb()[i], 0);
        }
      }
    }
    double[][] off = foresight.off(cut, echo);
    for (int at = 0; at < rows.length; at++) {
      double chance = off[1][at] * off[1][at];
      if (rows[at] >= LEAST_ROWS && chance >= LEAST_SUPPORT) {
        double share = off[0][at] / rows[at];
        double common = together[at] == null ? 0 : together[at].levelVariance();
        double deviation = Math.sqrt(chance + common);
        slices.add(new Off(range(cut, at), Kind.FORECAST, off[0][at] / deviation, share, rows[at]));
      }
    }
  }

  private static Slice.Range range(Axis cut, int at) {
    return new Slice.Range(cut, at, at + 1);
  }

  private static final class Tally {
    private int rows;
    private int echoes;
    private double expected;
    private double variance;
    private double scores;
    private double squares;
    private final Optional<Openness> open;
    private final Optional<Leeway.Together> together;

    Tally(Optional<Openness> open) {
      this.open = open;
      together = open.map(Openness::slice);
    }

    void add(Surprise s, int i, double left) {
      rows++;
      expected += s.expected[i];
      variance += s.expected[i] * (1 - s.expected[i]);
      if (together.isPresent()) {
        Openness own = open.orElseThrow();
        together.get().add(i, own.chancePerDb()[i], own.scorePerMetre()[i]);
      }
      if (s.log.echo(i)) {
        echoes++;
        scores += s.score[i];
        squares += left * left;
      }
    }

    void tell(Slice.Range at, Scores read, Scores left, List<Off> into) {
      if (rows >= LEAST_ROWS && variance >= LEAST_SUPPORT) {
        into.add(
            new Off(at, Kind.ECHO, echoZ() / echoesTogether(), (echoes - expected) / rows, rows));
      }
      if (echoes >= LEAST_ROWS) {
        double own = echoes * Math.max(read.meanSquare, 0.5);
        double shift = scores / Math.sqrt(own + together.map(t -> t.rangeVariance()).orElse(0.0));
        into.add(new Off(at, Kind.RANGE, shift, scores / echoes, rows));
        double scatter =
            (squares - echoes * left.meanSquare) / (left.deviation * Math.sqrt(echoes));
        into.add(new Off(at, Kind.SCATTER, scatter, squares / echoes, rows));
      }
    }

    /** By how many times more echoes vary than each for itself. */
    private double echoesTogether() {
      return Math.sqrt(1 + together.map(t -> t.levelVariance()).orElse(0.0) / variance);
    }

    /** Root of the deviance of the rarer outcome, so that few events are not over-rated. */
    private double echoZ() {
      boolean rareEcho = expected < rows / 2.0;
      double rare = rareEcho ? expected : rows - expected;
      double seen = rareEcho ? echoes : rows - echoes;
      double deviance = 2 * ((seen > 0 ? seen * Math.log(seen / rare) : 0) - (seen - rare));
      double root = Math.signum(seen - rare) * Math.sqrt(Math.max(0, deviance));
      return (rareEcho ? root : -root) / Math.sqrt(variance / rare);
    }
  }
}
