package simbad.sonar.predict;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;

/**
 * Every history of a few pings with its probability, by plain enumeration: bursts begin and end,
 * each obstacle answers or not, a ghost of the reading before comes or not, a miss is filled with
 * the last echo or not. Ranges have no noise. Shares no code with what it checks.
 */
final class HistoryTree {
  static final double RESOLUTION_M = 0.01;
  static final double EDGE_M = 0.1;
  static final double MISS_RATE = 0.1;

  /** What one obstacle is to one ping. */
  record Target(double nearestM, double centreM, double thresholdM) {
    double answers(double factor) {
      return (1 - MISS_RATE) / (1 + Math.exp((centreM - factor * thresholdM) / EDGE_M));
    }
  }

  /** One ping: its time and the obstacles in the cone. */
  record Ping(double timeS, List<Target> targets) {}

  /** The memory of the world; neutral values for what it has not. */
  record World(
      double burstShare,
      double burstLength,
      double burstDepth,
      double pickUp,
      double hold,
      double stalePings,
      double staleForS,
      double ghostShare,
      double ghostFactor,
      double ghostShiftM) {}

  /** What goes on from ping to ping. */
  private record State(
      boolean burst, boolean heard, OptionalDouble source, int repeated, double echoS) {}

  private record Arrival(double distanceM, double probability) {}

  private final World world;
  private final List<Ping> pings;
  private final Map<List<OptionalDouble>, Double> histories = new HashMap<>();

  HistoryTree(World world, List<Ping> pings) {
    this.world = world;
    this.pings = pings;
    for (boolean burst : new boolean[] {false, true}) {
      double share = burst ? world.burstShare : 1 - world.burstShare;
      State start = new State(burst, false, OptionalDouble.empty(), 0, 0);
      ping(0, start, share, List.of());
    }
  }

  /** All sequences of readings that can be, with their probabilities. */
  Map<List<OptionalDouble>, Double> histories() {
    return histories;
  }

  static double rounded(double rangeM) {
    return Math.floor(rangeM / RESOLUTION_M + 1e-9) * RESOLUTION_M;
  }

  private void ping(int index, State state, double probability, List<OptionalDouble> readings) {
    if (probability == 0) {
      return;
    }
    if (index == pings.size()) {
      histories.merge(readings, probability, Double::sum);
      return;
    }
    double lost = state.burst ? world.burstDepth : 0;
    double silent = 1 - lost;
    for (Arrival arrival : arrivals(index, state)) {
      OptionalDouble source = OptionalDouble.of(arrival.distanceM);
      double first = silent * arrival.probability;
      silent -= first;
      State next = new State(false, true, source, 0, pings.get(index).timeS);
      bursts(index, state, next, probability * first, with(readings, source));
    }
    missed(index, state, probability * (silent + lost), readings);
  }

  private void missed(int index, State state, double probability, List<OptionalDouble> readings) {
    double repeats = 0;
    if (state.source.isPresent() && pings.get(index).timeS - state.echoS <= world.staleForS) {
      repeats = Math.max(0, Math.min(1, world.stalePings - state.repeated));
    }
    State again = new State(false, false, state.source, state.repeated + 1, state.echoS);
    bursts(index, state, again, probability * repeats, with(readings, state.source));
    State nothing = new State(false, false, OptionalDouble.empty(), 0, 0);
    bursts(
        index, state, nothing, probability * (1 - repeats), with(readings, OptionalDouble.empty()));
  }

  private void bursts(
      int index, State before, State next, double probability, List<OptionalDouble> readings) {
    double ends = Math.min(1 / world.burstLength, (1 - world.burstShare) / world.burstShare);
    double begins = ends * world.burstShare / (1 - world.burstShare);
    double silenced = before.burst ? 1 - ends : begins;
    for (boolean burst : new boolean[] {false, true}) {
      State state = new State(burst, next.heard, next.source, next.repeated, next.echoS);
      ping(index + 1, state, probability * (burst ? silenced : 1 - silenced), readings);
    }
  }

  private List<Arrival> arrivals(int index, State state) {
    List<Arrival> arrivals = new ArrayList<>();
    List<Target> targets = pings.get(index).targets;
    for (int i = 0; i < targets.size(); i++) {
      double factor = isHeard(index, i, state) ? world.hold : world.pickUp;
      arrivals.add(new Arrival(targets.get(i).nearestM, targets.get(i).answers(factor)));
    }
    if (state.source.isPresent()) {
      double ghost = state.source.getAsDouble() * world.ghostFactor - world.ghostShiftM;
      if (ghost > 0.02) {
        arrivals.add(new Arrival(ghost, world.ghostShare));
      }
    }
    arrivals.sort((a, b) -> Double.compare(a.distanceM, b.distanceM));
    return arrivals;
  }

  /** The obstacle nearest to what was read is the one that was heard, or one before it. */
  private boolean isHeard(int index, int target, State state) {
    if (!state.heard) {
      return false;
    }
    double read = state.source.orElseThrow();
    List<Target> before = pings.get(index - 1).targets;
    double answered =
        before.stream()
            .map(Target::nearestM)
            .min(Comparator.comparingDouble(distance -> Math.abs(distance - read)))
            .orElseThrow();
    return before.get(target).nearestM >= answered;
  }

  private static List<OptionalDouble> with(List<OptionalDouble> readings, OptionalDouble more) {
    List<OptionalDouble> longer = new ArrayList<>(readings);
    longer.add(more.isPresent() ? OptionalDouble.of(rounded(more.getAsDouble())) : more);
    return longer;
  }
}
