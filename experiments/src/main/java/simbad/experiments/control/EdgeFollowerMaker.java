package simbad.experiments.control;

import java.util.List;
import java.util.Map;

/** Makes {@link EdgeFollower}s; with the standard values, those of the main experiment. */
public final class EdgeFollowerMaker implements ControllerMaker {
  /** The name of the kind. */
  public static final String NAME = "edge-follower";

  private static final String CROSSING_ANGLE = "crossing_angle_deg";
  private static final String CURL = "curl_rad_per_step";
  private static final String TURN_RATE = "turn_rate_deg_per_s";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public List<ControllerParameter> parameters() {
    return List.of(
        new ControllerParameter(CROSSING_ANGLE, 30, 0.1, 89.9),
        new ControllerParameter(CURL, 0.01, 1e-6, 10),
        new ControllerParameter(TURN_RATE, 360, 1, 36000));
  }

  /** The curl is said per step, as the robot knows it, and not per length of way. */
  @Override
  public Controller make(double speedMPerS, double stepS, Map<String, Double> values) {
    return new EdgeFollower(
        new Tuning(
            speedMPerS,
            stepS,
            Math.toRadians(values.getOrDefault(TURN_RATE, 360.0)),
            Math.toRadians(values.getOrDefault(CROSSING_ANGLE, 30.0)),
            values.getOrDefault(CURL, 0.01) / (speedMPerS * stepS)));
  }
}
