package simbad.studio.bench;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.Map;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Level;
import simbad.bench.capture.Ranging;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.SweepState;
import simbad.bench.capture.ThresholdFit;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;

/**
 * What a page shows of a sweep: written by the thread that sweeps, read by any as JSON. Equal
 * entries and readings, equal text.
 */
public final class LiveState {
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final String obstacle;
  private final SweepPlan plan;
  private final Map<Integer, ThresholdFit> fits = new HashMap<>();
  private final ObjectNode node = MAPPER.createObjectNode();
  private Ranging ranging;
  private int bearing;
  private long readings;
  private volatile String json = "{}";

  /** Prepares for a sweep of an obstacle, with the speed of sound that holds there at first. */
  public LiveState(String obstacle, SweepPlan plan, Ranging ranging) {
    this.obstacle = obstacle;
    this.plan = plan;
    this.ranging = ranging;
    node.put("reading_cm", "-");
    node.put("readings", 0);
  }

  /** Takes a reading, recorded or not. */
  public synchronized void read(FrameLine.Ping ping) {
    node.put(
        "reading_cm",
        ping.status() == PingStatus.ECHO
            ? Double.toString(Math.rint(1000 * ranging.rangeM(ping.echoUs().orElse(0))) / 10)
            : ping.status().word());
    readings++;
    node.put("readings", readings);
    json = node.toString();
  }

  /** Takes the state of the sweep after an entry. */
  public synchronized void take(Entry entry, SweepState state) {
    if (entry instanceof Entry.Done done) {
      if (!state.levels(done.bearing()).isEmpty()) {
        fits.put(done.bearing(), ThresholdFit.of(state.levels(done.bearing()), plan));
      }
      bearing = state.nextBearing(plan).orElse(done.bearing());
    } else if (entry instanceof Entry.Taken taken) {
      bearing = taken.bearing();
      ranging = Ranging.of(taken.temperatureC(), ranging.mode());
    } else if (entry instanceof Entry.Undone undone) {
      bearing = undone.bearing();
    } else if (entry instanceof Entry.Repeated repeated) {
      bearing = repeated.bearing();
    }
    write(state);
  }

  /** Shows what a sweep came to before it was gone on with. */
  public synchronized void show(SweepState state) {
    bearing = state.nextBearing(plan).orElse(0);
    write(state);
  }

  private void write(SweepState state) {
    node.put("obstacle", obstacle);
    node.put("bearings", plan.bearings());
    node.put("pings_each", plan.pings());
    node.put("done", state.doneCount());
    node.put("pings", state.pings());
    node.put("bearing_deg", plan.bearingDeg(bearing));
    writeLevels(state);
    ArrayNode points = node.putArray("points");
    for (int i = 0; i < plan.bearings(); i++) {
      if (state.isDone(i) && !state.levels(i).isEmpty()) {
        ThresholdFit fit = fits.computeIfAbsent(i, at -> ThresholdFit.of(state.levels(at), plan));
        points
            .addArray()
            .add(plan.bearingDeg(i))
            .add(fit.thresholdM())
            .add(fit.lowM())
            .add(fit.highM());
      }
    }
    json = node.toString();
  }

  /**
   * What was tried at the bearing under way: distance, pings, how many were heard, whether lost.
   */
  private void writeLevels(SweepState state) {
    ArrayNode levels = node.putArray("levels");
    for (Level level : state.levels(bearing)) {
      boolean lost = level.pings() - level.heard() >= plan.misses();
      levels.addArray().add(level.distanceM()).add(level.pings()).add(level.heard()).add(lost);
    }
  }

  /** Returns all of it as a JSON object. */
  public String json() {
    return json;
  }
}
