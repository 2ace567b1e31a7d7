package simbad.sonar.predict;

import java.util.List;
import org.jspecify.annotations.Nullable;
import simbad.sonar.ping.Arrivals;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.EchoChange;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.SensorChange;
import simbad.sonar.ping.ThresholdChange;

/**
 * What the obstacles of a scene answer to each ping of a log, kept from one model to the next: most
 * steps of a fit move something that comes later, and the answers are half of the work. For one
 * thread.
 */
public final class Answers {
  /** Of what is known of a ping: only how probable each answer is; 0 for nothing. */
  private static final byte CHANCES = 1;

  private static final byte PLACED = 2;

  private @Nullable Geometry geometry;
  private List<Change> deciding = List.of();
  private byte[] known = {};
  private int[] size = {};
  private double[] distanceM = {};
  private double[] deviationM = {};
  private double[] probability = {};

  /** Knows nothing yet. */
  public Answers() {}

  /**
   * Forgets all that another model would not hear alike.
   *
   * @param of what the model looks at
   * @param changes of the model
   */
  void under(Geometry of, List<? extends Change> changes) {
    List<Change> now = changes.stream().filter(Answers::decides).map(Change.class::cast).toList();
    if (of == geometry && now.equals(deciding)) {
      return;
    }
    geometry = of;
    deciding = now;
    int lines = of.pings() * of.obstacles();
    known = new byte[of.pings()];
    if (distanceM.length != lines || size.length != of.pings()) {
      size = new int[of.pings()];
      distanceM = new double[lines];
      deviationM = new double[lines];
      probability = new double[lines];
    }
  }

  private static boolean decides(Change change) {
    return change instanceof ThresholdChange
        || change instanceof EchoChange
        || change instanceof LevelChange
        || change instanceof SensorChange;
  }

  /**
   * Fills in what is known of a ping.
   *
   * @param ping index
   * @param placed whether it matters where echoes come from
   * @param into takes it
   * @return whether it was known
   */
  boolean take(int ping, boolean placed, Arrivals into) {
    if (known[ping] < (placed ? PLACED : CHANCES)) {
      return false;
    }
    into.take(distanceM, deviationM, probability, first(ping), size[ping]);
    return true;
  }

  /** Keeps what was found of a ping. */
  void keep(int ping, boolean placed, Arrivals from) {
    known[ping] = placed ? PLACED : CHANCES;
    size[ping] = from.put(distanceM, deviationM, probability, first(ping));
  }

  private int first(int ping) {
    return ping * (distanceM.length / known.length);
  }
}
