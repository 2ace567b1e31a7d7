package simbad.sonar.predict;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.jspecify.annotations.Nullable;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.model.NominalModel;
import simbad.sonar.ping.ArrivalChange;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Deviations;
import simbad.sonar.ping.EchoChange;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LossChange;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.MixtureChange;
import simbad.sonar.ping.Moment;
import simbad.sonar.ping.RangeChange;
import simbad.sonar.ping.ThresholdChange;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SonarSpec;

/**
 * The nominal model with changes, for single pings: what may be read, given what was read before.
 *
 * <p>Holds buffers; for one thread.
 */
final class PingModel {
  /** What scatters by more may be nearest to several obstacles: it is asked at so many places. */
  private static final double NEAR_M = 0.05;

  private static final int PLACES = 12;

  private final Geometry geometry;
  private final double noiseM;
  private final NominalModel nominal;
  private final @Nullable LevelHearing levels;
  private final ThresholdChange[] thresholds;
  private final EchoChange[] echoes;
  private final ArrivalChange[] arrivalChanges;
  private final LossChange[] losses;
  private final MixtureChange[] detours;
  private final RangeChange[] ranges;

  /** The same as they are at the ping that is mixed. */
  private final RangeChange[] rangesNow;

  private final MixtureChange[] strangers;
  private final @Nullable Hysteresis hysteresis;
  private final boolean fromOrigin;

  /** Whether what is done to the readings moves them, and leaves how many there are. */
  private final boolean onlyRanges;

  private final @Nullable Answers known;
  private final Arrivals arrivals = new Arrivals();

  private final Mixture origin = new Mixture();
  private final Moment moment;

  /** By obstacle: how probable it is that the ping before heard it. */
  private final double[] heardShare;

  /**
   * Creates a model.
   *
   * @param geometry of the pings
   * @param sensor its figures under the changes
   * @param changes what is different in the world
   * @param known what obstacles answer as far as another model has found it; null to find all anew
   */
  PingModel(
      Geometry geometry,
      SonarSpec sensor,
      List<? extends Change> changes,
      @Nullable Answers known) {
    this.known = known;
    if (known != null) {
      known.under(geometry, changes);
    }
    this.geometry = geometry;
    noiseM = sensor.rangeNoiseM();
    nominal = new NominalModel(sensor, new Scene(List.of()));
    thresholds = Change.only(ThresholdChange.class, changes).toArray(ThresholdChange[]::new);
    levels = geometry.ears() == null ? null : new LevelHearing(geometry, sensor, changes);
    echoes = Change.only(EchoChange.class, changes).toArray(EchoChange[]::new);
    arrivalChanges = Change.only(ArrivalChange.class, changes).toArray(ArrivalChange[]::new);
    losses = Change.only(LossChange.class, changes).toArray(LossChange[]::new);
    detours =
        Change.only(MixtureChange.class, changes).stream()
            .filter(MixtureChange::beforeRange)
            .toArray(MixtureChange[]::new);
    strangers =
        Change.only(MixtureChange.class, changes).stream()
            .filter(change -> !change.beforeRange())
            .toArray(MixtureChange[]::new);
    ranges =
        Change.only(RangeChange.class, changes).stream()
            .sorted(Comparator.comparingInt(RangeChange::order))
            .toArray(RangeChange[]::new);
    rangesNow = ranges.clone();
    Memory memory = Memory.of(changes);
    hysteresis = memory.hysteresis();
    fromOrigin = memory.ghosts() && !memory.asRead();
    onlyRanges = detours.length == 0 && strangers.length == 0 && !fromOrigin;
    moment = new Moment(geometry);
    heardShare = new double[geometry.obstacles()];
  }

  Geometry geometry() {
    return geometry;
  }

  /**
   * Returns whether all pings with nothing in the cone, after pings without an echo, may read the
   * same.
   */
  boolean emptyOnesAreAlike() {
    return (arrivalChanges.length == 0 || losses.length == 0)
        && Arrays.stream(arrivalChanges).noneMatch(ArrivalChange::hangsOnPose);
  }

  /** Returns whether what is done to the readings moves them, and leaves how many there are. */
  boolean onlyRanges() {
    return onlyRanges;
  }

  /**
   * Mixes what a ping may read.
   *
   * @param ping index
   * @param heardBefore whether the ping before was answered
   * @param before what was read before; no part for a no-echo
   * @param lost share of pings that are lost beside the losses of the changes
   * @param into takes the mixture, in measured ranges
   */
  void mix(int ping, boolean heardBefore, Mixture before, double lost, Mixture into) {
    arrive(ping, heardBefore, before, true);
    mix(lost, true, into);
  }

  /**
   * Finds what arrives of a ping: the first part of {@link #mix(int, boolean, Mixture, double,
   * Mixture)}.
   *
   * @param ping index
   * @param heardBefore whether the ping before was answered
   * @param before what was read before; no part for a no-echo
   * @param ranged whether it matters where, and not only whether an echo is read
   */
  void arrive(int ping, boolean heardBefore, Mixture before, boolean ranged) {
    arrivals.clear();
    if (ranged || !onlyRanges) {
      for (int i = 0; i < ranges.length; i++) {
        rangesNow[i] = ranges[i].at(geometry, ping);
      }
    }
    if (hysteresis != null && heardBefore) {
      hear(ping, before);
    }
    boolean placed = ranged || !onlyRanges || arrivalChanges.length > 0;
    if (known == null || hysteresis != null) {
      answer(ping, heardBefore, placed);
    } else if (!known.take(ping, placed, arrivals)) {
      answer(ping, false, placed);
      known.keep(ping, placed, arrivals);
    }
    moment.set(ping, fromOrigin ? origin(before) : before);
    for (ArrivalChange change : arrivalChanges) {
      change.add(moment, arrivals);
    }
  }

  private void answer(int ping, boolean heardBefore, boolean placed) {
    if (levels == null) {
      arrive(ping, heardBefore);
    } else {
      arrive(levels, ping, heardBefore, placed);
    }
  }

  /**
   * Mixes what may be read of what has arrived last: the second part.
   *
   * @param lost share of pings that are lost beside the losses of the changes
   * @param ranged whether it matters where; else only the shares' sum is right
   * @param into takes the mixture, in measured ranges
   */
  void mix(double lost, boolean ranged, Mixture into) {
    arrivals.mix(into);
    lose(moment.ping(), lost, into);
    if (ranged || !onlyRanges) {
      read(into);
    }
  }

  private void arrive(int ping, boolean heardBefore) {
    int end = (ping + 1) * geometry.obstacles();
    for (int line = ping * geometry.obstacles(); line < end; line++) {
      if (geometry.nearestM(line) < Double.POSITIVE_INFINITY) {
        double heard = heardBefore ? heardShare[line % heardShare.length] : 0;
        arrivals.add(geometry.nearestM(line), 0, echoProbability(line, heard));
      }
    }
  }

  private void arrive(LevelHearing hearing, int ping, boolean heardBefore, boolean placed) {
    hearing.clear();
    int end = (ping + 1) * geometry.obstacles();
    for (int line = ping * geometry.obstacles(); line < end; line++) {
      if (hearing.isInRange(line)) {
        double heard = heardBefore ? heardShare[line % heardShare.length] : 0;
        hearing.add(line, factor(line), hysteresis, heard, share(line));
      }
    }
    hearing.into(arrivals, placed);
  }

  /**
   * Which obstacles the ping before heard: the one whose distance it read, as far as that is known,
   * and those behind, which nobody can tell of.
   */
  private void hear(int ping, Mixture before) {
    double all = before.echoShare();
    if (heardShare.length == 1 || !(all > 0)) {
      Arrays.fill(heardShare, 1);
      return;
    }
    Arrays.fill(heardShare, 0);
    int first = ping * geometry.obstacles();
    for (int part = 0; part < before.size(); part++) {
      double half = Math.sqrt(3) * before.deviationM(part) + before.halfWidthM(part);
      int places = half > NEAR_M ? PLACES : 1;
      for (int place = 0; place < places; place++) {
        double read = before.meanM(part) + half * ((2 * place + 1.0) / places - 1);
        hear(first, read, before.share(part) / (all * places));
      }
    }
  }

  private void hear(int first, double readM, double share) {
    double answeredM = answeredM(first, readM);
    for (int obstacle = 0; obstacle < heardShare.length; obstacle++) {
      double distance = geometry.nearestBeforeM(first + obstacle);
      boolean heard = distance >= answeredM && distance < Double.POSITIVE_INFINITY;
      heardShare[obstacle] += heard ? share : 0;
    }
  }

  /** The distance of the obstacle before a ping that is nearest to what was read there. */
  private double answeredM(int first, double readM) {
    double answered = Double.POSITIVE_INFINITY;
    for (int line = first; line < first + geometry.obstacles(); line++) {
      double distance = geometry.nearestBeforeM(line);
      if (Math.abs(distance - readM) < Math.abs(answered - readM)) {
        answered = distance;
      }
    }
    return answered;
  }

  private double echoProbability(int line, double heardBefore) {
    double threshold = geometry.thresholdM(line);
    for (ThresholdChange change : thresholds) {
      threshold *= change.factor(geometry, line);
    }
    double probability = nominally(line, threshold, heardBefore);
    for (EchoChange change : echoes) {
      probability *= change.share(geometry, line);
    }
    return probability;
  }

  private double factor(int line) {
    double factor = 1;
    for (ThresholdChange change : thresholds) {
      factor *= change.factor(geometry, line);
    }
    return factor;
  }

  private double share(int line) {
    double share = 1;
    for (EchoChange change : echoes) {
      share *= change.share(geometry, line);
    }
    return share;
  }

  private double nominally(int line, double thresholdM, double heardBefore) {
    double nearest = geometry.nearestM(line);
    double centre = geometry.centreDistanceM(line);
    if (hysteresis == null) {
      return nominal.echoProbability(nearest, centre, thresholdM);
    }
    double probability = 0;
    if (heardBefore > 0) {
      double held = hysteresis.thresholdM(thresholdM, true);
      probability = heardBefore * nominal.echoProbability(nearest, centre, held);
    }
    if (heardBefore < 1) {
      double pickedUp = hysteresis.thresholdM(thresholdM, false);
      probability += (1 - heardBefore) * nominal.echoProbability(nearest, centre, pickedUp);
    }
    return probability;
  }

  /** The distance that a reading belongs to: its echo's, before it was scaled and shifted. */
  private Mixture origin(Mixture reading) {
    origin.clear();
    for (int part = 0; part < reading.size(); part++) {
      double range = reading.meanM(part);
      for (int i = rangesNow.length - 1; i >= 0; i--) {
        range = rangesNow[i].rangeM(range);
      }
      origin.add(range, reading.deviationM(part), reading.share(part));
    }
    return origin;
  }

  private void lose(int ping, double lost, Mixture into) {
    double kept = 1 - lost;
    for (LossChange change : losses) {
      kept *= 1 - change.share(geometry, ping);
    }
    if (kept != 1) {
      into.scaleShares(kept);
    }
  }

  private void read(Mixture into) {
    for (MixtureChange change : detours) {
      change.apply(moment, into);
    }
    for (int part = 0; part < into.size(); part++) {
      double range = into.meanM(part);
      double deviation = Deviations.together(noiseM, into.deviationM(part));
      for (RangeChange change : rangesNow) {
        deviation = change.deviationM(range, deviation);
        range = change.meanM(range);
      }
      into.move(part, range, deviation);
    }
    for (MixtureChange change : strangers) {
      change.apply(moment, into);
    }
  }
}
