package simbad.parity;

import java.util.Map;
import java.util.TreeMap;
import java.util.function.Supplier;
import javax.vecmath.Vector3d;
import simbad.parity.Scenario.Driver;
import simbad.parity.Scenario.Extra;
import simbad.sim.BallAgent;
import simbad.sim.CherryAgent;
import simbad.sim.Compatibility;
import simbad.sim.DifferentialKinematic;
import simbad.sim.KheperaRobot;
import simbad.sim.LampActuator;
import simbad.sim.Line;
import simbad.sim.Plan;
import simbad.sim.RangeSensorBelt;
import simbad.sim.RobotFactory;
import simbad.sim.SimpleAgent;
import simbad.sim.Wall;

/** The scenarios of the recorded traces, by file name. */
final class Scenarios {
  private Scenarios() {}

  static Map<String, Supplier<Scenario>> all() {
    Map<String, Supplier<Scenario>> all = new TreeMap<>();
    all.put("01-straight-turn", StraightTurn::new);
    all.put("02a-sonar12-box-eachframe", () -> new SonarBox(true));
    all.put("02b-sonar12-box-defaultrate", () -> new SonarBox(false));
    all.put("03-bumper-wall", BumperWall::new);
    all.put("05-differential", Differential::new);
    all.put("09-lamp", Lamp::new);
    all.put("11b-ball-nophysics", Ball::new);
    all.put("12-khepera-ir", Khepera::new);
    all.put("14-plan-square", PlanSquare::new);
    all.put("15-spin-room-9", () -> new SpinRoom(9));
    all.put("15-spin-room-24", () -> new SpinRoom(24));
    all.put("18-infinity-flag", InfinityFlag::new);
    all.put("19-move-and-reset", MoveAndReset::new);
    all.put("10-cherries", Cherries::new);
    all.put("20-addmap", MapWorld::new);
    all.put("22a-elevated-nophysics", () -> new Elevated(false));
    all.put("22b-elevated-physics", () -> new Elevated(true));
    all.put("23-collision-slide", CollisionSlide::new);
    all.put("24-tall-thin-and-low-boxes", OddBoxes::new);
    all.put("08-line-sensor-fork", Lines::new);
    return all;
  }

  private static final class StraightTurn extends Scenario {
    StraightTurn() {
      addAgent(
          new Driver(new Vector3d(0, 0, 0), "r") {
            @Override
            void drive(int n) {
              if (n < 100) {
                vel(0.5, 0);
              } else if (n < 140) {
                vel(0, Math.PI / 4);
              } else if (n < 240) {
                vel(0.5, -0.3);
              } else {
                vel(-0.2, 0);
              }
            }
          });
    }
  }

  /** Drives at a constant velocity. */
  private static class Steady extends Driver {
    private final double t;
    private final double r;

    Steady(Vector3d position, double t, double r) {
      super(position, "r");
      this.t = t;
      this.r = r;
    }

    @Override
    void drive(int n) {
      vel(t, r);
    }
  }

  private static final class SonarBox extends Scenario {
    SonarBox(boolean eachFrame) {
      Steady robot = addAgent(new Steady(new Vector3d(-4, 0, 0), 0.5, 0));
      RobotFactory.addSonarBeltSensor(robot, 12).setUpdateOnEachFrame(eachFrame);
      extras.add(Extra.BELT);
      box(1, 0, 0.2, 1, 1, 1);
    }
  }

  private static final class BumperWall extends Scenario {
    BumperWall() {
      Driver robot =
          addAgent(
              new Driver(new Vector3d(0, 0, 0.5), "r") {
                private boolean hit;

                @Override
                void drive(int n) {
                  hit |= collisionDetected();
                  if (hit) {
                    vel(-0.3, 0.4);
                  } else {
                    vel(0.5, 0);
                  }
                }
              });
      RobotFactory.addBumperBeltSensor(robot, 12).setUpdateOnEachFrame(true);
      extras.add(Extra.BELT);
      Wall wall = new Wall(new Vector3d(3, 0, 0), 6, 1, this);
      wall.rotate90(1);
      add(wall);
    }
  }

  private static final class Differential extends Scenario {
    private static final double[][] WHEELS = {
      {0.8, 0.5}, {0.5, 0.8}, {-0.4, 0.4}, {0.8, 0}, {0.3, 0.3}, {-0.5, -0.45}, {0.3, 0.3005}
    };

    Differential() {
      DifferentialKinematic[] wheels = new DifferentialKinematic[1];
      Driver robot =
          addAgent(
              new Driver(new Vector3d(), "r") {
                @Override
                void drive(int n) {
                  commandT = WHEELS[n / 60][0];
                  commandR = WHEELS[n / 60][1];
                  wheels[0].setWheelsVelocity(commandT, commandR);
                }
              });
      wheels[0] = RobotFactory.setDifferentialDriveKinematicModel(robot);
    }
  }

  private static final class Lamp extends Scenario {
    Lamp() {
      Driver robot =
          addAgent(
              new Driver(new Vector3d(), "r") {
                @Override
                void drive(int n) {
                  LampActuator lamp = (LampActuator) getActuatorDevice(0);
                  switch (n) {
                    case 20 -> lamp.setOn(true);
                    case 40 -> lamp.setBlink(true);
                    case 80 -> lamp.setOn(false);
                    case 100 -> lamp.setBlink(false);
                    default -> {
                      // Nothing changes.
                    }
                  }
                }
              });
      RobotFactory.addLamp(robot);
      extras.add(Extra.LAMP);
    }
  }

  private static final class Ball extends Scenario {
    /** The recorded robot drives through the ball, which needs the switch. */
    Ball() {
      compatibility.add(Compatibility.ROBOTS_PASS_ROBOTS);
      addAgent(new Steady(new Vector3d(-2, 0, 0), 0.5, 0));
      addAgent(new BallAgent(new Vector3d(0, 0, 0.1), "ball", 0.25f));
      box(3, 0, 0, 0.2f, 1, 4);
    }
  }

  private static final class Cherries extends Scenario {
    Cherries() {
      compatibility.add(Compatibility.NEARNESS_IS_ONE_SIDED);
      Driver robot =
          addAgent(
              new Driver(new Vector3d(-2, 0, 0), "r") {
                @Override
                void drive(int n) {
                  if (anOtherAgentIsVeryNear()
                      && getVeryNearAgent() instanceof CherryAgent cherry) {
                    cherry.detach();
                  }
                  vel(0.5, 0);
                }
              });
      RobotFactory.addSonarBeltSensor(robot, 12).setUpdateOnEachFrame(true);
      extras.add(Extra.BELT);
      for (int i = 0; i < 3; i++) {
        addAgent(new CherryAgent(new Vector3d(i - 1, 0, 0.1 * i), "cherry" + i, 0.15f));
      }
    }
  }

  private static final class MapWorld extends Scenario {
    MapWorld() {
      addMap(new String[] {"#####", "#   #", "#   ###", "# # #", "#####"});
      Driver robot =
          addAgent(
              new Driver(new Vector3d(-1, 0, -1), "r") {
                @Override
                void drive(int n) {
                  vel(n < 60 ? 0.3 : 0.2, n < 60 ? 0 : -0.5);
                }
              });
      RobotFactory.addSonarBeltSensor(robot, 12).setUpdateOnEachFrame(true);
      extras.add(Extra.BELT);
    }
  }

  private static final class Elevated extends Scenario {
    Elevated(boolean physics) {
      setUsePhysics(physics);
      if (physics) {
        compatibility.add(Compatibility.GRAVITY_GROWS_WITH_MASS);
        compatibility.add(Compatibility.FRICTION_IN_THE_AIR);
      }
      addAgent(new Steady(new Vector3d(0, 1, 0), 0.2, 0));
      addAgent(new BallAgent(new Vector3d(0, 1, 2), "ball", 0.25f));
    }
  }

  private static final class CollisionSlide extends Scenario {
    CollisionSlide() {
      compatibility.add(Compatibility.BLOCKED_ROBOTS_DO_NOT_TURN);
      box(1.4, 0, 0, 1, 1, 1);
      Driver robot =
          addAgent(
              new Driver(new Vector3d(), "r") {
                @Override
                void drive(int n) {
                  double turn = n < 160 ? 0.5 : -0.2;
                  vel(0.5, n < 80 ? 0 : turn);
                }
              });
      addBoth(robot, 16, 8, true);
    }
  }

  private static final class OddBoxes extends Scenario {
    OddBoxes() {
      Steady robot = addAgent(new Steady(new Vector3d(), 0, Math.PI / 10));
      addBoth(robot, 12, 12, false);
      box(1, 0, 0, 0.4f, 0.45f, 0.4f);
      box(-1, 0, 0, 0.4f, 0.55f, 0.4f);
      box(0, 0.6, 1, 0.4f, 0.4f, 0.4f);
      box(0, 0.2, -1, 0.4f, 0.4f, 0.4f);
    }
  }

  /** Of the derivative of 2011, which alone has lines. */
  private static final class Lines extends Scenario {
    Lines() {
      floorColor = white;
      add(new Line(new Vector3d(), 4, this));
      Line other = new Line(new Vector3d(1, 0, 0.2), 3, this);
      other.rotate90(1);
      add(other);
      Driver robot =
          addAgent(
              new Driver(new Vector3d(-0.5, 0, 0.5), "r") {
                @Override
                void drive(int n) {
                  double turn = n < 120 ? 0.4 : -0.4;
                  vel(0.3, n < 60 ? 0 : turn);
                }
              });
      RobotFactory.addLineSensor(robot, 7).setUpdateOnEachFrame(true);
      extras.add(Extra.LINES);
    }
  }

  private static final class Khepera extends Scenario {
    private final double[] wheels = new double[2];

    Khepera() {
      setWorldSize(1);
      KheperaRobot robot =
          addAgent(
              new KheperaRobot(new Vector3d(), "k") {
                private int n;

                @Override
                protected void performBehavior() {
                  boolean turning = n >= 100 && n < 160;
                  wheels[0] = turning ? 0.01 : 0.02;
                  wheels[1] = turning ? -0.01 : 0.02;
                  setWheelsVelocity(wheels[0], wheels[1]);
                  n++;
                }
              });
      robot.getIRSensors().setUpdateOnEachFrame(true);
      extras.add(Extra.BELT);
      box(0, 0, -0.07, 0.10f, 0.03f, 0.055f);
      box(0.2, 0, 0, 0.055f, 0.1f, 0.055f);
    }

    @Override
    double[] commands(SimpleAgent agent) {
      return wheels.clone();
    }
  }

  private static final class PlanSquare extends Scenario {
    PlanSquare() {
      addAgent(
          new Driver(new Vector3d(), "r") {
            private final Plan plan = new Plan(this);

            @Override
            protected void initBehavior() {
              for (int i = 0; i < 4; i++) {
                plan.forward(1, 1);
                plan.turn(-Math.PI / 2, 1);
              }
              plan.loop();
            }

            @Override
            void drive(int n) {
              if (n == 0) {
                plan.reset();
              }
              plan.doStep();
              commandT = getTranslationalVelocity();
              commandR = getRotationalVelocity();
            }
          });
    }
  }

  private static final class SpinRoom extends Scenario {
    SpinRoom(int sonars) {
      Steady robot = addAgent(new Steady(new Vector3d(0.3, 0, -0.2), 0, Math.PI / 10));
      RobotFactory.addSonarBeltSensor(robot, sonars).setUpdateOnEachFrame(true);
      extras.add(Extra.BELT);
      extras.add(Extra.QUADRANTS);
      box(1.5, 0, 0, 0.2f, 1, 3);
      box(-1.5, 0, 0, 0.2f, 1, 3);
      box(0, 0, 1.8, 3, 1, 0.2f);
      box(-0.8, 0, -1.4, 0.4f, 1, 0.4f);
      box(0.9, 0, -1.2, 0.3f, 0.3f, 0.3f);
    }
  }

  private static final class InfinityFlag extends Scenario {
    /** Carries a belt of its own. */
    private static final class Robot extends Steady {
      Robot() {
        super(new Vector3d(-2, 0, 0), 0.5, 0);
        RangeSensorBelt belt =
            new RangeSensorBelt(
                0.3f,
                0.5f,
                2.0f,
                6,
                RangeSensorBelt.TYPE_SONAR,
                RangeSensorBelt.FLAG_RETURN_INFINITY);
        belt.setUpdateOnEachFrame(true);
        addSensorDevice(belt, new Vector3d(), 0);
      }
    }

    InfinityFlag() {
      addAgent(new Robot());
      extras.add(Extra.BELT);
      extras.add(Extra.QUADRANTS);
      box(1, 0, 0, 1, 1, 1);
    }
  }

  private static final class MoveAndReset extends Scenario {
    MoveAndReset() {
      Driver robot =
          addAgent(
              new Driver(new Vector3d(1, 0, 1), "r") {
                @Override
                void drive(int n) {
                  if (n < 40) {
                    vel(0.5, 0);
                  } else if (n < 59) {
                    vel(0, 1);
                  } else if (n == 64) {
                    vel(0.3, 0.2);
                  }
                  move(n);
                }

                private void move(int n) {
                  switch (n) {
                    case 60 -> moveToPosition(2, -2);
                    case 100 -> moveToPosition(new Vector3d(0, 0.25, 0));
                    case 140 -> moveToStartPosition();
                    case 180 -> rotateY(Math.PI / 2);
                    case 200 -> translateTo(new Vector3d(0.5, 0, 0));
                    default -> {
                      // Goes on.
                    }
                  }
                }
              });
      RobotFactory.addSonarBeltSensor(robot);
      extras.add(Extra.BELT);
    }
  }
}
