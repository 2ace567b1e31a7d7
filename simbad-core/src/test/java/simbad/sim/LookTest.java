package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.PointLight;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;

/** What the things of a world look like, as triangles. */
class LookTest {
  private final EnvironmentDescription environment = new EnvironmentDescription();

  @Test
  void box_hasItsColourAndIsLit() {
    Box box = new Box(new Vector3d(), new Vector3f(1, 2, 3), environment);
    Facets facets = only(box);
    assertEquals(new Rgb(0.8f, 0, 0), facets.finish().colour());
    assertTrue(facets.finish().lit());
    assertEquals(Math.sqrt(1 + 4 + 9) / 2, facets.mesh().radiusM(), 1e-6);
  }

  @Test
  void colour_changed_isDrawnAnew() {
    Box box = new Box(new Vector3d(), new Vector3f(1, 2, 3), environment);
    only(box);
    long before = box.visual().revision();
    box.setColor(new Color3f(-1, 0.5f, 9));
    assertNotEquals(before, box.visual().revision());
    assertEquals(new Rgb(0, 0.5f, 0.8f), only(box).finish().colour());
  }

  @Test
  void arch_isItsThreeBoxes() {
    Visual arch = new Arch(new Vector3d(), environment).visual();
    assertEquals(List.of(), arch.facets());
    assertEquals(3, arch.parts().size());
    assertEquals(1.75, arch.parts().get(2).frameFromVisual().yM(), 1e-6);
  }

  @Test
  void robot_hasARedNoseOnTopWhoseTipIsAhead() {
    Agent robot = new Agent(new Vector3d(), "robot");
    assertEquals(new Rgb(0, 0.8f, 0), robot.drawing().get(0).finish().colour());
    Facets nose = robot.drawing().get(1);
    assertEquals(new Rgb(0.8f, 0, 0), nose.finish().colour());
    for (int i = 0; i < nose.mesh().vertices(); i++) {
      assertTrue(nose.mesh().yM(i) >= 0.25);
      assertTrue(nose.mesh().xM(i) == 0 || nose.mesh().zM(i) == 0, "tip or base");
    }
    assertEquals(Math.hypot(0.3, 0.26), nose.mesh().radiusM(), 1e-6);
  }

  @Test
  void robot_showsItsDevices() {
    Agent robot = new Agent(new Vector3d(), "robot");
    LampActuator lamp = RobotFactory.addLamp(robot);
    assertEquals(List.of(lamp.visual()), robot.visual().parts());
  }

  @Test
  void lamp_changesItsLook_whenItsLightChanges_andOnlyThen() {
    LampActuator lamp = new LampActuator(0.15f);
    assertTrue(only(lamp).finish().lit());
    long dark = lamp.visual().revision();
    lamp.setBlink(true);
    lamp.update();
    assertEquals(dark, lamp.visual().revision());
    lamp.update();
    lamp.setOn(true);
    assertNotEquals(dark, lamp.visual().revision());
    assertFalse(only(lamp).finish().lit());
    assertEquals(0.075, only(lamp).mesh().radiusM(), 1e-6);
    lamp.update();
    assertTrue(only(lamp).finish().lit());
  }

  @Test
  void line_liesAheadOfItsStart() {
    Facets strip = only(new Line(new Vector3d(), 2, environment));
    for (int i = 0; i < strip.mesh().vertices(); i++) {
      assertTrue(strip.mesh().zM(i) > -1e-6 && strip.mesh().zM(i) < 2 + 1e-6);
      assertTrue(Math.abs(strip.mesh().yM(i)) < 0.0025 + 1e-6);
    }
  }

  @Test
  void detached_isHidden() {
    Box box = new Box(new Vector3d(), new Vector3f(1, 1, 1), environment);
    box.detach();
    assertFalse(box.visual().isPresent());
    box.attach();
    assertTrue(box.visual().isPresent());
  }

  @Test
  void stage_hasFloorAxesLampsAndObjects() {
    environment.light2IsOn = true;
    environment.light2Color = new Color3f(1, 0, 0);
    Box box = new Box(new Vector3d(), new Vector3f(1, 1, 1), environment);
    environment.add(box);
    World world = new World(environment);
    Stage stage = world.getStage();
    assertEquals(new Rgb(0.8f, 0.8f, 0.8f), stage.background());
    PointLight first = new PointLight(0, 5, 20, Rgb.WHITE);
    PointLight second = new PointLight(20, 5, 0, new Rgb(1, 0, 0));
    assertEquals(List.of(first, second), stage.lighting().lamps());
    assertTrue(world.getLight1().getEnable() && world.getLight2().getEnable());
    assertEquals(5, stage.visuals().size());
    assertEquals(box.visual(), stage.visuals().get(4));
    Agent robot = new Agent(new Vector3d(), "robot");
    world.addObjectToPickableSceneBranch(robot);
    world.addObjectToPickableSceneBranch(robot);
    assertEquals(6, stage.visuals().size());
  }

  @Test
  void stage_withoutAxesAndLight_isFloorAlone() {
    environment.hasAxis = false;
    environment.light1IsOn = false;
    World world = new World(environment);
    assertEquals(1, world.getStage().visuals().size());
    assertFalse(world.getLight1().getEnable() || world.getLight2().getEnable());
  }

  @Test
  void coloursAndLamps_outOfRange_areRefused() {
    checkRefused("red = 1.5 is not in [0, 1]", () -> new Rgb(1.5f, 0, 0));
    checkRefused("blue = NaN is not in [0, 1]", () -> new Rgb(0, 0, Float.NaN));
    checkRefused("yM = NaN is not finite", () -> new PointLight(0, Double.NaN, 0, Rgb.WHITE));
    assertEquals(new Rgb(0, 1, 0), Rgb.nearest(Float.NaN, 7, -1));
  }

  private static void checkRefused(String message, Runnable call) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, call::run).getMessage());
  }

  private static Facets only(BaseObject object) {
    assertEquals(1, object.visual().facets().size());
    return object.visual().facets().get(0);
  }
}
