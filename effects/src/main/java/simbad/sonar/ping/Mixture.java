package simbad.sonar.ping;

import java.util.Arrays;
import java.util.Comparator;
import java.util.random.RandomGenerator;
import java.util.stream.IntStream;
import simbad.sonar.model.NormalDistribution;

/**
 * What a reading is drawn from: parts, each with its share, Gaussian or evenly spread; the share
 * that is left reads no echo. Reused from ping to ping.
 */
public final class Mixture {
  /** Of no parts: a sure no-echo. */
  public static final Mixture EMPTY = new Mixture();

  /** Further from its mean a Gaussian holds less than 1e-18. */
  private static final double REACH = 9;

  /** A range that is so little below a step lies in it: sums of ranges are that inexact. */
  private static final double ROUNDING_M = 1e-11;

  /** So many parts are kept as they are. */
  private static final int FEW = 24;

  /** Parts that are nearer than this share of their deviation are hard to tell apart. */
  private static final double NEAR = 0.25;

  private int size;
  private double[] meanM = new double[8];
  private double[] deviationM = new double[8];
  private double[] halfWidthM = new double[8];
  private double[] share = new double[8];

  /** Creates a mixture without parts: a sure no-echo. */
  public Mixture() {}

  /** Takes all parts out. */
  public void clear() {
    size = 0;
  }

  /** Returns the number of parts. */
  public int size() {
    return size;
  }

  /** Returns a part's mean range in metres. */
  public double meanM(int part) {
    return meanM[part];
  }

  /** Returns a part's standard deviation in metres; 0 for a part that is evenly spread. */
  public double deviationM(int part) {
    return deviationM[part];
  }

  /** Returns half the width of an evenly spread part in metres; 0 for a Gaussian one. */
  public double halfWidthM(int part) {
    return halfWidthM[part];
  }

  /** Returns a part's share in [0, 1]. */
  public double share(int part) {
    return share[part];
  }

  /** Returns the probability of an echo. */
  public double echoShare() {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      sum += share[i];
    }
    return sum;
  }

  /** Adds a Gaussian part. */
  public void add(double newMeanM, double newDeviationM, double newShare) {
    put(newMeanM, newDeviationM, 0, newShare);
  }

  /** Adds a Gaussian part of which the share that would lie beyond a range is lost. */
  public void addUpTo(double mostM, double newMeanM, double newDeviationM, double newShare) {
    double heard = QuickNormal.atMost(mostM - newMeanM, newDeviationM);
    if (heard > 0) {
      add(newMeanM, newDeviationM, newShare * heard);
    }
  }

  /** Returns the share of a part that lies at a range or nearer, in [0, 1]. */
  public double below(int part, double mostM) {
    double half = halfWidthM[part];
    return half > 0
        ? Math.max(0, Math.min(1, (mostM - meanM[part] + half) / (2 * half)))
        : QuickNormal.atMost(mostM - meanM[part], deviationM[part]);
  }

  /** Adds an evenly spread part. */
  public void addEven(double lowM, double highM, double newShare) {
    put((lowM + highM) / 2, 0, (highM - lowM) / 2, newShare);
  }

  private void put(double mean, double deviation, double halfWidth, double newShare) {
    if (size == meanM.length) {
      int capacity = 2 * size;
      meanM = Arrays.copyOf(meanM, capacity);
      deviationM = Arrays.copyOf(deviationM, capacity);
      halfWidthM = Arrays.copyOf(halfWidthM, capacity);
      share = Arrays.copyOf(share, capacity);
    }
    meanM[size] = mean;
    deviationM[size] = deviation;
    halfWidthM[size] = halfWidth;
    share[size] = newShare;
    size++;
  }

  /** Multiplies all shares. */
  public void scaleShares(double factor) {
    for (int i = 0; i < size; i++) {
      share[i] *= factor;
    }
  }

  /** Multiplies one part's share. */
  public void scaleShare(int part, double factor) {
    share[part] *= factor;
  }

  /**
   * Moves a share of each Gaussian part; evenly spread parts stay.
   *
   * @param moved share in [0, 1]; 0 changes nothing
   * @param byM what is added to its mean, metres
   * @param addedM standard deviation that adds to its own in squares, metres
   */
  public void moveShare(double moved, double byM, double addedM) {
    int parts = moved == 0 ? 0 : size;
    for (int part = 0; part < parts; part++) {
      if (halfWidthM[part] == 0) {
        double deviation = Deviations.together(deviationM[part], addedM);
        add(meanM[part] + byM, deviation, moved * share[part]);
        share[part] *= 1 - moved;
      }
    }
  }

  /** Gives a Gaussian part another mean and deviation; an evenly spread part stays. */
  public void move(int part, double newMeanM, double newDeviationM) {
    if (halfWidthM[part] == 0) {
      meanM[part] = newMeanM;
      deviationM[part] = newDeviationM;
    }
  }

  /** Returns the standard deviation of an evenly spread part in metres; 0 for a Gaussian one. */
  public double evenSpreadM(int part) {
    return halfWidthM[part] / Math.sqrt(3);
  }

  /** Takes over one part of another mixture with a share of its own. */
  public void addPart(Mixture other, int part, double newShare) {
    put(other.meanM[part], other.deviationM[part], other.halfWidthM[part], newShare);
  }

  /**
   * Takes over another mixture's parts, their shares multiplied; equal parts become one.
   *
   * @param least a part of a smaller share is left out, as a no-echo
   */
  public void merge(Mixture other, double factor, double least) {
    for (int i = 0; i < other.size; i++) {
      double more = factor * other.share[i];
      int same = find(other, i);
      if (same < size) {
        share[same] += more;
      } else if (more > least) {
        addPart(other, i, more);
      }
    }
  }

  /** Returns the share of the part that so many parts exceed; 0 where there are not more. */
  public double shareOfRank(int rank) {
    if (size <= rank) {
      return 0;
    }
    // The greatest shares, the greatest first.
    double[] most = new double[rank + 1];
    for (int part = 0; part < size; part++) {
      double less = share[part];
      for (int i = 0; i <= rank; i++) {
        double own = most[i];
        most[i] = Math.max(own, less);
        less = Math.min(own, less);
      }
    }
    return most[rank];
  }

  /**
   * Makes one part of Gaussian parts that hardly differ, with their mean and variance, where there
   * are many parts: ghosts of ghosts of late echoes are many and blur into one another.
   */
  public void blur() {
    if (size <= FEW) {
      return;
    }
    int[] order =
        IntStream.range(0, size)
            .boxed()
            .sorted(Comparator.comparingDouble(part -> meanM[part]))
            .mapToInt(Integer::intValue)
            .toArray();
    Mixture blurred = new Mixture();
    for (int part : order) {
      int last = blurred.size - 1;
      if (last >= 0 && blurred.isNear(last, this, part)) {
        blurred.join(last, this, part);
      } else {
        blurred.addPart(this, part, share[part]);
      }
    }
    clear();
    for (int part = 0; part < blurred.size; part++) {
      addPart(blurred, part, blurred.share[part]);
    }
  }

  private boolean isNear(int own, Mixture other, int part) {
    double least = Math.min(deviationM[own], other.deviationM[part]);
    double most = Math.max(deviationM[own], other.deviationM[part]);
    return Math.abs(meanM[own] - other.meanM[part]) < NEAR * least && most < (1 + NEAR) * least;
  }

  private void join(int own, Mixture other, int part) {
    double all = share[own] + other.share[part];
    double weight = all > 0 ? other.share[part] / all : 0;
    double apart = other.meanM[part] - meanM[own];
    double variance =
        (1 - weight) * deviationM[own] * deviationM[own]
            + weight * other.deviationM[part] * other.deviationM[part]
            + weight * (1 - weight) * apart * apart;
    meanM[own] += weight * apart;
    deviationM[own] = Math.sqrt(variance);
    share[own] = all;
  }

  private int find(Mixture other, int part) {
    int i = 0;
    while (i < size
        && (meanM[i] != other.meanM[part]
            || deviationM[i] != other.deviationM[part]
            || halfWidthM[i] != other.halfWidthM[part])) {
      i++;
    }
    return i;
  }

  /** Draws a part by the shares; the size of the mixture stands for no echo. */
  public int draw(RandomGenerator random) {
    double draw = random.nextDouble();
    int part = 0;
    while (part < size && draw >= share[part]) {
      draw -= share[part];
      part++;
    }
    return part;
  }

  /** Draws a range from a part. */
  public double drawM(int part, RandomGenerator random) {
    double half = halfWidthM[part];
    return half > 0
        ? meanM[part] + half * (2 * random.nextDouble() - 1)
        : meanM[part] + deviationM[part] * NormalDistribution.draw(random);
  }

  /** Returns the probability that the measured range lies in [lowM, highM). */
  public double within(double lowM, double highM) {
    double sum = 0;
    for (int i = 0; i < size; i++) {
      if (share[i] > 0) {
        sum += share[i] * partWithin(i, lowM, highM);
      }
    }
    return sum;
  }

  /** Returns the probability that the range comes from a part and lies in [lowM, highM). */
  public double within(int part, double lowM, double highM) {
    return share[part] * partWithin(part, lowM, highM);
  }

  private double partWithin(int part, double lowM, double highM) {
    double half = halfWidthM[part];
    if (half > 0) {
      double from = Math.max(lowM, meanM[part] - half);
      double to = Math.min(highM, meanM[part] + half);
      return to > from ? (to - from) / (2 * half) : 0;
    }
    double deviation = deviationM[part];
    if (!(deviation > 0)) {
      double mean = meanM[part] + ROUNDING_M;
      return mean >= lowM && mean < highM ? 1 : 0;
    }
    double low = (lowM - meanM[part]) / deviation;
    double high = (highM - meanM[part]) / deviation;
    if (low > REACH || high < -REACH) {
      return 0;
    }
    return QuickNormal.cumulative(high) - QuickNormal.cumulative(low);
  }
}
