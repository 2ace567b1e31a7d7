package simbad.kernel.belt;

import simbad.kernel.geometry.Ray;
import simbad.kernel.scene.Ball;
import simbad.kernel.scene.BodyScene;
import simbad.kernel.scene.Neighbourhood;
import simbad.kernel.scene.Solid;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.Sensor;
import simbad.sonar.sensing.TransducerPoses;

/**
 * Simbad's own sensor: one thin ray per transducer, no cone, no noise, no memory. An echo carries
 * the distance to the nearest surface along the ray; the carrier's own body is passed through.
 */
public final class RaySensor implements Sensor {
  /** Up to this many parts it is faster to look at each than to descend a tree. */
  private static final int FEW = 24;

  private final BodyScene scene;
  private final Solid carrier;
  private final BeltLayout layout;
  private final Ray ray = new Ray();
  private final Ball reach = new Ball();
  private final Neighbourhood near = new Neighbourhood();

  /**
   * Creates a sensor.
   *
   * @param scene what the rays can meet
   * @param carrier the body that carries the belt
   * @param layout says how long each ray is
   */
  public RaySensor(BodyScene scene, Solid carrier, BeltLayout layout) {
    this.scene = scene;
    this.carrier = carrier;
    this.layout = layout;
  }

  @Override
  public void ping(TransducerPoses poses, double timeS, Readings readings) {
    layout.enclose(poses, reach);
    scene.gather(reach, carrier, near);
    for (int i = 0; i < layout.size(); i++) {
      if (cast(poses, i)) {
        readings.setEcho(i, ray.lengthM());
      } else {
        readings.setNoEcho(i);
      }
    }
  }

  private boolean cast(TransducerPoses poses, int i) {
    ray.setOrigin(poses.xM(i), poses.yM(i), poses.zM(i));
    ray.setDirection(poses.directionX(i), poses.directionY(i), poses.directionZ(i));
    ray.setLength(layout.lengthM(i));
    return near.size() <= FEW ? near.strike(ray) : scene.strike(ray, carrier);
  }
}
