package simbad.kernel.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;
import java.util.random.RandomGeneratorFactory;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.Ray;

/** What a body on its way keeps of the scene round it never makes it miss anything. */
class WalkTest {
  private static final double RADIUS_M = 0.3;
  private static final double REACH_M = 1.8;
  private static final Solid NOBODY = new Solid(new Placement());

  private final BodyScene scene = new BodyScene();
  private final List<Solid> boxes = new ArrayList<>();
  private final List<Placement> places = new ArrayList<>();
  private final Neighbourhood near = new Neighbourhood();
  private final Clearance clearance = new Clearance();
  private final Ball body = new Ball();
  private final Ball reach = new Ball();

  private void addBox(Placement place, double sideM) {
    Solid box = new Solid(place).add(BoxShape.ofSides(sideM, 1, sideM));
    places.add(place);
    boxes.add(box);
    scene.addFixed(box);
  }

  private static Placement anywhere(RandomGenerator random) {
    Placement place = Placement.at(random.nextDouble(-5, 5), 0.5, random.nextDouble(-5, 5));
    place.turnAboutY(random.nextDouble(7));
    return place;
  }

  @Property(tries = 30, seed = "20140914")
  void steps_seeAndTouchWhatAFreshLookDoes(@ForAll long seed) {
    RandomGenerator random = RandomGeneratorFactory.of("L64X128MixRandom").create(seed);
    for (int i = 0; i < 40; i++) {
      addBox(anywhere(random), random.nextDouble(0.05, 0.6));
    }
    double x = 0;
    double z = 0;
    for (int step = 0; step < 300; step++) {
      x += random.nextDouble(-0.08, 0.1);
      z += random.nextDouble(-0.1, 0.08);
      if (random.nextInt(40) == 0) {
        change(random);
      }
      checkBody(x, z);
      checkRays(x, z, random.nextDouble(7));
    }
  }

  private void change(RandomGenerator random) {
    int box = random.nextInt(boxes.size());
    switch (random.nextInt(3)) {
      case 0 -> {
        places.get(box).copyFrom(anywhere(random));
        boxes.get(box).moved();
      }
      case 1 -> boxes.get(box).setPresent(!boxes.get(box).isPresent());
      default -> boxes.get(box).setTraversable(!boxes.get(box).isTraversable());
    }
  }

  private void checkBody(double x, double z) {
    body.set(x, 0.25, z, RADIUS_M);
    assertEquals(scene.stopsBall(x, 0.25, z, RADIUS_M), scene.stopsBall(body, clearance));
  }

  private void checkRays(double x, double z, double headingRad) {
    reach.set(x, 0.5, z, REACH_M);
    scene.gather(reach, NOBODY, near);
    for (int i = 0; i < 8; i++) {
      double angle = headingRad + i;
      Ray ray = new Ray();
      ray.setOrigin(x, 0.5, z);
      ray.setDirection(Math.cos(angle), 0, -Math.sin(angle));
      ray.setLength(REACH_M);
      Ray fresh = new Ray();
      fresh.setToLocal(ray, new Placement());
      assertEquals(scene.strike(fresh), near.strike(ray));
      assertEquals(fresh.lengthM(), ray.lengthM());
    }
  }

  @Test
  void objectThatComes_isSeenAndTouchedAtOnce() {
    checkBody(0, 0);
    checkRays(0, 0, 0);
    assertEquals(0, near.size());
    addBox(Placement.at(0.5, 0.5, 0), 0.5);
    body.set(0, 0.25, 0, RADIUS_M);
    assertTrue(scene.stopsBall(body, clearance));
    scene.gather(reach, NOBODY, near);
    assertEquals(1, near.size());
  }

  @Test
  void anotherScene_isLookedAtAnew() {
    addBox(Placement.at(0.5, 0.5, 0), 0.5);
    checkBody(0, 0);
    body.set(0, 0.25, 0, RADIUS_M);
    assertFalse(new BodyScene().stopsBall(body, clearance));
    assertTrue(scene.stopsBall(body, clearance));
  }
}
