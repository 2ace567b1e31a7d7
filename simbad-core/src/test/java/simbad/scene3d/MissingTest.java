package simbad.scene3d;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import simbad.sim.EnvironmentDescription;
import simbad.sim.World;

/**
 * What Java 3D lacks is named; these tests run with the export that it needs, without a display.
 */
class MissingTest {
  @Test
  void world_withoutADisplay_saysSo_everyTime() {
    World world = new World(new EnvironmentDescription());
    DisplayException first = assertThrows(DisplayException.class, world::getCanvas3D);
    assertEquals(
        "no 3D view: there is no display (on a machine without one, run under xvfb-run)",
        first.getMessage());
    assertSame(first, assertThrows(DisplayException.class, world::getCanvas3D));
  }

  @Test
  void worldWithoutACanvas_takesAllCommandsOfAView() {
    World world = new World(new EnvironmentDescription());
    world.changeViewPoint(World.VIEW_FROM_TOP, null);
    assertEquals(World.VIEW_FROM_TOP, world.getViewPoint());
    world.stopRendering();
    world.renderOnce();
    world.startRendering();
    world.dispose();
  }

  @Test
  void nativeLibrary_isNamed_inOneLine() {
    Throwable failure =
        new NoClassDefFoundError("javax.media.j3d.VirtualUniverse")
            .initCause(new UnsatisfiedLinkError("libGL.so.1: cannot open\nand more"));
    assertEquals(
        "no 3D view: a native library is missing: libGL.so.1: cannot open",
        Missing.of(failure).getMessage());
  }

  @Test
  void openGl_isNamed_withItsReason() {
    assertEquals(
        "no 3D view: OpenGL is missing or fails: no pixels",
        Missing.of(new IllegalStateException("outer", new RuntimeException("no pixels")))
            .getMessage());
    assertEquals(
        "no 3D view: OpenGL is missing or fails: NullPointerException",
        Missing.of(new NullPointerException()).getMessage());
  }

  @Test
  void knownReason_staysAsItIs() {
    DisplayException known = Missing.display();
    assertSame(known, Missing.of(known));
  }
}
