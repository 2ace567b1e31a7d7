package simbad.blindworld.wave;

import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;

/** The echo of a target that goes one of its ways by a flat board. */
public final class Mirrored implements Reflector {

  private final Target target;
  private final Outline.Face board;

  /** A target's echo by a board between two points. */
  public Mirrored(Target target, Point from, Point to) {
    this.target = target;
    this.board = new Outline.Face(from, to);
  }

  @Override
  public Trace arrivals(Pose pose, Medium medium, double tS) {
    Gear.Pistons pistons = medium.gear().pistons();
    Listener sender = Listener.at(pose, pistons.axisRad());
    Listener receiver = Listener.at(pose, pistons.axisRad() + pistons.receiverAxisRad());
    Listener behind = receiver.mirrored(board);
    Point place = target.place();
    if (!board.parts(behind.xM(), behind.zM(), place.xM(), place.zM())
        || board.parts(sender.xM(), sender.zM(), place.xM(), place.zM())) {
      return Trace.silent();
    }
    Trace there = target.between(sender, behind, medium);
    Trace both = new Trace(there.first(), there.length());
    both.add(there, 1);
    both.add(target.between(sender.mirrored(board), receiver, medium), 1);
    return both;
  }
}
