package simbad.definition;

import java.util.Comparator;
import java.util.Map;
import java.util.concurrent.ConcurrentHashMap;
import java.util.regex.Pattern;

/**
 * The name of something that can be unmodelled, as a diagnosis gives it. What there is to know of
 * an effect is in its definition.
 *
 * <p>There is one object for each name, so names may be compared with {@code ==}. The project's own
 * effects come first, in the order of the constants; those of jars follow by name.
 */
public final class Effect implements Comparable<Effect> {
  private static final Map<String, Effect> BY_WORD = new ConcurrentHashMap<>();
  private static final Pattern WORD = Pattern.compile("[a-z][a-z0-9]*(-[a-z0-9]+)*");
  private static final Comparator<Effect> ORDER =
      Comparator.comparingInt((Effect effect) -> effect.order).thenComparing(Effect::word);
  private static final int OF_A_JAR = Integer.MAX_VALUE;

  /** Every range is scaled, as when the air is warmer than assumed. */
  public static final Effect SOUND_SPEED = own("sound-speed", 0);

  /** Every range is too long or too short by the same amount. */
  public static final Effect RANGE_OFFSET = own("range-offset", 1);

  /** Readings come in coarser steps than believed. */
  public static final Effect COARSE_RESOLUTION = own("coarse-resolution", 2);

  /** Ranges scatter more than believed. */
  public static final Effect RANGE_NOISE = own("range-noise", 3);

  /** Now and then a reading has nothing to do with the scene. */
  public static final Effect CROSSTALK = own("crosstalk", 4);

  /** Some echoes arrive by a longer way than the direct one. */
  public static final Effect MULTIPATH = own("multipath", 5);

  /** Echoes are missed, singly or in bursts, whatever the geometry. */
  public static final Effect DROPOUT = own("dropout", 6);

  /** All thresholds shrink or grow in proportion. */
  public static final Effect GAIN = own("gain", 7);

  /** Far thresholds shrink more than near ones. */
  public static final Effect ABSORPTION = own("absorption", 8);

  /** Off the axis the threshold is shorter. */
  public static final Effect BEAM_PATTERN = own("beam-pattern", 9);

  /** The cone is wider or narrower than believed. */
  public static final Effect BEAM_WIDTH = own("beam-width", 10);

  /** The sensor looks to one side of its believed heading. */
  public static final Effect BEAM_MISALIGNMENT = own("beam-misalignment", 11);

  /** The floor answers at a fixed range when nothing nearer does. */
  public static final Effect FLOOR_ECHO = own("floor-echo", 12);

  /** Something that is not in the scene answers from a fixed place. */
  public static final Effect UNMODELLED_OBJECT = own("unmodelled-object", 13);

  /** A reading belongs to an earlier pose. */
  public static final Effect LATENCY = own("latency", 14);

  /** When an echo is missed, the last reading is repeated for a while. */
  public static final Effect STALE_READING = own("stale-reading", 15);

  /** An obstacle is picked up at a shorter distance than it is lost at. */
  public static final Effect HYSTERESIS = own("hysteresis", 16);

  /** An obstacle is turned otherwise than believed. */
  public static final Effect OBSTACLE_TURN = own("obstacle-turn", 17);

  /** An obstacle stands elsewhere than believed. */
  public static final Effect OBSTACLE_OFFSET = own("obstacle-offset", 18);

  /** The distances travelled are believed too long or too short. */
  public static final Effect ODOMETRY_SCALE = own("odometry-scale", 19);

  /** The believed heading drifts with time. */
  public static final Effect HEADING_DRIFT = own("heading-drift", 20);

  /** Near echoes are lost: the real minimum range is longer. */
  public static final Effect DEAD_ZONE = own("dead-zone", 21);

  /** Far echoes are lost: the real time-out is shorter. */
  public static final Effect EARLY_TIMEOUT = own("early-timeout", 22);

  /** Ranges below a least value are reported as that value. */
  public static final Effect NEAR_CLAMP = own("near-clamp", 23);

  /** An echo of the ping before is taken for one of this ping. */
  public static final Effect PREVIOUS_PING = own("previous-ping", 24);

  /** The threshold depends on the bearing, while the simulator believes it uniform. */
  public static final Effect ORIENTATION_SHADOW = own("orientation-shadow", 25);

  /** A number stands for "no echo". */
  public static final Effect NO_ECHO_CODE = own("no-echo-code", 26);

  /** Readings start again from 0 beyond some value. */
  public static final Effect WRAP = own("wrap", 27);

  /** Each placement is a little elsewhere than believed, by its own amount. */
  public static final Effect PLACEMENT_ERROR = own("placement-error", 28);

  /** Readings are off by whole periods of the carrier. */
  public static final Effect WAVE_HOP = own("wave-hop", 29);

  /** Weak echoes read longer than strong ones. */
  public static final Effect RANGE_WALK = own("range-walk", 30);

  /** The target is over or under the beam, or the floor's corner answers. */
  public static final Effect VERTICAL_BEAM = own("vertical-beam", 31);

  /** Ranges drift with the time since power-up. */
  public static final Effect RANGE_DRIFT = own("range-drift", 32);

  private final String word;
  private final int order;

  private Effect(String word, int order) {
    this.word = word;
    this.order = order;
  }

  private static Effect own(String word, int order) {
    Effect effect = new Effect(word, order);
    BY_WORD.put(word, effect);
    return effect;
  }

  /**
   * Returns the effect of a name, for a definition to be made of it.
   *
   * @param word small letters, digits and single hyphens, a letter first
   * @throws IllegalArgumentException for a word that is spelt otherwise
   */
  public static Effect named(String word) {
    if (!WORD.matcher(word).matches()) {
      throw new IllegalArgumentException(
          "an effect's name has small letters, digits and single hyphens, not '" + word + "'");
    }
    return BY_WORD.computeIfAbsent(word, name -> new Effect(name, OF_A_JAR));
  }

  /** Returns the name as it stands in files. */
  public String word() {
    return word;
  }

  @Override
  public int compareTo(Effect other) {
    return ORDER.compare(this, other);
  }

  @Override
  public String toString() {
    return word;
  }
}
