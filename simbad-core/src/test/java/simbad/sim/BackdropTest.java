package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Set;
import javax.vecmath.Color3f;
import org.junit.jupiter.api.Test;
import simbad.scene3d.Look;

/** Which colours of floor and background are the program's own. */
class BackdropTest {
  private final EnvironmentDescription environment = new EnvironmentDescription();

  @Test
  void untouchedColours_areNobodys() {
    assertFalse(Surroundings.backdrop(environment).ownFloor());
    assertFalse(Surroundings.backdrop(environment).ownBackground());
  }

  @Test
  void assignedColour_isOwn_evenIfEquallyGrey() {
    environment.backgroundColor = environment.black;
    environment.floorColor = environment.gray;
    assertTrue(Surroundings.backdrop(environment).ownFloor());
    assertTrue(Surroundings.backdrop(environment).ownBackground());
  }

  @Test
  void repaintedColour_isOwn() {
    environment.floorColor.set(new Color3f(0.5f, 0.8f, 0.8f));
    assertTrue(Surroundings.backdrop(environment).ownFloor());
  }

  /** Without a window there is nothing to look at, and nothing is made for it. */
  @Test
  void worldWithoutCanvas_hasNoSigns_butKeepsItsLook() {
    World world = new World(environment);
    Look dark = Look.LIGHT.withDark(true);
    world.setLook(dark);
    assertEquals(dark, world.getLook());
    assertEquals(Set.of(), world.signs());
  }
}
