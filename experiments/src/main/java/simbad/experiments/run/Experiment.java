package simbad.experiments.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import simbad.experiments.control.Controller;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.obstacles.ObstacleType;

/** The main job: every obstacle with every sensor. */
public final class Experiment {
  private Experiment() {}

  /**
   * Runs all of it on all cores. The results do not depend on how many there are.
   *
   * @param settings what to do
   * @param done is told of each result as it comes, from any thread
   * @return the results, obstacle by obstacle, in the order of the settings
   */
  public static List<RunResult> run(RunSettings settings, Consumer<RunResult> done) {
    record Task(ObstacleType type, SensorKind sensor) {}
    List<Task> tasks = new ArrayList<>();
    for (ObstacleType type : settings.obstacles()) {
      settings.sensors().forEach(sensor -> tasks.add(new Task(type, sensor)));
    }
    List<RunResult> results =
        tasks.parallelStream()
            .map(
                task -> {
                  RunResult result = runOne(task.type(), task.sensor(), settings);
                  done.accept(result);
                  return result;
                })
            .toList();
    return results.stream().map(result -> compared(result, results)).toList();
  }

  private static RunResult runOne(ObstacleType type, SensorKind sensor, RunSettings settings) {
    Circuit circuit = Circuit.of(type, sensor, settings);
    Controller follower = new EdgeFollower(Tuning.standard(settings.speedMPerS(), Circuit.STEP_S));
    Trace trace = circuit.drive(follower, settings.pace(), settings.keepsReadings());
    return new RunResult(
        type,
        sensor,
        trace,
        circuit.errors(trace),
        DetectionMap.of(type, sensor, settings),
        OptionalDouble.empty());
  }

  private static RunResult compared(RunResult result, List<RunResult> all) {
    Optional<RunResult> original =
        all.stream()
            .filter(other -> other.sensor().equals(SensorKind.ORIGINAL))
            .filter(other -> other.type().equals(result.type()))
            .findFirst();
    return original.map(other -> result.against(other.errors())).orElse(result);
  }
}
