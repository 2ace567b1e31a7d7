package simbad.sim;

import java.util.Arrays;
import java.util.Collection;
import java.util.EnumSet;
import java.util.Locale;
import java.util.Set;

/**
 * Habits of the original that are mended here and can be had back, each by its own switch: by
 * {@link EnvironmentDescription#compatibility} for one environment or by the system property
 * {@value #PROPERTY} for a whole program.
 */
public enum Compatibility {
  /** Robots drive through robots and balls. */
  ROBOTS_PASS_ROBOTS,

  /** A robot whose way is blocked does not turn either. */
  BLOCKED_ROBOTS_DO_NOT_TURN,

  /** Static objects stop agents even if they can be traversed; lines never do. */
  TRAVERSABLE_OBJECTS_STOP,

  /** A range sensor without an echo measures infinity, whatever its flags are. */
  NO_ECHO_IS_INFINITE,

  /** Boxes and walls change the vector and the colour that they are made from. */
  ARGUMENTS_CHANGE,

  /**
   * With physics on, weight and friction accelerate a body in proportion to its mass, and a step's
   * displacement is that of the velocity at its end.
   */
  GRAVITY_GROWS_WITH_MASS,

  /** With physics on, friction drives a body back and forth instead of stopping it. */
  FRICTION_NEVER_STOPS;

  /**
   * The system property: names of switches in lower case with hyphens, separated by commas, or
   * {@code released-1.4} for all of them, or {@code upstream} for all but {@code
   * no-echo-is-infinite}.
   */
  public static final String PROPERTY = "simbad.compat";

  /**
   * Reads a list of switches as in {@link #PROPERTY}.
   *
   * @param text the list; may be empty
   * @return a new set, which may be changed
   * @throws IllegalArgumentException if a name is unknown
   */
  public static Set<Compatibility> parse(String text) {
    Set<Compatibility> switches = EnumSet.noneOf(Compatibility.class);
    Arrays.stream(text.split(",", -1))
        .map(String::strip)
        .filter(name -> !name.isEmpty())
        .forEach(name -> switches.addAll(named(name)));
    return switches;
  }

  private static Collection<Compatibility> named(String name) {
    return switch (name) {
      case "released-1.4" -> EnumSet.allOf(Compatibility.class);
      case "upstream" -> EnumSet.complementOf(EnumSet.of(NO_ECHO_IS_INFINITE));
      default ->
          Arrays.stream(values())
              .filter(value -> value.switchName().equals(name))
              .findFirst()
              .map(EnumSet::of)
              .orElseThrow(() -> new IllegalArgumentException(unknown(name)));
    };
  }

  private static String unknown(String name) {
    return PROPERTY
        + " = "
        + name
        + " is none of released-1.4, upstream, "
        + String.join(
            ", ", Arrays.stream(values()).map(Compatibility::switchName).toArray(String[]::new));
  }

  /** Returns the name as {@link #PROPERTY} has it. */
  public String switchName() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  /** Returns a new set of what the system property switches on. */
  static Set<Compatibility> fromProperty() {
    return parse(System.getProperty(PROPERTY, ""));
  }
}
