package simbad.blindworld.world;

import java.util.List;
import java.util.random.RandomGenerator;

/** Pings as a world would begin them. */
public final class AnyPing {

  /** For changes that do not look at it: the first of an empty recording. */
  public static final Ping FIRST = new Ping(new Recording(List.of()), new Chance(1), 1);

  private static final Pose ORIGIN = new Pose(0, 0, 0);

  private AnyPing() {}

  /** One at a time within a run, so many pings after the first of its track. */
  public static Ping at(RandomGenerator chance, double tS, int index) {
    return begun(chance, tS, index, ORIGIN, Ping.Motion.NONE);
  }

  /** The first one, at a pose. */
  public static Ping from(RandomGenerator chance, Pose pose) {
    return begun(chance, 0, 0, pose, Ping.Motion.NONE);
  }

  /** The first one, of a transducer that moves. */
  public static Ping moving(double speedMPerS, double turnRadPerS) {
    return begun(new Chance(1), 0, 0, ORIGIN, new Ping.Motion(speedMPerS, turnRadPerS));
  }

  /** The second one, after one that read something and heard the first of two obstacles or not. */
  public static Ping after(RandomGenerator chance, double lastReadingM, boolean heard) {
    Ping ping = at(chance, 0, 0);
    ping.nearest(sights(1, 2), new boolean[] {heard, false});
    ping.end(lastReadingM);
    ping.begin(0, 1, ORIGIN, Ping.Motion.NONE);
    return ping;
  }

  /** One that hears two obstacles at these distances. */
  public static Ping hearing(RandomGenerator chance, double oneM, double otherM) {
    Ping ping = at(chance, 0, 0);
    ping.nearest(sights(oneM, otherM), new boolean[] {true, true});
    return ping;
  }

  private static List<Sight> sights(double oneM, double otherM) {
    return List.of(new Sight(0, 9, 0, oneM, 0, 1), new Sight(1, 9, 0, otherM, 0, 1));
  }

  private static Ping begun(
      RandomGenerator chance, double tS, int index, Pose pose, Ping.Motion motion) {
    Ping ping = new Ping(new Recording(List.of(new Row("r", "s", tS, pose))), chance, 2);
    ping.begin(0, index, pose, motion);
    return ping;
  }
}
