package simbad.blindworld.wave;

import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/**
 * A hard, upright target. Its echo is the Kirchhoff integral over the elements of its outline that
 * the sonar sees (physical optics; Pierce, Acoustics, 1989, section 5-2), each with the directivity
 * at its own angle, out and back, and the phase of its own way; where faces look at each other, the
 * sound that goes from one to the other as well, by mirroring the sonar in the first.
 */
public final class Target implements Reflector {

  private final Outline outline;
  private final Upright upright;
  private final Point place;
  private final double turnRad;

  /** A target as it stands: its outline, its height, where its origin is, and its turn. */
  public Target(Outline outline, Upright upright, Point place, double turnRad) {
    this.outline = outline;
    this.upright = upright;
    this.place = place;
    this.turnRad = Checks.finite("turn", turnRad);
  }

  /** The same target moved by so much. */
  public Target moved(double byXM, double byZM) {
    return new Target(outline, upright, new Point(place.xM() + byXM, place.zM() + byZM), turnRad);
  }

  /** The same target turned by so much, counter-clockwise. */
  public Target turned(double byRad) {
    return new Target(outline, upright, place, turnRad + byRad);
  }

  /** Another outline in the same place. */
  public Target with(Outline other) {
    return new Target(other, upright, place, turnRad);
  }

  /** Its cross-section. */
  public Outline outline() {
    return outline;
  }

  /** Where its origin stands. */
  public Point place() {
    return place;
  }

  @Override
  public Trace arrivals(Pose pose, Medium medium, double tS) {
    Gear.Pistons pistons = medium.gear().pistons();
    Listener sender = Listener.at(pose, pistons.axisRad());
    Listener receiver = Listener.at(pose, pistons.axisRad() + pistons.receiverAxisRad());
    return between(sender, receiver, medium);
  }

  /** Echoes of what goes out from one listener's place and comes back to another's. */
  Trace between(Listener sender, Listener receiver, Medium medium) {
    double wayM = distanceM(sender) + distanceM(receiver);
    double least = wayM - 2 * outline.radiusM;
    double most = wayM + 4 * outline.radiusM;
    int first = (int) Math.floor(medium.cyclesAfter(Math.max(0, least))) - 1;
    int last = (int) Math.ceil(medium.cyclesAfter(most)) + 2;
    Trace trace = new Trace(first, last - first);
    Sum sum = new Sum(trace, medium, medium.over(upright));
    Listener out = own(sender);
    Listener in = own(receiver);
    sum.add(outline, out, in);
    for (Outline.Face mirror : outline.faces) {
      if (outline.sees(mirror, out.xM(), out.zM())) {
        sum.addBy(mirror, outline, out.mirrored(mirror), in);
      }
    }
    return trace;
  }

  private double distanceM(Listener listener) {
    return StrictMath.hypot(listener.xM() - place.xM(), listener.zM() - place.zM());
  }

  /** A listener in the target's own frame. */
  private Listener own(Listener listener) {
    double cos = StrictMath.cos(turnRad);
    double sin = StrictMath.sin(turnRad);
    double dx = listener.xM() - place.xM();
    double dz = listener.zM() - place.zM();
    return new Listener(
        dx * cos - dz * sin,
        dx * sin + dz * cos,
        listener.axisX() * cos - listener.axisZ() * sin,
        listener.axisX() * sin + listener.axisZ() * cos);
  }
}
