package simbad.architecture;

import java.lang.reflect.Proxy;
import java.lang.reflect.Type;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import simbad.bench.board.BenchScene;
import simbad.bench.board.BoardEvent;
import simbad.bench.board.BoardScript;
import simbad.experiments.run.RunResult;
import simbad.figures.page.AxisScale;
import simbad.kernel.geometry.PrismShape;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Way;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.obstacles.SonarBelt;
import simbad.obstacles.SonarObstacle;
import simbad.scattering.RigidScatterer;
import simbad.sim.RangeSensorBelt;
import simbad.sonar.check.DoorWalk;
import simbad.sonar.check.Samples;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.DetectionRule;
import simbad.sonar.model.SensorModel;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.DetectionShadow;

/**
 * NaN comes in by no public constructor and by no factory. The rooms sonar-model, effects,
 * definitions and gap have tests of their own; cli and studio have no such door.
 */
class RoomDoorsTest {
  private static Samples samples() {
    SonarSpec sonar = Catalogue.srf04();
    ObstacleType square = Catalogue.find("square").orElseThrow();
    BenchScene bench = new BenchScene(Optional.empty(), 1, 0, 0);
    BoardScript script =
        new BoardScript(List.of(new BoardScript.Row(0, bench, 20, BoardEvent.NONE)));
    return new Samples()
        .with(SonarSpec.class, sonar)
        .with(SensorModel.class, DetectionRule.SHADOW)
        .with(ObstacleType.class, square)
        .with(DetectionShadow.class, new DetectionShadow(square.thresholds().table()))
        .with(Vector3d.class, new Vector3d())
        .with(Pose.class, Pose.of(1, 1, 0))
        .with(BenchScene.class, bench)
        .with(BoardScript.class, script)
        .with(
            RangeSensorBelt.class,
            new SonarBelt(12, sonar, DetectionRule.SHADOW, new SplittableRandom(1)));
  }

  @Test
  void motionModel() throws Exception {
    MotionRun run = new MotionRun("drive", List.of(new Command(0, 0.1, 0)), List.of());
    Samples samples =
        samples()
            .with(MotionRun.class, run)
            .with(MotionChain.class, MotionChain.EXACT)
            .with(double[][][].class, new double[25][3][19]);
    DoorWalk.refusesNan(Way.class, samples, 15);
  }

  /**
   * Classes of Simbad's own take what Simbad's take: old programs compute their numbers as they
   * like. The 3D view needs a display, and nearest says what it makes of NaN.
   */
  @Test
  void simbadCore() throws Exception {
    DoorWalk.refusesNan(
        PrismShape.class, samples(), 12, "sim.", "scene3d.", "kernel.drawing.Rgb.nearest(");
  }

  /** The shape of a shadow needs a display. */
  @Test
  void obstacles() throws Exception {
    DoorWalk.refusesNan(SonarObstacle.class, samples(), 3, "obstacles.ShadowShape(");
  }

  @Test
  void scattering() throws Exception {
    DoorWalk.refusesNan(RigidScatterer.class, samples(), 3);
  }

  @Test
  void bench() throws Exception {
    DoorWalk.refusesNan(BenchScene.class, samples(), 20);
  }

  @Test
  void experiments() throws Exception {
    // A grid of one cell, which one share fills.
    DoorWalk.refusesNan(RunResult.class, samples().with(int.class, 1), 25);
  }

  @Test
  void figures() throws Exception {
    DoorWalk.refusesNan(AxisScale.class, samples(), 12);
  }

  /** The program that nothing here calls: its classes are known to this test by their names. */
  @Test
  void blindWorld() throws Exception {
    DoorWalk.refusesNan(blind("Main"), blindSamples(), 50);
  }

  private static Samples blindSamples() throws Exception {
    Object corner = made("world.Point", 0.0, 0.0);
    List<Object> corners =
        List.of(corner, made("world.Point", 0.1, 0.0), made("world.Point", 0.0, 0.1));
    Type[] outline =
        blind("wave.Outline")
            .getMethod("covered", List.class, List.class)
            .getGenericParameterTypes();
    Object shadow = made("world.Shadow", List.of(1.0));
    Object sensor =
        made("world.Sensor", "sonar", 0.3, 0.1, 3.0, 0.1, 340.0, 0.0, 0.0, 0.0, 0.1, 0.1);
    Object obstacle = made("world.Obstacle", "post", corner, 0.0, corners, shadow);
    Object pose = made("world.Pose", 1.0, 1.0, 0.0);
    Object row = made("world.Row", "run", "front", 0.0, pose);
    Class<?>[] repeated = {blind("world.Repeats")};
    Object repeats =
        Proxy.newProxyInstance(
            repeated[0].getClassLoader(), repeated, (proxy, method, seed) -> new double[2]);
    double[] none = {};
    Object commands = made("motion.Commands", none, none, none);
    Object drive = made("motion.Outing$Run", "drive", commands, none, 1.0, pose);
    return new Samples()
        .with(outline[0], corners)
        .with(outline[1], List.of(0.5, 0.5, 0.5))
        .with(blind("world.Shadow"), shadow)
        .with(blind("world.Scene"), made("world.Scene", 4.0, sensor, List.of(obstacle)))
        .with(blind("world.Recording"), made("world.Recording", List.of(row)))
        .with(blind("world.Repeats"), repeats)
        .with(blind("motion.Commands"), commands)
        .with(blind("motion.Outing"), made("motion.Outing", List.of(drive)));
  }

  private static Class<?> blind(String name) throws ClassNotFoundException {
    return Class.forName("simbad.blindworld." + name);
  }

  private static Object made(String name, Object... arguments) throws Exception {
    return blind(name).getConstructors()[0].newInstance(arguments);
  }
}
