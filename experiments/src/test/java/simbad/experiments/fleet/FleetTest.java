package simbad.experiments.fleet;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.FloatBuffer;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.experiments.control.Command;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.Neighbour;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.experiments.run.Start;
import simbad.experiments.run.Trace;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.sensing.Readings;

class FleetTest {
  private static final double NO_ECHO_M = 6;
  private static final ObstacleType ANGLE = Catalogue.find("angle").orElseThrow();

  private static final SensorKind SLOW =
      SensorKind.SHADOW.on(
          new RobotKind(
              "slow",
              MotionChain.EXACT.with(
                  new MotionChange() {
                    @Override
                    public double commandedSpeed(double speedMPerS) {
                      return 0.8 * speedMPerS;
                    }

                    @Override
                    public double delayS(double delayS) {
                      return delayS + 0.07;
                    }
                  })));

  private static Fleet fleet(SensorKind sensor, int robots, int mostSteps, Autoreset autoreset) {
    FleetSetup setup =
        new FleetSetup(ANGLE, List.of(), sensor, Catalogue.srf04(), mostSteps, 1, 1000, NO_ECHO_M);
    Fleet fleet = new Fleet(setup, robots, autoreset);
    for (int i = 0; i < robots; i++) {
      fleet.seed(i, 7 + i);
      fleet.start(i);
    }
    return fleet;
  }

  private static void command(Fleet fleet, SplittableRandom random) {
    for (int i = 0; i < fleet.size(); i++) {
      fleet.commands().put(2 * i, random.nextDouble());
      fleet.commands().put(2 * i + 1, 4 * random.nextDouble() - 2);
    }
  }

  private static float[] read(FloatBuffer buffer) {
    float[] values = new float[buffer.capacity()];
    buffer.duplicate().get(0, values);
    return values;
  }

  /** The robot of a run, command by command, to the last bit. */
  private static void checkAgainstRun(SensorKind sensor, boolean closes) {
    Circuit circuit =
        new Circuit(ANGLE, List.of(), sensor, Catalogue.srf04(), 0.5, Optional.empty(), 1);
    Trace trace = circuit.drive(new EdgeFollower(Tuning.standard(0.5, Circuit.STEP_S)));
    EdgeFollower follower = new EdgeFollower(Tuning.standard(0.5, Circuit.STEP_S));
    Fleet fleet = fleet(sensor, 1, 1_000_000, Autoreset.DISABLED);
    Pose start = Start.standard(ANGLE, Catalogue.srf04());
    fleet.startAt(0, start.position().xM(), start.position().zM(), start.heading().radians());
    Command command = new Command();
    double won = 0;
    for (int i = 0; i < trace.size(); i++) {
      follower.decide(readings(fleet), command);
      fleet.commands().put(0, command.speedMPerS()).put(1, command.turnRateRadPerS());
      fleet.step();
      won += i >= trace.firstOnEdge() ? fleet.rewards().get(0) : 0;
      assertEquals(trace.xM(i), fleet.poses().get(0), "x at " + i);
      assertEquals(trace.zM(i), fleet.poses().get(1), "z at " + i);
      assertEquals(trace.headingRad(i), fleet.poses().get(2), "heading at " + i);
    }
    assertEquals(closes, trace.isClosed());
    assertTrue(trace.size() > 500);
    assertEquals(1, closes ? won : 1, 0.1);
  }

  private static Readings readings(Fleet fleet) {
    Readings readings = new Readings(SensorKind.SONARS);
    for (int i = 0; i < SensorKind.SONARS; i++) {
      if (fleet.readings().get(i) < NO_ECHO_M) {
        readings.setEcho(i, fleet.readings().get(i));
      }
    }
    return readings;
  }

  @Test
  void robot_isThatOfARun() {
    checkAgainstRun(SensorKind.SHADOW, true);
  }

  @Test
  void diagnosedRobot_isThatOfARun() {
    // So late at such a speed it loses the edge.
    checkAgainstRun(SLOW, false);
  }

  @Test
  void equalSeeds_giveEqualReadings_alone_orAmongOthers() {
    Fleet many = fleet(SensorKind.LEVEL_NOISY, 20, 30, Autoreset.NEXT_STEP);
    Fleet again = fleet(SensorKind.LEVEL_NOISY, 20, 30, Autoreset.NEXT_STEP);
    Fleet one = fleet(SensorKind.LEVEL_NOISY, 1, 30, Autoreset.NEXT_STEP);
    SplittableRandom random = new SplittableRandom(3);
    for (int step = 0; step < 200; step++) {
      command(many, random);
      again.commands().put(0, many.commands(), 0, 40);
      one.commands().put(0, many.commands(), 0, 2);
      many.step();
      again.step();
      one.step();
    }
    assertArrayEquals(read(many.readings()), read(again.readings()));
    for (int i = 0; i < SensorKind.SONARS; i++) {
      assertEquals(one.readings().get(i), many.readings().get(i));
    }
    assertEquals(one.poses().get(0), many.poses().get(0));
  }

  @Test
  void episode_endsByTime_andBeginsAnewWhenItIsAsked() {
    Fleet next = fleet(SensorKind.SHADOW, 1, 3, Autoreset.NEXT_STEP);
    Fleet same = fleet(SensorKind.SHADOW, 1, 3, Autoreset.SAME_STEP);
    Fleet disabled = fleet(SensorKind.SHADOW, 1, 3, Autoreset.DISABLED);
    for (Fleet fleet : List.of(next, same, disabled)) {
      fleet.repeat(3);
      assertEquals(1, fleet.truncated().get(0));
    }
    double lastXM = next.poses().get(0);
    assertEquals(lastXM, disabled.poses().get(0));
    assertNotEquals(lastXM, same.poses().get(0));
    assertArrayEquals(read(next.readings()), read(same.lastReadings()));
    next.step();
    assertEquals(0, next.truncated().get(0));
    assertEquals(same.poses().get(0), next.poses().get(0));
    assertArrayEquals(read(same.readings()), read(next.readings()));
    disabled.step();
    assertEquals(lastXM, disabled.poses().get(0));
    assertEquals(1, disabled.truncated().get(0));
  }

  @Test
  void robot_isStoppedByTheObstacle() {
    Fleet fleet = fleet(SensorKind.ORIGINAL, 1, 1000, Autoreset.DISABLED);
    fleet.startAt(0, 0.3, 0, Math.PI);
    fleet.commands().put(0, 0.5).put(1, 0);
    for (int i = 0; i < 20 && fleet.terminated().get(0) == 0; i++) {
      fleet.step();
    }
    assertEquals(1, fleet.terminated().get(0));
    assertEquals(-1, fleet.rewards().get(0), 0.01);
  }

  @Test
  void neighbours_areHeard_andNoRobotStartsInThem() {
    ObstacleType round = Catalogue.find("round").orElseThrow();
    Neighbour near = new Neighbour(round, new Placement(0.2, 0, 0));
    FleetSetup setup =
        new FleetSetup(
            ANGLE, List.of(near), SensorKind.RAY, Catalogue.srf04(), 10, 1, 6, NO_ECHO_M);
    Fleet fleet = new Fleet(setup, 1, Autoreset.DISABLED);
    for (int seed = 0; seed < 300; seed++) {
      fleet.seed(0, seed);
      fleet.start(0);
      double fromNeighbourM = Math.hypot(fleet.poses().get(0) - 0.2, fleet.poses().get(1));
      assertTrue(fromNeighbourM > round.outline().reachM(0, 0));
    }
    fleet.startAt(0, 0.6, 0, Math.PI);
    assertTrue(fleet.readings().get(0) < 0.4);
  }

  @Test
  void commands_areCut_andNaNIsRefused() {
    Fleet fleet = fleet(SensorKind.SHADOW, 1, 10, Autoreset.DISABLED);
    fleet.startAt(0, 1, 1, 0);
    fleet.commands().put(0, 50).put(1, 0);
    fleet.step();
    assertEquals(1 + Circuit.STEP_S, fleet.poses().get(0), 1e-12);
    fleet.commands().put(0, Double.NaN);
    assertThrows(IllegalArgumentException.class, fleet::step);
  }

  @Test
  void setup_isChecked() {
    assertThrows(IllegalArgumentException.class, () -> fleet(SLOW, 0, 1, Autoreset.DISABLED));
    assertThrows(IllegalArgumentException.class, () -> fleet(SLOW, 1, 0, Autoreset.DISABLED));
    assertThrows(
        IllegalArgumentException.class,
        () -> new FleetSetup(ANGLE, List.of(), SLOW, Catalogue.srf04(), 1, 1, 1, Double.NaN));
  }
}
