package simbad.demo;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import javax.swing.JPanel;
import javax.vecmath.Point3d;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import simbad.sim.Agent;
import simbad.sim.BallAgent;

/** What each demo does in 2,000 steps. */
class DemosTest {
  private static final double EPSILON = 1e-9;

  @Test
  void simplest_turnsAwayFromWhatItHits() {
    SimplestDemo demo = new SimplestDemo();
    Watch watch = Watch.of(demo);
    watch.checkGetsAbout(demo.robot, 30, 5);
    assertTrue(watch.collisions(demo.robot) >= 5, "it has no other way to know");
  }

  @Test
  void base_exploresWithoutCollision() {
    BaseDemo demo = new BaseDemo();
    Watch watch = Watch.of(demo);
    watch.checkGetsAbout(demo.robot, 40, 7);
    assertEquals(0, watch.collisions(demo.robot));
    assertEquals(4, quarters(watch.way(demo.robot)), "quarters of the room that it saw");
  }

  @Test
  void singleAvoider_avoids() {
    SingleAvoiderDemo demo = new SingleAvoiderDemo();
    Watch watch = Watch.of(demo);
    watch.checkGetsAbout(demo.robot, 40, 6);
    assertEquals(0, watch.collisions(demo.robot));
  }

  private static long quarters(List<Point3d> way) {
    return way.stream().map(p -> (p.x > 0 ? 2 : 0) + (p.z > 0 ? 1 : 0)).distinct().count();
  }

  @Test
  void avoiders_avoidEachOther() {
    AvoidersDemo demo = new AvoidersDemo();
    Watch watch = Watch.of(demo);
    assertEquals(8, demo.robots.size());
    for (Agent robot : demo.robots) {
      watch.checkGetsAbout(robot, 25, 6);
      assertTrue(watch.collisions(robot) <= 20, robot.getName() + watch.collisions(robot));
    }
    for (int step = 0; step < Watch.STEPS; step++) {
      for (int i = 1; i < demo.robots.size(); i++) {
        Point3d one = watch.way(demo.robots.get(i - 1)).get(step);
        assertTrue(one.distance(watch.way(demo.robots.get(i)).get(step)) >= 0.6 - EPSILON);
      }
    }
  }

  @Test
  void bumpers_feelTheirWay() {
    BumpersDemo demo = new BumpersDemo();
    Watch watch = Watch.of(demo);
    watch.checkGetsAbout(demo.robot, 30, 4);
    // Bumpers reach 0.1 m further than the body: they touch first, as a rule.
    assertTrue(watch.collisions(demo.robot) <= 10, "collisions " + watch.collisions(demo.robot));
  }

  @Test
  void lamps_blinkWhileSomethingIsNear() {
    BlinkingLampDemo demo = new BlinkingLampDemo();
    AtomicInteger blinking = new AtomicInteger();
    Watch watch = Watch.of(demo, () -> demo.robots.forEach(robot -> checkLamp(robot, blinking)));
    demo.robots.forEach(robot -> watch.checkGetsAbout(robot, 25, 6));
    int all = Watch.STEPS * demo.robots.size();
    assertTrue(blinking.get() > all / 20 && blinking.get() < all * 9 / 10, "of " + all);
  }

  private static void checkLamp(BlinkingLampDemo.Robot robot, AtomicInteger blinking) {
    double nearest = Double.POSITIVE_INFINITY;
    for (int i = 0; i < robot.sonars.getNumSensors(); i++) {
      if (robot.sonars.hasHit(i)) {
        nearest = Math.min(nearest, robot.sonars.getMeasurement(i));
      }
    }
    assertTrue(robot.lamp.getOn());
    assertEquals(nearest < 0.8, robot.lamp.getBlink(), robot.getName() + " at " + nearest);
    blinking.addAndGet(robot.lamp.getBlink() ? 1 : 0);
  }

  /** Radius v T / 2 pi on both sides, and back at the start after each loop. */
  @Test
  void twoWheels_drawFiguresOfEight() {
    DifferentialKinematicDemo demo = new DifferentialKinematicDemo();
    Watch watch = Watch.of(demo);
    List<Point3d> way = watch.way(demo.robot);
    double radius = 0.6 * 12.5 / (2 * Math.PI);
    for (int loop = 1; loop <= 8; loop++) {
      assertEquals(0, way.get(loop * 250 - 1).distance(new Point3d(0, 0.25, 0)), 1e-6);
      Point3d middle = way.get(loop * 250 - 126);
      double side = loop % 2 == 1 ? -1 : 1;
      assertEquals(side * 2 * radius, middle.z, 0.01);
    }
    assertEquals(0, watch.collisions(demo.robot));
  }

  @Test
  void khepera_avoidsWallsInItsMaze() {
    KheperaDemo demo = new KheperaDemo();
    Watch watch = Watch.of(demo);
    watch.checkGetsAbout(demo.robot, 3, KheperaDemo.HALF_M);
    assertEquals(0, watch.collisions(demo.robot));
    assertTrue(quarters(watch.way(demo.robot)) >= 3);
  }

  @Test
  void lineFollower_staysOnTheLine_allTheWayRound() {
    LineDemo demo = new LineDemo();
    AtomicInteger blind = new AtomicInteger();
    int[] seen = {0};
    Watch watch =
        Watch.of(
            demo,
            () -> {
              boolean hit = false;
              for (int i = 0; i < demo.robot.sensor.getNumSensors(); i++) {
                hit |= demo.robot.sensor.hasHit(i);
              }
              seen[0] = hit ? 0 : seen[0] + 1;
              blind.accumulateAndGet(seen[0], Math::max);
            });
    // 28 m round; corners cut some of it.
    watch.checkGetsAbout(demo.robot, 30, 5);
    assertTrue(blind.get() < 40, "without the line for " + blind.get() + " steps");
    watch.way(demo.robot).forEach(place -> assertTrue(distanceToCourse(place) < 0.4, "" + place));
    for (int i = 0; i < LineDemo.COURSE.length; i += 2) {
      Point3d corner = new Point3d(LineDemo.COURSE[i], 0.25, LineDemo.COURSE[i + 1]);
      double nearest = watch.way(demo.robot).stream().mapToDouble(corner::distance).min().orElse(9);
      assertTrue(nearest < 0.4, "corner " + corner);
    }
  }

  private static double distanceToCourse(Point3d at) {
    double nearest = Double.POSITIVE_INFINITY;
    double[] c = LineDemo.COURSE;
    for (int i = 0; i < c.length; i += 2) {
      int next = (i + 2) % c.length;
      double x = Math.max(Math.min(c[i], c[next]), Math.min(at.x, Math.max(c[i], c[next])));
      double z =
          Math.max(
              Math.min(c[i + 1], c[next + 1]), Math.min(at.z, Math.max(c[i + 1], c[next + 1])));
      nearest = Math.min(nearest, Math.hypot(at.x - x, at.z - z));
    }
    return nearest;
  }

  @Test
  void cherries_arePickedUp_andComeBackAtTheStart() {
    PickCherriesDemo demo = new PickCherriesDemo();
    for (int run = 0; run < 2; run++) {
      Watch watch = Watch.of(demo);
      assertEquals(12, demo.robot.picked);
      assertEquals(0, watch.collisions(demo.robot));
      assertTrue(demo.cherries.stream().noneMatch(cherry -> cherry.getSolid().isPresent()));
    }
  }

  @Test
  void balls_arePushed_andStayBetweenTheWalls() {
    PushBallsDemo demo = new PushBallsDemo();
    Watch watch = Watch.of(demo);
    long moved = demo.balls.stream().filter(ball -> watch.displacement(ball) > 0.3).count();
    assertTrue(moved >= 12, moved + " balls moved");
    for (BallAgent ball : demo.balls) {
      assertTrue(
          watch.way(ball).stream().allMatch(p -> Math.abs(p.x) < 4.16 && Math.abs(p.z) < 4.16));
    }
    for (PushBallsDemo.Robot robot : demo.robots) {
      watch.checkGetsAbout(robot, 30, 4.5);
      assertTrue(robot.contacts > 10, robot.contacts + " contacts");
    }
  }

  @Test
  void imager_findsTheYellowBox_andShowsWhatItSees() {
    ImagerDemo demo = new ImagerDemo();
    Watch watch = Watch.of(demo);
    Point3d goal = new Point3d(ImagerDemo.GOAL[0], 0.25, ImagerDemo.GOAL[1]);
    double distance = Watch.at(demo.robot).distance(goal);
    assertTrue(distance > 0.8 && distance < 2, "from the box " + distance);
    assertTrue(demo.robot.lamp.getOn());
    assertEquals(0, watch.collisions(demo.robot));
    JPanel panel = demo.robot.getUIPanel();
    panel.setSize(panel.getPreferredSize());
    BufferedImage screen = new BufferedImage(200, 200, BufferedImage.TYPE_INT_RGB);
    panel.paint(screen.createGraphics());
    // The box and the mark on its middle; the wall behind it.
    Color middle = new Color(screen.getRGB(100, 120));
    assertTrue(
        middle.getRed() > 40 && middle.getGreen() > 40 && middle.getBlue() < 40, "" + middle);
    BufferedImage sight = demo.robot.camera.createCompatibleImage();
    demo.robot.camera.copyVisionImage(sight);
    assertEquals(sight.getRGB(10, 90), screen.getRGB(20, 180));
  }

  @Test
  void lightSearch_findsTheLamp() {
    LightSearchDemo demo = new LightSearchDemo();
    Watch watch = Watch.of(demo);
    Point3d at = Watch.at(demo.robot);
    double away = Math.hypot(at.x - LightSearchDemo.LAMP[0], at.z - LightSearchDemo.LAMP[2]);
    assertTrue(away < 1.2, "from the lamp " + away);
    assertTrue(demo.robot.lamp.getBlink());
    assertEquals(0, watch.collisions(demo.robot));
    double straight = new Point3d(-4.5, 0.25, 4).distance(at);
    assertTrue(demo.robot.getOdometer() < 1.5 * straight, "way " + demo.robot.getOdometer());
  }

  /** Same demo, same paths: nothing depends on time or chance. */
  @TestFactory
  Stream<DynamicTest> everyDemo_repeats() {
    return DemoManager.names().stream()
        .map(name -> DynamicTest.dynamicTest(name, () -> checkRepeats(name)));
  }

  private static void checkRepeats(String name) {
    assertEquals(ends(name), ends(name));
  }

  private static List<Point3d> ends(String name) {
    Demo demo = DemoManager.find(name).orElseThrow();
    List<Point3d> ends = Watch.of(demo).agents().stream().map(Watch::at).toList();
    assertFalse(ends.isEmpty());
    return ends;
  }
}
