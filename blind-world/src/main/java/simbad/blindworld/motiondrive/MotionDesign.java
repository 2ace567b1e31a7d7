package simbad.blindworld.motiondrive;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Commands.Speeds;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Pose;

/** A robot, how it is driven and who looks on: enough to make any number of logs. */
public final class MotionDesign {

  private static final List<Integer> RATES_HZ = List.of(10, 20, 30, 40, 50, 60, 100);
  private static final double SLOWEST_HZ = 2;
  private static final double FASTEST_HZ = 67;

  /** More frames than this are not kept: a fast camera films for a shorter while. */
  private static final int MOST_FRAMES = 24_000;

  /** How far a robot may be from the middle, in seconds at its greatest speed. */
  private static final double ROOM_S = 8;

  private final Robot robot;
  private final Driver.Kind kind;
  private final Driver.Limits limits;
  private final Link link;
  private final Camera camera;

  /** How commands come: so many a second in the mean, each a little early or late. */
  private record Link(double rateHz, double jitter, double pauses) {}

  /** Frames a second, the share of single frames that are lost, holes a minute. */
  private record Camera(int rateHz, double lost, double holesPerMinute) {}

  private MotionDesign(
      Robot robot, Driver.Kind kind, Driver.Limits limits, Link link, Camera camera) {
    this.robot = robot;
    this.kind = kind;
    this.limits = limits;
    this.link = link;
    this.camera = camera;
  }

  /** A design by chance. */
  public static MotionDesign draw(RandomGenerator random) {
    double baseM = rounded(logUniform(random, 0.05, 0.5), 4);
    Driver.Limits limits =
        new Driver.Limits(
            rounded(baseM * random.nextDouble(1, 3) + 0.05, 3),
            rounded(random.nextDouble(0.7, 1.8), 2));
    Robot robot =
        new Robot(
            rounded(baseM * random.nextDouble(0.15, 0.4), 4),
            baseM,
            random.nextInt(2) == 0,
            beliefs(random, limits),
            new Robot.Scatter(
                rounded(logUniform(random, 0.0003, 0.005), 5),
                Math.toRadians(rounded(logUniform(random, 0.05, 1), 3))),
            random.nextInt(4) == 0);
    Driver.Kind kind = Driver.kinds().get(random.nextInt(Driver.kinds().size()));
    Link link =
        new Link(
            logUniform(random, SLOWEST_HZ, FASTEST_HZ),
            random.nextDouble(0.02, 0.4),
            random.nextInt(3) == 0 ? random.nextDouble(1, 6) : 0);
    Camera camera =
        new Camera(
            RATES_HZ.get(random.nextInt(RATES_HZ.size())),
            random.nextInt(2) == 0 ? random.nextDouble(0, 0.02) : 0,
            random.nextInt(4) == 0 ? 0 : random.nextDouble(0, 4));
    return new MotionDesign(robot, kind, limits, link, camera);
  }

  /** Half of the simulators believe that commands act at once, the others something else. */
  private static Robot.Beliefs beliefs(RandomGenerator random, Driver.Limits limits) {
    boolean late = random.nextInt(10) < 3;
    boolean lags = random.nextInt(10) < 3;
    boolean limited = random.nextInt(3) == 0;
    return new Robot.Beliefs(
        late ? rounded(random.nextDouble(0.03, 0.25), 2) : 0,
        lags ? rounded(random.nextDouble(0.05, 0.3), 2) : 0,
        limited ? rounded(1.2 * limits.vMPerS(), 2) + 0.01 : Double.POSITIVE_INFINITY,
        limited ? rounded(1.2 * limits.wRadPerS(), 1) + 0.1 : Double.POSITIVE_INFINITY);
  }

  private static double logUniform(RandomGenerator random, double least, double most) {
    double low = StrictMath.log(least);
    return StrictMath.exp(low + (StrictMath.log(most) - low) * random.nextDouble());
  }

  static double rounded(double value, int decimals) {
    double scale = Math.rint(StrictMath.pow(10, decimals));
    return Math.rint(value * scale) / scale;
  }

  /** What the simulator believes of the robot. */
  public Robot robot() {
    return robot;
  }

  /** How it is driven, in a word. */
  public String kind() {
    return kind.word();
  }

  /** The greatest speed that is asked for. */
  public double mostMPerS() {
    return limits.vMPerS();
  }

  /** The greatest turn rate that is asked for. */
  public double mostRadPerS() {
    return limits.wRadPerS();
  }

  /** How many commands there are in a second. */
  public double commandsPerS() {
    return link.rateHz;
  }

  /** A log of about so many seconds, in one to four runs. */
  public Outing outing(double wantedS, Chance random) {
    double seconds = Math.min(wantedS, (double) MOST_FRAMES / camera.rateHz);
    int count = 1 + random.nextInt((int) Math.max(1, Math.min(4, seconds / 40)));
    List<Outing.Run> runs = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double lasts = seconds / count * random.nextDouble(0.85, 1.15);
      double begin = random.nextBoolean() ? 0 : Math.rint(random.nextDouble(1, 200));
      runs.add(run("run-" + (i + 1), begin, lasts, random.split()));
    }
    return new Outing(runs);
  }

  /** The camera runs from a whole second on; commands begin within the second after. */
  private Outing.Run run(String name, double beginS, double lastsS, Chance random) {
    double endS = beginS + Math.ceil(2 * lastsS) / 2;
    Pose start =
        new Pose(
            rounded(random.nextDouble(-1, 1), 3),
            rounded(random.nextDouble(-1, 1), 3),
            random.nextDouble(-Math.PI, Math.PI));
    Commands commands = commands(beginS, endS, start, random.split());
    return new Outing.Run(name, commands, frames(beginS, endS, random.split()), endS, start);
  }

  private Commands commands(double beginS, double endS, Pose start, Chance random) {
    Driver driver = Driver.draw(kind, limits, random.split());
    double reachM = ROOM_S * limits.vMPerS();
    Fence fence = new Fence(start, reachM, limits);
    List<Double> times = new ArrayList<>();
    List<Speeds> told = new ArrayList<>();
    double at = beginS + rounded(random.nextDouble(0.1, 0.9), 3);
    while (at < endS - 0.4) {
      Speeds speeds = written(fence.kept(at, driver.next(at)));
      times.add(at);
      told.add(speeds);
      at = rounded(at + pauseS(random), 3);
    }
    times.add(Math.max(at, rounded(endS - 0.4, 3)));
    told.add(Speeds.ZERO);
    return new Commands(
        times.stream().mapToDouble(Double::doubleValue).toArray(),
        told.stream().mapToDouble(Speeds::vMPerS).toArray(),
        told.stream().mapToDouble(Speeds::wRadPerS).toArray());
  }

  private double pauseS(Chance random) {
    double even = 1 / link.rateHz;
    double pause = even * (1 + link.jitter * random.nextDouble(-1, 1));
    boolean longer = random.nextDouble() < link.pauses / 60 * even;
    return Math.max(0.002, pause + (longer ? random.nextDouble(0.1, 0.5) : 0));
  }

  /** As a file holds it: what is written is what is told. */
  private Speeds written(Speeds speeds) {
    if (!robot.differential()) {
      return new Speeds(rounded(speeds.vMPerS(), 4), rounded(speeds.wRadPerS(), 4));
    }
    double base = robot.wheelBaseM();
    return Speeds.ofRims(rounded(speeds.left(base), 5), rounded(speeds.right(base), 5), base);
  }

  private double[] frames(double beginS, double endS, Chance random) {
    int count = (int) Math.floor((endS - beginS) * camera.rateHz) + 1;
    boolean[] lost = new boolean[count];
    double holes = camera.holesPerMinute / 60 / camera.rateHz;
    for (int i = 1; i < count; i++) {
      lost[i] |= random.nextDouble() < camera.lost;
      if (random.nextDouble() < holes) {
        int frames = (int) Math.ceil(random.nextDouble(0.1, 1.1) * camera.rateHz);
        Arrays.fill(lost, i, Math.min(count, i + frames), true);
      }
    }
    double[] times = new double[count];
    int kept = 0;
    for (int i = 0; i < count; i++) {
      if (!lost[i]) {
        times[kept++] = rounded(beginS + (double) i / camera.rateHz, 4);
      }
    }
    return Arrays.copyOf(times, kept);
  }

  /** Turns a robot back that would leave the room, as far as commands tell where it is. */
  private static final class Fence {
    private final double reachM;
    private final Driver.Limits limits;
    private double x;
    private double z;
    private double heading;
    private double lastS = Double.NaN;
    private Speeds last = Speeds.ZERO;
    private boolean turning;

    Fence(Pose start, double reachM, Driver.Limits limits) {
      this.reachM = reachM;
      this.limits = limits;
      x = start.xM();
      z = start.zM();
      heading = start.headingRad();
    }

    Speeds kept(double atS, Speeds wanted) {
      advance(atS);
      double home = StrictMath.atan2(z, -x);
      double off = Math.IEEEremainder(home - heading, 2 * Math.PI);
      boolean outside = StrictMath.hypot(x, z) > reachM;
      turning = outside && (turning ? Math.abs(off) > 0.4 : Math.abs(off) > 1.6);
      boolean goesOn = outside && Math.abs(off) < 1.6 && wanted.vMPerS() < 0;
      double w = Math.copySign(0.7 * limits.wRadPerS(), off);
      last = turning || goesOn ? new Speeds(0.3 * limits.vMPerS(), w) : wanted;
      return last;
    }

    private void advance(double atS) {
      double dt = Double.isNaN(lastS) ? 0 : atS - lastS;
      lastS = atS;
      double middle = heading + last.wRadPerS() * dt / 2;
      x += last.vMPerS() * dt * StrictMath.cos(middle);
      z -= last.vMPerS() * dt * StrictMath.sin(middle);
      heading += last.wRadPerS() * dt;
    }
  }
}
