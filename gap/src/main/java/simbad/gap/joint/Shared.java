package simbad.gap.joint;

import java.util.Locale;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Estimate;

/**
 * A cause that may show in both halves of a joint log.
 *
 * @param name of it, that of its effect of motion
 * @param effect by which the sonar hears it
 * @param parameter with its unit, the same in both halves
 * @param isTracked whether the commands and the track alone show it
 * @param isHeard whether the readings show it
 * @param tracked what commands and track say of its value
 * @param heard what the readings say of it
 * @param isOne whether both are of one value
 */
public record Shared(
    String name,
    Effect effect,
    String parameter,
    boolean isTracked,
    boolean isHeard,
    Estimate tracked,
    Estimate heard,
    boolean isOne) {
  /** Returns the value that both halves say together. */
  public Estimate together() {
    return tracked.and(heard);
  }

  /** Returns whether it is one cause or two, and by what, as a sentence without its full stop. */
  public String words() {
    if (!isOne) {
      return isTracked
          ? name
              + " is seen by the tracker ("
              + value(tracked)
              + ") and not heard in the poses that the robot reckoned ("
              + value(heard)
              + "): the robot knows how far it goes, but the drive does not do what it is told"
          : effect.word()
              + " is heard by the sonar ("
              + value(heard)
              + ") and not seen by the tracker ("
              + value(tracked)
              + "): the robot goes as it is told, but it reckons its poses wrongly";
    }
    String who =
        isTracked && isHeard
            ? "seen by the tracker and heard by the sonar (as " + effect.word() + ")"
            : isTracked
                ? "seen by the tracker; the readings neither confirm nor exclude it"
                : "heard by the sonar (as "
                    + effect.word()
                    + "); the track neither confirms nor excludes it";
    return name + " is one cause, " + who + ": " + parameter + " = " + value(together());
  }

  private static String value(Estimate estimate) {
    if (estimate.deviation() == Double.POSITIVE_INFINITY) {
      return "open";
    }
    return String.format(
        Locale.ROOT,
        "%.5g, 95 %% interval %.5g to %.5g",
        estimate.value(),
        estimate.ci95().low(),
        estimate.ci95().high());
  }
}
