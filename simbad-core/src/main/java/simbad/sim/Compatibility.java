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
  FRICTION_NEVER_STOPS,

  /**
   * With physics on, what a robot hits flies off twice as fast as the robot, and what is pinched
   * may end up within another body.
   */
  IMPACTS_LEAVE_OVERLAPS,

  /** With physics on, friction slows what is in the air, too. */
  FRICTION_IN_THE_AIR,

  /** A reset leaves the phase of the devices' updates as it is, so that episodes differ. */
  RESETS_KEEP_THE_PHASE,

  /**
   * A plan's motion lasts as long as the one before it should, a plan drives on after its end, and
   * what follows {@link Plan#loop()} is never reached.
   */
  PLANS_TIME_BY_PREVIOUS,

  /**
   * Of two agents that are near, the one that was added first is told; the other only if it is the
   * last of all, which then stays near while it stands still.
   */
  NEARNESS_IS_ONE_SIDED,

  /** Rays meet the other robots' bodies as prisms of 15 sides. */
  ROBOTS_ARE_PRISMS,

  /** The red nose floats half a robot's height above the robot. */
  NOSES_FLOAT,

  /** Asking a matrix for its right or lower edge, 1, fails. */
  MATRIX_EDGE_THROWS,

  /** The light sensors to the left and right sit 0.3 m off the robot, as in 1.7, not 0.5 m. */
  LIGHT_SENSORS_SIT_NEARER;

  /**
   * The system property: names of switches in lower case with hyphens, separated by commas, or
   * {@code released-1.4}, {@code upstream} or {@code 1.7} for all that this version of the original
   * had; later names are added.
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
      case "released-1.4" -> EnumSet.complementOf(EnumSet.of(LIGHT_SENSORS_SIT_NEARER));
      case "upstream" ->
          EnumSet.complementOf(EnumSet.of(LIGHT_SENSORS_SIT_NEARER, NO_ECHO_IS_INFINITE));
      case "1.7" -> EnumSet.complementOf(EnumSet.of(TRAVERSABLE_OBJECTS_STOP, NO_ECHO_IS_INFINITE));
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
        + " is none of released-1.4, upstream, 1.7, "
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
