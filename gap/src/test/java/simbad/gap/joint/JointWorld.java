package simbad.gap.joint;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.SplittableRandom;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.fixture.Logs;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionData;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.NominalModel;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorPoses;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/**
 * A robot with four sonars that drives among three boxes before a tracker, simulated here in steps
 * of ten milliseconds: where it is, and where it believes to be.
 */
final class JointWorld {
  static final List<String> SENSORS = List.of("ahead", "left", "back", "right");
  private static final double SIGMA_M = 0.001;
  private static final double SIGMA_RAD = Math.toRadians(0.2);
  private static final double BASE_M = 0.2;
  private static final double DT = 0.01;
  private static final int PER_POSE = 10;
  private static final int PER_PING = 25;
  private static final double MOST_M = 1.9;
  private static final double CLEAR_M = 0.5;

  int runs = 5;
  double seconds = 32;

  /** True over believed size of both wheels. */
  double wheels = 1;

  /** True over told speed, which the wheels' counters know. */
  double motors = 1;

  /** What it turns by and its counters do not know, rad/s. */
  double bias;

  private final SplittableRandom random;
  private final List<MotionRun> driven = new ArrayList<>();
  private final List<ReadingRow> believed = new ArrayList<>();
  private final List<ReadingRow> real = new ArrayList<>();

  JointWorld(long seed) {
    random = new SplittableRandom(seed);
  }

  JointWorld drive() {
    for (int run = 0; run < runs; run++) {
      new Run("run " + (run + 1)).drive();
    }
    return this;
  }

  MotionData motion() {
    Robot robot = new Robot(true, BASE_M, false, SIGMA_M, SIGMA_RAD, MotionChain.EXACT);
    return new MotionData("joint", robot, driven, List.of());
  }

  static SensingSetup setup() {
    Map<String, Placement> mounts = new LinkedHashMap<>();
    for (int i = 0; i < SENSORS.size(); i++) {
      double turn = i * Math.PI / 2;
      mounts.put(
          SENSORS.get(i), new Placement(0.08 * Math.cos(turn), -0.08 * Math.sin(turn), turn));
    }
    SensingSetup room = Logs.ROOM;
    return new SensingSetup(
        room.sensor(),
        room.scene(),
        room.noEchoM(),
        new SetupDetails(0, 0, mounts, Optional.empty(), List.of()));
  }

  /** What was read, at the robot's believed poses. */
  List<ReadingRow> rows() {
    SensingSetup setup = setup();
    NominalModel model = new NominalModel(setup.sensor(), setup.scene());
    Random scatter = new Random(random.nextLong());
    List<ReadingRow> seen = SensorPoses.of(setup, real);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < seen.size(); i++) {
      ReadingRow at = believed.get(i);
      rows.add(
          new ReadingRow(
              at.run(),
              at.sensor(),
              at.timeS(),
              at.pose(),
              model.distribution(seen.get(i).pose()).sample(scatter)));
    }
    return rows;
  }

  DataSet data() {
    return new DataSet("joint", setup(), SensorPoses.of(setup(), rows()), List.of());
  }

  private final class Run {
    private final String name;
    private final List<Command> commands = new ArrayList<>();
    private final List<TrackPose> track = new ArrayList<>();
    private double x = 0.9;
    private double y = 0.9;
    private double heading = 0.3;
    private double believedX = x;
    private double believedY = y;
    private double believedHeading = heading;

    Run(String name) {
      this.name = name;
    }

    void drive() {
      double until = 0;
      double v = 0;
      double w = 0;
      for (int i = 0; i * DT <= seconds; i++) {
        double t = i * DT;
        if (t >= until) {
          double held = 0.8 + 2 * random.nextDouble();
          double[] next = next(held);
          v = next[0];
          w = next[1];
          commands.add(new Command(t, v, w));
          until = t + held;
        }
        if (i % PER_POSE == 0) {
          track.add(
              new TrackPose(
                  t,
                  x + SIGMA_M * random.nextGaussian(),
                  y + SIGMA_M * random.nextGaussian(),
                  heading + SIGMA_RAD * random.nextGaussian()));
        }
        if (i % PER_PING == 0) {
          ping(t);
        }
        step(v, w);
      }
      driven.add(new MotionRun(name, commands, track));
    }

    private void step(double v, double w) {
      double counted = v * motors * DT;
      double turned = w * motors * DT;
      believedX += counted * Math.cos(believedHeading + turned / 2);
      believedY += counted * Math.sin(believedHeading + turned / 2);
      believedHeading += turned;
      double turn = turned * wheels + bias * DT;
      x += counted * wheels * Math.cos(heading + turn / 2);
      y += counted * wheels * Math.sin(heading + turn / 2);
      heading += turn;
    }

    /** A command that leads into no box; if none is found it turns where it is. */
    private double[] next(double held) {
      for (int i = 0; i < 200; i++) {
        double v = 0.05 + 0.25 * random.nextDouble();
        double w = 1.6 * random.nextDouble() - 0.8;
        if (isFree(v, w, held)) {
          return new double[] {v, w};
        }
      }
      return new double[] {0, 0.7};
    }

    private boolean isFree(double v, double w, double held) {
      double atX = x;
      double atY = y;
      double at = heading;
      for (double t = 0; t < held + 0.5; t += 0.1) {
        at += 0.1 * w;
        atX += 0.11 * v * Math.cos(at);
        atY += 0.11 * v * Math.sin(at);
        double placeX = atX;
        double placeZ = -atY;
        boolean clear =
            Math.abs(placeX) < MOST_M
                && Math.abs(placeZ) < MOST_M
                && Logs.ROOM.scene().obstacles().stream()
                    .allMatch(
                        one ->
                            Math.hypot(
                                    placeX - one.worldFromObstacle().xM(),
                                    placeZ - one.worldFromObstacle().zM())
                                > CLEAR_M);
        if (!clear) {
          return false;
        }
      }
      return true;
    }

    private void ping(double t) {
      for (String sensor : SENSORS) {
        believed.add(row(sensor, t, believedX, believedY, believedHeading));
        real.add(row(sensor, t, x, y, heading));
      }
    }

    private ReadingRow row(String sensor, double t, double px, double py, double angle) {
      return new ReadingRow(name, sensor, t, Pose.of(px, -py, angle), NoEcho.NO_ECHO);
    }
  }
}
