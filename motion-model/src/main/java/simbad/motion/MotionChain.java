package simbad.motion;

import java.util.ArrayList;
import java.util.List;

/**
 * Changes, one after the other: a robot with all of them.
 *
 * @param changes in the order in which they act at each stage
 */
public record MotionChain(List<MotionChange> changes) {
  /** A robot that does exactly what it is told. */
  public static final MotionChain EXACT = new MotionChain(List.of());

  /** Copies the list. */
  public MotionChain {
    changes = List.copyOf(changes);
  }

  /** Returns this chain with a change behind. */
  public MotionChain with(MotionChange change) {
    List<MotionChange> longer = new ArrayList<>(changes);
    longer.add(change);
    return new MotionChain(longer);
  }

  /** Returns by how many seconds commands act late. */
  public double delayS() {
    double delay = 0;
    for (MotionChange change : changes) {
      delay = change.delayS(delay);
    }
    return delay;
  }

  /**
   * Returns how speeds follow commands: responses in series, each of which follows what the one
   * before gives; none where speeds are at once what is commanded.
   */
  public List<Response> responses() {
    Response first = Response.AT_ONCE;
    List<Response> responses = new ArrayList<>();
    for (MotionChange change : changes) {
      first = change.response(first);
      responses.add(change.then());
    }
    responses.add(0, first);
    responses.removeIf(Response.AT_ONCE::equals);
    return responses;
  }

  /** Returns the speed over ground, m/s, for the drive's speed and rate. */
  public double speed(double speedMPerS, double turnRadPerS) {
    double speed = speedMPerS;
    for (MotionChange change : changes) {
      speed = change.speed(speed, turnRadPerS);
    }
    return speed;
  }

  /** Returns the rate of turning over ground, rad/s, for the drive's rate and the true speed. */
  public double turn(double turnRadPerS, double speedMPerS) {
    double turn = turnRadPerS;
    for (MotionChange change : changes) {
      turn = change.turn(turn, speedMPerS);
    }
    return turn;
  }

  /** Returns what the tracker reports. */
  public Capture capture() {
    Capture capture = Capture.CENTRE;
    for (MotionChange change : changes) {
      capture = change.capture(capture);
    }
    return capture;
  }
}
