package simbad.experiments.bench;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.HashMap;
import java.util.Map;
import java.util.OptionalInt;
import simbad.bench.capture.Entry;
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
  private final Ranging ranging;
  private final Map<Integer, ThresholdFit> fits = new HashMap<>();
  private final ObjectNode node = MAPPER.createObjectNode();
  private volatile String json = "{}";

  /** Prepares for a sweep of an obstacle, with the speed of sound that holds there. */
  public LiveState(String obstacle, SweepPlan plan, Ranging ranging) {
    this.obstacle = obstacle;
    this.plan = plan;
    this.ranging = ranging;
    node.put("reading_cm", "-");
  }

  /** Takes a reading, recorded or not. */
  public synchronized void read(FrameLine.Ping ping) {
    node.put(
        "reading_cm",
        ping.status() == PingStatus.ECHO
            ? Double.toString(Math.rint(1000 * ranging.rangeM(ping.echoUs().orElse(0))) / 10)
            : ping.status().word());
    json = node.toString();
  }

  /** Takes the state of the sweep after an entry. */
  public synchronized void take(Entry entry, SweepState state) {
    if (entry instanceof Entry.Done done && !state.levels(done.bearing()).isEmpty()) {
      fits.put(done.bearing(), ThresholdFit.of(state.levels(done.bearing()), plan));
    }
    show(state);
  }

  /** Shows what a sweep came to before it was gone on with. */
  public synchronized void show(SweepState state) {
    node.put("obstacle", obstacle);
    node.put("bearings", plan.bearings());
    node.put("done", state.doneCount());
    node.put("pings", state.pings());
    OptionalInt bearing = state.nextBearing(plan);
    node.put("bearing_deg", bearing.isPresent() ? plan.bearingDeg(bearing.getAsInt()) : 360);
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

  /** Returns all of it as a JSON object. */
  public String json() {
    return json;
  }
}
