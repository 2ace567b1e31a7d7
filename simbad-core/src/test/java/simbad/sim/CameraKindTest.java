package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.GraphicsEnvironment;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import simbad.kernel.render.SoftwareCamera;
import simbad.scene3d.DisplayException;

/** Who takes the pictures. */
class CameraKindTest {
  private static final EnvironmentDescription EMPTY = new EnvironmentDescription();

  @AfterEach
  void forget() {
    System.clearProperty(CameraKind.PROPERTY);
  }

  @Test
  void withoutProperty_theWindowDecides() {
    assertEquals(CameraKind.SOFTWARE, CameraKind.choose(false));
    assertEquals(CameraKind.JAVA3D, CameraKind.choose(true));
  }

  @Test
  void property_decidesInBothCases() {
    System.setProperty(CameraKind.PROPERTY, "software");
    assertEquals(CameraKind.SOFTWARE, CameraKind.choose(true));
    System.setProperty(CameraKind.PROPERTY, "java3d");
    assertEquals(CameraKind.JAVA3D, CameraKind.choose(false));
  }

  @Test
  void property_unknown_isRefused() {
    System.setProperty(CameraKind.PROPERTY, "opengl");
    String message = "simbad.camera = opengl is none of software, java3d";
    Exception refused =
        assertThrows(IllegalArgumentException.class, () -> CameraKind.choose(false));
    assertEquals(message, refused.getMessage());
  }

  @Test
  void software_opensWithoutADisplay() {
    World world = new World(EMPTY);
    assertInstanceOf(SoftwareCamera.class, CameraKind.SOFTWARE.open(world.getStage()));
  }

  @Test
  void java3d_withoutADisplay_saysSo() {
    Assumptions.assumeTrue(GraphicsEnvironment.isHeadless(), "skipped: there is a display");
    World world = new World(EMPTY);
    Exception refused =
        assertThrows(DisplayException.class, () -> CameraKind.JAVA3D.open(world.getStage()));
    assertEquals(
        "no 3D view: there is no display (on a machine without one, run under xvfb-run)",
        refused.getMessage());
  }
}
