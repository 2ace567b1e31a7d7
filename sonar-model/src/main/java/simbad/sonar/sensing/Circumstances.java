package simbad.sonar.sensing;

import java.util.Optional;
import java.util.OptionalDouble;
import simbad.sonar.check.Checks;

/**
 * What else is known of a reading: columns of the second format, each of which may be missing.
 *
 * @param isTimed whether the row has a time; of one that has none the time is 0 and means nothing
 * @param placement rows with the same word were taken without anything being moved; empty where the
 *     log does not say
 * @param temperatureC of the air, degrees Celsius
 * @param obstacle how the first obstacle stood
 * @param gapS from the trigger of the ping before to this one's, seconds
 * @param pauseS from the end of the echo before to this trigger, seconds
 */
public record Circumstances(
    boolean isTimed,
    Optional<String> placement,
    OptionalDouble temperatureC,
    MovedObstacle obstacle,
    OptionalDouble gapS,
    OptionalDouble pauseS) {
  /** Refuses what is no number. */
  public Circumstances {
    Checks.finite("temperatureC", temperatureC);
    Checks.finite("gapS", gapS);
    Checks.finite("pauseS", pauseS);
  }

  /** A row with a time, of which nothing else is known. */
  public static final Circumstances NONE =
      new Circumstances(
          true,
          Optional.empty(),
          OptionalDouble.empty(),
          MovedObstacle.UNMOVED,
          OptionalDouble.empty(),
          OptionalDouble.empty());

  /** Returns the same with the first obstacle as the scene has it. */
  public Circumstances withObstacle(MovedObstacle other) {
    return new Circumstances(isTimed, placement, temperatureC, other, gapS, pauseS);
  }
}
