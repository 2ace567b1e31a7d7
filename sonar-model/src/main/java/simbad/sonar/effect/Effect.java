package simbad.sonar.effect;

import java.util.Arrays;
import java.util.Optional;

/** The vocabulary: what can be unmodelled, by the name that a diagnosis gives it. */
public enum Effect {
  /** Every range is scaled, as when the air is warmer than assumed. */
  SOUND_SPEED("sound-speed"),
  /** Every range is too long or too short by the same amount. */
  RANGE_OFFSET("range-offset"),
  /** Readings come in coarser steps than believed. */
  COARSE_RESOLUTION("coarse-resolution"),
  /** Ranges scatter more than believed. */
  RANGE_NOISE("range-noise"),
  /** Now and then a reading has nothing to do with the scene. */
  CROSSTALK("crosstalk"),
  /** Some echoes arrive by a longer way than the direct one. */
  MULTIPATH("multipath"),
  /** Echoes are missed, singly or in bursts, whatever the geometry. */
  DROPOUT("dropout"),
  /** All thresholds shrink or grow in proportion. */
  GAIN("gain"),
  /** Far thresholds shrink more than near ones. */
  ABSORPTION("absorption"),
  /** Off the axis the threshold is shorter. */
  BEAM_PATTERN("beam-pattern"),
  /** The cone is wider or narrower than believed. */
  BEAM_WIDTH("beam-width"),
  /** The sensor looks to one side of its believed heading. */
  BEAM_MISALIGNMENT("beam-misalignment"),
  /** The floor answers at a fixed range when nothing nearer does. */
  FLOOR_ECHO("floor-echo"),
  /** Something that is not in the scene answers from a fixed place. */
  UNMODELLED_OBJECT("unmodelled-object"),
  /** A reading belongs to an earlier pose. */
  LATENCY("latency"),
  /** When an echo is missed, the last reading is repeated for a while. */
  STALE_READING("stale-reading"),
  /** An obstacle is picked up at a shorter distance than it is lost at. */
  HYSTERESIS("hysteresis"),
  /** An obstacle is turned otherwise than believed. */
  OBSTACLE_TURN("obstacle-turn"),
  /** An obstacle stands elsewhere than believed. */
  OBSTACLE_OFFSET("obstacle-offset"),
  /** The distances travelled are believed too long or too short. */
  ODOMETRY_SCALE("odometry-scale"),
  /** The believed heading drifts with time. */
  HEADING_DRIFT("heading-drift"),
  /** Near echoes are lost: the real minimum range is longer. */
  DEAD_ZONE("dead-zone"),
  /** Far echoes are lost: the real time-out is shorter. */
  EARLY_TIMEOUT("early-timeout"),
  /** Ranges below a least value are reported as that value. */
  NEAR_CLAMP("near-clamp"),
  /** An echo of the ping before is taken for one of this ping. */
  PREVIOUS_PING("previous-ping"),
  /** The threshold depends on the bearing, while the simulator believes it uniform. */
  ORIENTATION_SHADOW("orientation-shadow"),
  /** A number stands for "no echo". */
  NO_ECHO_CODE("no-echo-code"),
  /** Readings start again from 0 beyond some value. */
  WRAP("wrap"),
  /** Each placement is a little elsewhere than believed, by its own amount. */
  PLACEMENT_ERROR("placement-error"),
  /** Readings are off by whole periods of the carrier. */
  WAVE_HOP("wave-hop");

  private final String word;

  Effect(String word) {
    this.word = word;
  }

  /** Returns the name as it stands in files. */
  public String word() {
    return word;
  }

  /** Finds an effect by its name in files. */
  public static Optional<Effect> find(String word) {
    return Arrays.stream(values()).filter(effect -> effect.word.equals(word)).findFirst();
  }

  @Override
  public String toString() {
    return word;
  }
}
