package simbad.blindworld.motionchange;

import static simbad.blindworld.motion.MotionChange.acting;
import static simbad.blindworld.motion.MotionChange.frames;
import static simbad.blindworld.motion.MotionChange.steps;

import java.util.List;
import java.util.Map;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.Step;
import simbad.blindworld.motion.Wandering;
import simbad.blindworld.motionchange.MotionForm.Drawn;

/** What the vocabulary has no name for. */
final class OutsideMotion {

  private OutsideMotion() {}

  static List<MotionForm> all() {
    return List.of(
        MotionForm.anywhere("slope", "plane", OutsideMotion::slope),
        MotionForm.anywhere("dragging-cable", "from a post", OutsideMotion::cable),
        MotionForm.anywhere("wind", "gusts", OutsideMotion::wind),
        MotionForm.anywhere("battery-sag", "over the log", OutsideMotion::sag),
        MotionForm.anywhere("wheel-wear", "of one wheel", OutsideMotion::wear),
        MotionForm.anywhere("dropped-commands", "by chance", OutsideMotion::dropped),
        MotionForm.reversing("caster-kick", "at reversals", OutsideMotion::caster),
        MotionForm.anywhere("slow-in-turns", "by turn rate", OutsideMotion::slowInTurns),
        MotionForm.anywhere("understeer", "by speed", OutsideMotion::understeer),
        MotionForm.anywhere("turns-unequal", "left and right", OutsideMotion::unequal),
        MotionForm.reversing("reverse-unequal", "forth and back", OutsideMotion::reverse),
        MotionForm.anywhere("carpet", "half of the room", OutsideMotion::carpet),
        MotionForm.anywhere("link-clogs", "over the log", OutsideMotion::clogs),
        MotionForm.anywhere("marker-sway", "a mast", OutsideMotion::sway),
        MotionForm.anywhere("camera-skew", "unequal axes", OutsideMotion::skew),
        MotionForm.anywhere("clock-rate", "stretched", OutsideMotion::clockRate),
        MotionForm.anywhere("ringing", "underdamped", OutsideMotion::ringing),
        MotionForm.anywhere("wandering-bias", "over minutes", OutsideMotion::wanders),
        MotionForm.anywhere("floor-grain", "like a carpet's pile", OutsideMotion::grain));
  }

  /** A direction over the floor. */
  private record Direction(double x, double z) {
    static Direction draw(MotionSite site) {
      double angle = site.between(-Math.PI, Math.PI);
      return new Direction(StrictMath.cos(angle), StrictMath.sin(angle));
    }
  }

  /** Quicker downhill, slower uphill, and a little to the low side across. */
  private static Drawn slope(MotionSite site) {
    double share = site.sized(0.12);
    Direction down = Direction.draw(site);
    return new Drawn(
        Map.of("share", share, "down_x", down.x, "down_z", down.z),
        steps(
            Stage.WHEEL,
            step -> {
              double pull = share * Math.abs(step.v());
              step.drift(pull * down.x, pull * down.z);
            }));
  }

  /** A cable that pulls back the harder the further it is drawn out, and turns the robot. */
  private static Drawn cable(MotionSite site) {
    double perM = site.sized(0.25) / (4 * site.speed(1));
    double postX = site.between(-2, 2) * site.speed(1);
    double postZ = site.between(-2, 2) * site.speed(1);
    return new Drawn(
        Map.of("per_m", perM, "post_x", postX, "post_z", postZ),
        steps(
            Stage.WHEEL,
            step -> {
              double dx = postX - step.xM();
              double dz = postZ - step.zM();
              double far = StrictMath.hypot(dx, dz) + 1e-9;
              double pull = Math.min(0.5, perM * far);
              double along = (step.directionX() * dx + step.directionZ() * dz) / far;
              double left = (step.directionZ() * dx - step.directionX() * dz) / far;
              step.scale(1 + pull * along, 1);
              step.addTurn(pull * left * Math.abs(step.v()) / site.baseM() / 4);
            }));
  }

  /** Gusts from one side that last for some seconds. */
  private static Drawn wind(MotionSite site) {
    double perS = site.sized(0.12) * site.speed(0.5);
    double gustS = site.between(4, 15);
    Direction to = Direction.draw(site);
    return new Drawn(
        Map.of("gust_s", gustS, "m_s", perS, "to_x", to.x, "to_z", to.z),
        acting(
            Stage.WHEEL,
            random -> {
              Wandering gust = new Wandering(gustS, random);
              return MotionChange.moving(
                  step -> {
                    double blow = perS * (1 + gust.next()) * (step.v() == 0 ? 0 : 1);
                    step.drift(blow * to.x, blow * to.z);
                  });
            }));
  }

  /** As much too fast at the beginning as too slow at the end. */
  private static Drawn sag(MotionSite site) {
    double share = site.sized(0.1);
    double power = site.between(0.7, 2);
    return new Drawn(
        Map.of("power", power, "share", share),
        steps(
            Stage.WHEEL,
            step -> {
              double now = 1 + share - 2 * share * StrictMath.pow(step.logShare(), power);
              step.scale(now, now);
            }));
  }

  /** A wheel that is larger than the other one when new and smaller when worn. */
  private static Drawn wear(MotionSite site) {
    double perM = site.eitherWay(0.2);
    return new Drawn(
        Map.of("rad_m", perM),
        steps(Stage.WHEEL, step -> step.addTurn(perM * (1 - 2 * step.logShare()) * step.v())));
  }

  private static Drawn dropped(MotionSite site) {
    double share = Math.min(0.8, site.sized(0.35));
    return new Drawn(Map.of("share", share), CommandForms.dropped(share));
  }

  /** Casters that swing round when it goes back push the robot aside, each time the same way. */
  private static Drawn caster(MotionSite site) {
    double kick = site.eitherWay(0.15);
    return new Drawn(Map.of("rad", kick), acting(Stage.TURNING, random -> new Caster(kick)));
  }

  private static final class Caster implements Acting {
    private static final double SWING_S = 0.4;
    private final double kick;
    private double way;
    private double leftS;

    Caster(double kick) {
      this.kick = kick;
    }

    @Override
    public void beginRun() {
      way = 0;
      leftS = 0;
    }

    @Override
    public void move(Step step) {
      if (step.v() * way < 0) {
        leftS = SWING_S;
      }
      way = step.v() == 0 ? way : Math.signum(step.v());
      if (leftS > 0) {
        step.addTurn(way * kick / SWING_S);
        leftS -= step.durationS();
      }
    }
  }

  private static Drawn slowInTurns(MotionSite site) {
    double share = Math.min(0.8, site.sized(0.25));
    double most = site.turn(1);
    return new Drawn(
        Map.of("share", share),
        steps(
            Stage.WHEEL,
            step -> step.scale(1 + share * (0.4 - Math.min(1, Math.abs(step.w()) / most)), 1)));
  }

  private static Drawn understeer(MotionSite site) {
    double share = Math.min(0.8, site.sized(0.25));
    double most = site.speed(1);
    return new Drawn(
        Map.of("share", share),
        steps(
            Stage.WHEEL,
            step -> step.scale(1, 1 + share * (0.5 - Math.min(1, Math.abs(step.v()) / most)))));
  }

  /** Turns one way are too large, the other way too small. */
  private static Drawn unequal(MotionSite site) {
    double share = site.eitherWay(0.1);
    return new Drawn(
        Map.of("share", share),
        steps(Stage.WHEEL, step -> step.scale(1, 1 + share * Math.signum(step.w()))));
  }

  private static Drawn reverse(MotionSite site) {
    double share = site.eitherWay(0.1);
    return new Drawn(
        Map.of("share", share),
        steps(Stage.WHEEL, step -> step.scale(1 + share * Math.signum(step.v()), 1)));
  }

  /** One half of the room is slow and the other quick. */
  private static Drawn carpet(MotionSite site) {
    double share = site.sized(0.09);
    Direction across = Direction.draw(site);
    return new Drawn(
        Map.of("share", share, "x", across.x, "z", across.z),
        steps(
            Stage.WHEEL,
            step -> {
              boolean there = step.xM() * across.x + step.zM() * across.z > 0;
              double now = 1 + (there ? share : -share);
              step.scale(now, now);
            }));
  }

  /** Every ten seconds the link is clogged for five, in which commands come late. */
  private static Drawn clogs(MotionSite site) {
    double byS = site.sized(0.3);
    double everyS = site.between(8, 20);
    return new Drawn(
        Map.of("every_s", everyS, "s", byS),
        MotionChange.heard(
            Stage.TIME,
            (told, random) -> {
              double[] times = new double[told.size()];
              for (int i = 0; i < times.length; i++) {
                double place = told.timeS(i) / everyS;
                times[i] = told.timeS(i) + (place - Math.floor(place) < 0.5 ? byS : 0);
              }
              return told.atTimes(times);
            }));
  }

  /** The marker stands on a mast that leans back when the robot speeds up, and swings. */
  private static Drawn sway(MotionSite site) {
    double perS2 = site.sized(0.12);
    double hertz = site.between(0.6, 1.6);
    return new Drawn(
        Map.of("hz", hertz, "m_per_m_s2", perS2),
        acting(Stage.CHANCE, random -> new Mast(perS2, 2 * Math.PI * hertz)));
  }

  /** Its sway is a way that the tracker sees and the wheels have not made. */
  private static final class Mast implements Acting {
    private static final double DAMPING = 0.1;
    private final double size;
    private final double rate;
    private double out;
    private double outPerS;
    private double last;

    Mast(double size, double rate) {
      this.size = size;
      this.rate = rate;
    }

    @Override
    public void beginRun() {
      out = 0;
      outPerS = 0;
      last = 0;
    }

    @Override
    public void move(Step step) {
      double dt = step.durationS();
      double push = step.v() - last;
      last = step.v();
      outPerS -= size * rate * rate * push;
      outPerS -= (rate * rate * out + 2 * DAMPING * rate * outPerS) * dt;
      out += outPerS * dt;
      step.set(step.v() + outPerS, step.w());
    }
  }

  /** One axis of the picture is stretched and the other one pressed. */
  private static Drawn skew(MotionSite site) {
    double share = site.eitherWay(0.07);
    return new Drawn(
        Map.of("share", share), frames(s -> s.moveTo(s.xM() * (1 + share), s.zM() * (1 - share))));
  }

  /** The tracker's clock is early at the beginning and late at the end. */
  private static Drawn clockRate(MotionSite site) {
    double byS = site.eitherWay(0.4);
    return new Drawn(
        Map.of("s", byS),
        acting(
            Stage.TRACK,
            random ->
                new Acting() {
                  @Override
                  public double agoS(double frameS, double logShare) {
                    return byS * (logShare - 0.5);
                  }
                }));
  }

  /** Speeds that overshoot and swing about what is told. */
  private static Drawn ringing(MotionSite site) {
    double damping = 0.22 / Math.max(0.3, site.size());
    double hertz = site.between(0.7, 1.6);
    return new Drawn(
        Map.of("damping", damping, "hz", hertz),
        acting(Stage.ACTUATION, random -> new Ringing(2 * Math.PI * hertz, damping)));
  }

  private static final class Ringing implements Acting {
    private final double rate;
    private final double damping;
    private final double[] speed = new double[2];
    private final double[] change = new double[2];

    Ringing(double rate, double damping) {
      this.rate = rate;
      this.damping = damping;
    }

    @Override
    public void beginRun() {
      java.util.Arrays.fill(speed, 0);
      java.util.Arrays.fill(change, 0);
    }

    @Override
    public void move(Step step) {
      step.set(next(0, step.v(), step.durationS()), next(1, step.w(), step.durationS()));
    }

    private double next(int which, double wanted, double dt) {
      double missing = wanted - speed[which];
      change[which] += (rate * rate * missing - 2 * damping * rate * change[which]) * dt;
      speed[which] += change[which] * dt;
      return speed[which];
    }
  }

  /** A rate of turning by itself that is now left, now right. */
  private static Drawn wanders(MotionSite site) {
    double perS = site.sized(0.04);
    double periodS = site.logS() / site.between(1.5, 4);
    double phase = site.between(0, 1);
    return new Drawn(
        Map.of("period_s", periodS, "rad_s", perS),
        steps(
            Stage.TURNING,
            step -> {
              double turns = step.logShare() * step.logS() / periodS + phase;
              step.addTurn(perS * StrictMath.sin(2 * Math.PI * turns));
            }));
  }

  /** The pile of a carpet turns a robot that drives towards the direction in which it lies. */
  private static Drawn grain(MotionSite site) {
    double perM = site.sized(0.25);
    Direction pile = Direction.draw(site);
    return new Drawn(
        Map.of("rad_m", perM, "x", pile.x, "z", pile.z),
        steps(
            Stage.TURNING,
            step -> {
              double left = step.directionZ() * pile.x - step.directionX() * pile.z;
              step.addTurn(perM * left * Math.abs(step.v()));
            }));
  }
}
