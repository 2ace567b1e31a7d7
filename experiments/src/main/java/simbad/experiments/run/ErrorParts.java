package simbad.experiments.run;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;

/**
 * What of a trace's error comes from hearing and what from moving: the same controller round the
 * same obstacle with the believed sensor on a robot that does what it is told, with the diagnosed
 * sensor alone, on the diagnosed robot alone, and with both.
 *
 * @param believed sensor that is believed, on a robot that does what it is told
 * @param heard the diagnosed sensor on that robot; empty where none was run
 * @param moved the believed sensor on the diagnosed robot
 * @param both the diagnosed sensor on the diagnosed robot; empty where no sensor was diagnosed
 */
public record ErrorParts(
    RunResult believed, Optional<RunResult> heard, RunResult moved, Optional<RunResult> both) {

  /**
   * Finds what was run with and without a robot.
   *
   * @param results of a run
   * @return one for each believed sensor and obstacle, and each diagnosed sensor beside it
   */
  public static List<ErrorParts> of(List<RunResult> results) {
    List<ErrorParts> parts = new ArrayList<>();
    for (RunResult moved : results) {
      Optional<RobotKind> robot = moved.sensor().robot();
      if (robot.isEmpty() || moved.sensor().model().isPresent()) {
        continue;
      }
      Optional<RunResult> believed = find(results, moved, moved.sensor().hearing());
      List<RunResult> diagnosed =
          results.stream()
              .filter(other -> other.type().equals(moved.type()))
              .filter(other -> other.sensor().model().isPresent())
              .filter(other -> other.sensor().robot().isEmpty())
              .toList();
      believed.ifPresent(
          base -> {
            if (diagnosed.isEmpty()) {
              parts.add(new ErrorParts(base, Optional.empty(), moved, Optional.empty()));
            }
            for (RunResult heard : diagnosed) {
              String word = heard.sensor().on(robot.get()).word();
              parts.add(
                  new ErrorParts(base, Optional.of(heard), moved, find(results, moved, word)));
            }
          });
    }
    return parts;
  }

  private static Optional<RunResult> find(List<RunResult> results, RunResult like, String word) {
    return results.stream()
        .filter(other -> other.type().equals(like.type()))
        .filter(other -> other.sensor().word().equals(word))
        .findFirst();
  }

  /** Returns it in a sentence. */
  public String sentence() {
    StringBuilder text =
        new StringBuilder(
            String.format(
                Locale.ROOT,
                "%s, %s sensor on %s: mean error against the table %s as believed",
                believed.type().name(),
                believed.sensor().word(),
                moved.sensor().robot().map(RobotKind::name).orElse(""),
                error(believed)));
    heard.ifPresent(result -> text.append(", " + error(result) + " from hearing alone"));
    text.append(", " + error(moved) + " from moving alone");
    both.ifPresent(result -> text.append(", " + error(result) + " from both together"));
    return text.toString();
  }

  private static String error(RunResult result) {
    OptionalDouble mean = result.errors().meanM();
    if (mean.isEmpty()) {
      return "none (no bearing was reached)";
    }
    String missed =
        result.trace().isClosed()
            ? ""
            : " (the round was not completed: " + unreached(result) + ")";
    return String.format(Locale.ROOT, "%.2f cm%s", 100 * mean.getAsDouble(), missed);
  }

  private static String unreached(RunResult result) {
    return result.errors().unreachedBearings()
        + " of "
        + result.errors().radialM().size()
        + " bearings unreached";
  }
}
