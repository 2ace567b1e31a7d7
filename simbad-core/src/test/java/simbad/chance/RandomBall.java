package simbad.chance;

import java.util.Random;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.sim.BallAgent;

/** A ball that lies, rolls or flies at its start, and knows its energy. */
final class RandomBall extends BallAgent {
  private static final double G = 9.8f;
  private static final double FASTEST_M_PER_S = 3;

  private final Vector3d start = new Vector3d();

  RandomBall(Vector3d at, Random random, float radiusM) {
    super(at, "ball", radiusM);
    mass = 0.1f + random.nextFloat();
    staticFrictionCoefficient = random.nextBoolean() ? 0 : random.nextFloat();
    if (random.nextBoolean()) {
      start.set(speed(random), random.nextInt(4) == 0 ? speed(random) : 0, speed(random));
    }
  }

  private static double speed(Random random) {
    return FASTEST_M_PER_S * (2 * random.nextDouble() - 1);
  }

  @Override
  protected void initBehavior() {
    linearVelocity.set(start);
  }

  /** Returns the sum of what it has by its height and by its velocity, joules. */
  double energy() {
    Point3d at = new Point3d();
    getCoords(at);
    return mass * (G * at.y + linearVelocity.lengthSquared() / 2);
  }
}
