package simbad.blindworld.effect;

import java.util.List;
import java.util.Map;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Pose;

/** Things that are not in the scene: unmodelled-object. */
final class ObjectForms {

  private ObjectForms() {}

  static List<Form> all() {
    return List.of(
        Form.anywhere("unmodelled-object", "board", ObjectForms::board),
        Form.anywhere("unmodelled-object", "wall", ObjectForms::wall),
        Form.anywhere("unmodelled-object", "post", ObjectForms::post));
  }

  private static Drawn board(Circumstances c) {
    return plane(c, c.sized(c.between(0.3, 0.6)));
  }

  private static Drawn wall(Circumstances c) {
    return plane(c, c.strength() > 0 ? 1000 : 0);
  }

  /** A plane answers from the foot of the normal, when that lies on it and in the beam. */
  private static Drawn plane(Circumstances c, double halfWidthM) {
    Pose face = place(c, 0.5, 1.7);
    double reach = Math.min(c.sensor().maxRangeM(), c.between(2.2, 4));
    double square = c.sensor().halfAngleRad() * c.between(0.5, 1);
    double p = c.between(0.85, 1);
    return new Drawn(
        Map.of(
            "x",
            face.xM(),
            "z",
            face.zM(),
            "normal",
            Math.toDegrees(face.headingRad()),
            "halfwidth",
            halfWidthM,
            "square_deg",
            Math.toDegrees(square),
            "p",
            p),
        Changes.echo(
            (d, ping) -> {
              double away = planeM(face, halfWidthM, square, ping.pose());
              boolean answers = away <= reach && ping.random().nextDouble() < p;
              return answers ? Math.min(d, away) : d;
            }));
  }

  /** The distance to the plane's foot point; infinite when it is not seen squarely or not on it. */
  static double planeM(Pose face, double halfWidthM, double squareRad, Pose from) {
    double dx = from.xM() - face.xM();
    double dz = from.zM() - face.zM();
    double cos = StrictMath.cos(face.headingRad());
    double sin = StrictMath.sin(face.headingRad());
    double before = dx * cos - dz * sin;
    double along = dx * sin + dz * cos;
    double slant = Math.IEEEremainder(from.headingRad() - face.headingRad() - Math.PI, 2 * Math.PI);
    boolean seen = before > 0 && Math.abs(along) < halfWidthM && Math.abs(slant) <= squareRad;
    return seen ? before : Double.POSITIVE_INFINITY;
  }

  /** A round post answers from its nearest side while it is in the beam's middle. */
  private static Drawn post(Circumstances c) {
    Pose at = place(c, 0.5, 1.6);
    double radius = c.between(0.02, 0.08);
    double reach = Math.min(c.sensor().maxRangeM(), c.sized(c.between(1.2, 2.6)));
    double square = c.sensor().halfAngleRad() * c.between(0.6, 1);
    double p = c.between(0.85, 1);
    return new Drawn(
        Map.of("x", at.xM(), "z", at.zM(), "radius", radius, "reach", reach, "p", p),
        Changes.echo(
            (d, ping) -> {
              double away = postM(at, radius, square, ping);
              boolean answers = away <= reach && ping.random().nextDouble() < p;
              return answers ? Math.min(d, away) : d;
            }));
  }

  private static double postM(Pose at, double radiusM, double squareRad, Ping ping) {
    Pose from = ping.pose();
    double towards = StrictMath.atan2(from.zM() - at.zM(), at.xM() - from.xM());
    double beside = Math.abs(Math.IEEEremainder(towards - from.headingRad(), 2 * Math.PI));
    double away = from.distanceM(at) - radiusM;
    return beside <= squareRad && away > 0.02 ? away : Double.POSITIVE_INFINITY;
  }

  /** Somewhere beside an obstacle, facing roughly towards it. */
  private static Pose place(Circumstances c, double least, double most) {
    Obstacle near = c.someObstacle();
    double direction = c.between(0, 2 * Math.PI);
    double away = c.between(least, most);
    return new Pose(
        near.place().xM() + away * StrictMath.cos(direction),
        near.place().zM() - away * StrictMath.sin(direction),
        direction + Math.PI + c.between(-0.9, 0.9));
  }
}
