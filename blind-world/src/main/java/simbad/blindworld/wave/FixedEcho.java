package simbad.blindworld.wave;

import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Pose;

/**
 * An echo that goes with the sonar: the floor before it, or the robot's own body.
 *
 * @param distanceM half its way
 * @param excessDb its level over the threshold at that time
 * @param restlessDb by which that scatters from ping to ping
 */
public record FixedEcho(double distanceM, double excessDb, double restlessDb) implements Reflector {
  /** Refuses what is no such thing. */
  public FixedEcho {
    Checks.notNegative("distance", distanceM);
    Checks.finite("excess", excessDb);
    Checks.notNegative("restlessness", restlessDb);
  }

  @Override
  public Trace arrivals(Pose pose, Medium medium, double tS) {
    double cycles = medium.cyclesAfter(2 * distanceM);
    double time = cycles / medium.gear().burst().frequencyHz();
    double threshold = medium.gear().receiver().thresholdAt(time);
    double size = threshold * StrictMath.pow(10, excessDb / 20) / medium.pulsePeak();
    double phase = -2 * Math.PI * cycles;
    Trace trace = new Trace((int) Math.floor(cycles), 2);
    double left = size * medium.leftAfter(0);
    trace.add(cycles, left * StrictMath.cos(phase), left * StrictMath.sin(phase));
    return trace;
  }
}
