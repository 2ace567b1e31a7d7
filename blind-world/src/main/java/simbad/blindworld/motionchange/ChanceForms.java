package simbad.blindworld.motionchange;

import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.Step;
import simbad.blindworld.motion.Wandering;
import simbad.blindworld.motionchange.MotionForm.Drawn;

/** Effects of chance and of what is seen: slip, motion-noise, capture-offset. */
final class ChanceForms {

  private ChanceForms() {}

  static List<MotionForm> all() {
    return List.of(
        MotionForm.anywhere("slip", "bouts", ChanceForms::bouts),
        MotionForm.anywhere("slip", "one wheel", ChanceForms::oneWheel),
        MotionForm.anywhere("slip", "when it speeds up", ChanceForms::whenSpeedingUp),
        MotionForm.anywhere("motion-noise", "unsteady speeds", ChanceForms::unsteady),
        MotionForm.anywhere("motion-noise", "by command", ChanceForms::byCommand),
        MotionForm.anywhere("motion-noise", "uneven floor", ChanceForms::uneven),
        MotionForm.anywhere("capture-offset", "point", ChanceForms::point),
        MotionForm.anywhere("capture-offset", "heading", ChanceForms::heading),
        MotionForm.anywhere("capture-offset", "both", ChanceForms::both));
  }

  /**
   * Now and then a while of less way.
   *
   * @param perS how often one begins, in a second of driving
   * @param leastS how long it lasts
   * @param mostS how long it lasts
   * @param lost which share of the way is lost
   */
  private record Bout(double perS, double leastS, double mostS, double lost) {
    Map<String, Object> parameters() {
      return Map.of("per_s", perS, "least_s", leastS, "most_s", mostS, "lost", lost);
    }
  }

  /** A larger effect comes more often and loses more. */
  private static Bout bout(MotionSite site) {
    double half = Math.sqrt(site.size());
    return new Bout(0.12 * half, 0.3, site.between(0.8, 1.6), Math.min(0.95, 0.55 * half));
  }

  /** When wheels slip. */
  private static final class Slipping {
    private final Bout bout;
    private final RandomGenerator random;
    private double leftS;
    private int side;

    Slipping(Bout bout, RandomGenerator random) {
      this.bout = bout;
      this.random = random;
    }

    /** Whether it slips in a step; a bout may begin in one where it is more or less apt to. */
    boolean slips(Step step, double apt) {
      boolean moves = Math.abs(step.v()) > 1e-6 || Math.abs(step.w()) > 1e-6;
      boolean begins =
          leftS <= 0 && moves && random.nextDouble() < apt * bout.perS * step.durationS();
      if (begins) {
        leftS = bout.leastS + (bout.mostS - bout.leastS) * random.nextDouble();
        side = random.nextInt(2);
      }
      leftS -= step.durationS();
      return leftS > 0;
    }
  }

  private static Drawn bouts(MotionSite site) {
    Bout bout = bout(site);
    return new Drawn(
        bout.parameters(),
        MotionChange.acting(
            Stage.CHANCE,
            random -> {
              Slipping slipping = new Slipping(bout, random);
              return MotionChange.moving(
                  step -> {
                    if (slipping.slips(step, 1)) {
                      step.scale(1 - bout.lost, 1 - bout.lost);
                    }
                  });
            }));
  }

  private static Drawn oneWheel(MotionSite site) {
    Bout bout = bout(site);
    return new Drawn(
        bout.parameters(),
        MotionChange.acting(
            Stage.CHANCE,
            random -> {
              Slipping slipping = new Slipping(bout, random);
              return MotionChange.moving(
                  step -> {
                    if (slipping.slips(step, 1)) {
                      double rest = 1 - bout.lost;
                      step.scaleWheels(
                          slipping.side == 0 ? rest : 1,
                          slipping.side == 0 ? 1 : rest,
                          site.baseM());
                    }
                  });
            }));
  }

  /** Wheels let go where much is asked of them: while the speed grows. */
  private static Drawn whenSpeedingUp(MotionSite site) {
    Bout bout = bout(site);
    return new Drawn(
        bout.parameters(),
        MotionChange.acting(Stage.CHANCE, random -> new SpeedingUp(bout, random)));
  }

  private static final class SpeedingUp implements Acting {
    private static final double AFTER_S = 0.5;
    private static final double APT = 5;
    private static final double SELDOM = 0.3;
    private final Slipping slipping;
    private final Bout bout;
    private double before;
    private double sinceS = 1;

    SpeedingUp(Bout bout, RandomGenerator random) {
      this.bout = bout;
      this.slipping = new Slipping(bout, random);
    }

    @Override
    public void beginRun() {
      before = 0;
      sinceS = 1;
    }

    @Override
    public void move(Step step) {
      boolean grows = Math.abs(step.wantedV()) > Math.abs(before) + 1e-6;
      before = step.wantedV();
      sinceS = grows ? 0 : sinceS + step.durationS();
      if (slipping.slips(step, sinceS < AFTER_S ? APT : SELDOM)) {
        step.scale(1 - bout.lost, 1 - bout.lost);
      }
    }
  }

  /** Speeds that are a little more or less, for a fifth of a second to a second at a time. */
  private static Drawn unsteady(MotionSite site) {
    double v = site.sized(0.12);
    double w = site.sized(0.12);
    double constantS = site.between(0.2, 1);
    return new Drawn(
        Map.of("share_of_v", v, "share_of_w", w, "constant_s", constantS),
        MotionChange.acting(
            Stage.CHANCE,
            random -> {
              Wandering ofV = new Wandering(constantS, random);
              Wandering ofW = new Wandering(constantS, random);
              double most = site.turn(0.7);
              return MotionChange.moving(
                  step -> {
                    double turning = Math.max(Math.abs(step.w()), moves(step) ? most / 2 : 0);
                    double more = w * turning * ofW.next();
                    step.scale(1 + v * ofV.next(), 1);
                    step.addTurn(more);
                  });
            }));
  }

  private static boolean moves(Step step) {
    return Math.abs(step.v()) > 1e-6 || Math.abs(step.w()) > 1e-6;
  }

  /** For about a second the same factor of its own for each speed. */
  private static Drawn byCommand(MotionSite site) {
    double share = site.sized(0.12);
    return new Drawn(
        Map.of("share", share),
        MotionChange.acting(Stage.CHANCE, random -> new ByCommand(share, random)));
  }

  private static final class ByCommand implements Acting {
    private final double share;
    private final RandomGenerator random;
    private double leftS;
    private double ofV = 1;
    private double ofW = 1;

    ByCommand(double share, RandomGenerator random) {
      this.share = share;
      this.random = random;
    }

    @Override
    public void move(Step step) {
      leftS -= step.durationS();
      if (leftS <= 0) {
        leftS = random.nextDouble(0.5, 1.5);
        ofV = 1 + share * random.nextGaussian();
        ofW = 1 + share * random.nextGaussian();
      }
      step.scale(ofV, ofW);
    }
  }

  /**
   * Short pushes to the side and along, more often the further it drives; now and then a hard one.
   */
  private static Drawn uneven(MotionSite site) {
    double push = site.sized(0.35);
    return new Drawn(
        Map.of("share", push),
        MotionChange.acting(
            Stage.CHANCE,
            random ->
                MotionChange.moving(
                    step -> {
                      boolean hard = random.nextInt(20) == 0;
                      double much = push * (hard ? 3 : 1) * step.v();
                      step.addTurn(much * random.nextGaussian() / (2 * site.baseM()));
                      step.scale(1 + push * (hard ? 3 : 1) * random.nextGaussian(), 1);
                    })));
  }

  private static Drawn point(MotionSite site) {
    double forward = site.eitherWay(0.35) * site.baseM();
    double left = site.eitherWay(0.2) * site.baseM();
    return new Drawn(
        Map.of("forward_m", forward, "left_m", left),
        MotionChange.frames(sight -> sight.shift(forward, left)));
  }

  private static Drawn heading(MotionSite site) {
    double turned = Math.toRadians(site.eitherWay(4));
    return new Drawn(
        Map.of("deg", Math.toDegrees(turned)), MotionChange.frames(sight -> sight.turn(turned)));
  }

  private static Drawn both(MotionSite site) {
    double forward = site.eitherWay(0.3) * site.baseM();
    double left = site.eitherWay(0.15) * site.baseM();
    double turned = Math.toRadians(site.eitherWay(3));
    return new Drawn(
        Map.of("deg", Math.toDegrees(turned), "forward_m", forward, "left_m", left),
        MotionChange.frames(
            sight -> {
              sight.shift(forward, left);
              sight.turn(turned);
            }));
  }
}
