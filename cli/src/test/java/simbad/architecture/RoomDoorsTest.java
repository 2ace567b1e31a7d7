package simbad.architecture;

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
 * definitions and gap have tests of their own; cli and studio have no such door. The rooms of
 * blind-world are a program, which nothing else calls.
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
}
