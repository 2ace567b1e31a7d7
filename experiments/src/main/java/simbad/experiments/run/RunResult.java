package simbad.experiments.run;

import java.util.List;
import java.util.OptionalDouble;
import simbad.obstacles.ObstacleType;
import simbad.sonar.check.Checks;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.frame.Placement;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.TableDetection;

/**
 * What one robot made of one obstacle with one sensor.
 *
 * @param type the obstacle
 * @param sensor the sensor
 * @param trace where the robot was
 * @param errors of the trace against the table
 * @param map where the sensor disagrees with the table
 * @param reductionVsOriginal share by which the mean radial error is smaller than the original
 *     sensor's on the same obstacle; empty when that was not run or reached nothing
 */
public record RunResult(
    ObstacleType type,
    SensorKind sensor,
    Trace trace,
    TraceErrors errors,
    DetectionMap map,
    OptionalDouble reductionVsOriginal) {
  /** Checks the reduction. */
  public RunResult {
    Checks.number("reductionVsOriginal", reductionVsOriginal);
  }

  /** Tells whether there is an edge, and the robot found it: else lateral errors mean nothing. */
  public boolean hasLateralErrors() {
    return trace.firstOnEdge() < trace.size() && type.thresholds().table().greatestM() > 0;
  }

  /** Tells whether there is an edge that the robot never found. */
  public boolean missesTheEdge() {
    return trace.firstOnEdge() == trace.size() && type.thresholds().table().greatestM() > 0;
  }

  /** Returns the forms of a diagnosed sensor's model that say nothing of this obstacle. */
  public List<FittedForm> idleForms() {
    return sensor.model().map(model -> model.idleIn(world())).orElse(List.of());
  }

  /** Returns what the robot drove round: the obstacle at the origin, with its table. */
  public Scene world() {
    return new Scene(
        List.of(
            new Obstacle(
                type.name(),
                Placement.IDENTITY,
                type.outline(),
                new TableDetection(type.thresholds().table()))));
  }

  /** The same with the reduction against a run of the original sensor. */
  RunResult against(TraceErrors original) {
    OptionalDouble mine = errors.meanM();
    OptionalDouble theirs = original.meanM();
    OptionalDouble reduction =
        mine.isPresent() && theirs.isPresent() && theirs.getAsDouble() > 0
            ? OptionalDouble.of(1 - mine.getAsDouble() / theirs.getAsDouble())
            : OptionalDouble.empty();
    return new RunResult(type, sensor, trace, errors, map, reduction);
  }
}
