package simbad.experiments.batch;

import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.LockSupport;
import simbad.experiments.control.Controller;
import simbad.experiments.control.ControllerMaker;
import simbad.experiments.control.ControllerParameter;

/** A user's controller: drives straight on, and breaks down as its mood says. */
public final class MoodyControllerMaker implements ControllerMaker {
  /** Names the environment variable that stops a process at the first run in mood 3. */
  public static final String WAITS = "MOODY_WAITS";

  @Override
  public String name() {
    return "moody";
  }

  @Override
  public List<ControllerParameter> parameters() {
    return List.of(new ControllerParameter("mood", 0, 0, 3));
  }

  @Override
  public Controller make(double speedMPerS, double stepS, Map<String, Double> values) {
    double mood = values.getOrDefault("mood", 0.0);
    if (mood == 1) {
      throw new IllegalArgumentException("mood = 1 does not go with\nanything");
    }
    return (readings, command) -> {
      if (mood == 2) {
        throw new AssertionError("in a bad mood, \"today\"");
      }
      if (mood == 3) {
        waitWhileTold();
      }
      command.set(speedMPerS, 0);
    };
  }

  /** For as long as the process lives, when its environment says so. */
  private static void waitWhileTold() {
    while (System.getenv(WAITS) != null) {
      LockSupport.park();
    }
  }
}
