package simbad.blindworld.motionchange;

import java.util.List;
import java.util.Map;
import simbad.blindworld.motion.Acting;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Lag;
import simbad.blindworld.motion.MotionChange;
import simbad.blindworld.motion.MotionChange.Stage;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Step;
import simbad.blindworld.motionchange.MotionForm.Drawn;

/** Effects in time: actuation-latency, actuation-lag, time-offset. */
final class TimeForms {

  private TimeForms() {}

  static List<MotionForm> all() {
    return List.of(
        MotionForm.anywhere("actuation-latency", "fixed", TimeForms::fixed),
        MotionForm.anywhere("actuation-latency", "unsteady", TimeForms::unsteady),
        MotionForm.anywhere("actuation-latency", "sampled loop", TimeForms::sampled),
        MotionForm.anywhere("actuation-latency", "longer when fast", TimeForms::bySpeed),
        MotionForm.anywhere("actuation-lag", "time constant", TimeForms::timeConstant),
        MotionForm.anywhere("actuation-lag", "greatest acceleration", TimeForms::acceleration),
        MotionForm.anywhere("actuation-lag", "brakes otherwise", TimeForms::brakes),
        MotionForm.anywhere("actuation-lag", "two time constants", TimeForms::twice),
        MotionForm.anywhere("actuation-lag", "controller at a rate", TimeForms::controller),
        MotionForm.differential("actuation-lag", "of each wheel", TimeForms::wheels),
        MotionForm.anywhere("time-offset", "fixed", TimeForms::offset));
  }

  private static Drawn fixed(MotionSite site) {
    double s = site.sized(0.15);
    return new Drawn(Map.of("s", s), MotionChange.latency(s));
  }

  /** Each command late by its own time, a fifth more or less. */
  private static Drawn unsteady(MotionSite site) {
    double s = site.sized(0.15);
    return new Drawn(
        Map.of("s", s),
        MotionChange.heard(
            Stage.TIME, (told, random) -> later(told, i -> s * random.nextDouble(0.8, 1.2))));
  }

  /** By how much each command is late. */
  private interface Delay {
    double s(int index);
  }

  private static Commands later(Commands told, Delay delay) {
    double[] times = new double[told.size()];
    for (int i = 0; i < times.length; i++) {
      times[i] = told.timeS(i) + delay.s(i);
    }
    return told.atTimes(times);
  }

  /** A controller that looks for commands at a rate of its own, and needs a while besides. */
  private static Drawn sampled(MotionSite site) {
    double period = Math.max(1e-9, site.sized(0.12));
    double least = site.sized(0.09);
    double phase = site.between(0, 1);
    return new Drawn(
        Map.of("period_s", period, "s", least),
        site.size() > 0
            ? MotionChange.heard(
                Stage.TIME,
                (told, random) -> later(told, i -> least + wait(told, i, period, phase)))
            : MotionChange.latency(0));
  }

  private static double wait(Commands told, int index, double period, double phase) {
    double place = told.timeS(index) / period + phase;
    return (Math.ceil(place) - place) * period;
  }

  private static Drawn bySpeed(MotionSite site) {
    double s = site.sized(0.12);
    double most = site.speed(1);
    return new Drawn(
        Map.of("s", s, "s_more_at_most", s / 2),
        MotionChange.heard(
            Stage.TIME,
            (told, random) ->
                later(told, i -> s * (1 + 0.5 * Math.abs(told.at(i).vMPerS()) / most))));
  }

  private static Drawn timeConstant(MotionSite site) {
    double v = site.sized(0.2) * site.between(0.7, 1.4);
    double w = site.sized(0.2) * site.between(0.7, 1.4);
    return new Drawn(Map.of("speed_s", v, "turn_s", w), Lag.firstOrder(v, w));
  }

  /** As long as it takes for a common command at this greatest acceleration. */
  private static double perS2(MotionSite site, double common, double whileS) {
    return site.size() > 0 ? common / site.sized(whileS) : Double.POSITIVE_INFINITY;
  }

  private static Map<String, Object> finite(double v, double w) {
    return Map.of("m_s2", Math.min(v, 1e6), "rad_s2", Math.min(w, 1e6));
  }

  private static Drawn acceleration(MotionSite site) {
    double v = perS2(site, site.speed(0.7), 0.5);
    double w = perS2(site, site.turn(0.7), 0.5);
    return new Drawn(finite(v, w), Lag.approaching(Lag.limited(v), Lag.limited(w)));
  }

  /** Slow to start and quick to brake, or the other way round. */
  private static Drawn brakes(MotionSite site) {
    double growing = site.sized(0.25);
    double braking = growing * (site.random().nextBoolean() ? 0.3 : 2.2);
    Lag.Approach both = Lag.unequal(Lag.exponential(growing), Lag.exponential(braking));
    return new Drawn(
        Map.of("growing_s", growing, "braking_s", braking), Lag.approaching(both, both));
  }

  private static Drawn twice(MotionSite site) {
    double first = site.sized(0.15);
    double second = first * site.between(0.3, 0.9);
    MotionChange one = Lag.firstOrder(first, first);
    MotionChange other = Lag.firstOrder(second, second);
    return new Drawn(
        Map.of("first_s", first, "second_s", second),
        MotionChange.acting(
            Stage.ACTUATION,
            random -> inTurn(one.begin().apply(random), other.begin().apply(random))));
  }

  static Acting inTurn(Acting one, Acting other) {
    return new Acting() {
      @Override
      public void beginRun() {
        one.beginRun();
        other.beginRun();
      }

      @Override
      public void move(Step step) {
        one.move(step);
        other.move(step);
      }
    };
  }

  /** At each tick of a controller the speed gets a share of what is missing. */
  private static Drawn controller(MotionSite site) {
    double period = MotionWorld.STEP_S * Math.rint(site.between(2, 5));
    double share = site.size() > 0 ? 1 - StrictMath.exp(-period / site.sized(0.2)) : 1;
    int steps = site.size() > 0 ? (int) Math.rint(period / MotionWorld.STEP_S) : 1;
    return new Drawn(
        Map.of("period_s", period, "share", share),
        MotionChange.acting(Stage.ACTUATION, random -> new Controller(steps, share)));
  }

  private static final class Controller implements Acting {
    private final int steps;
    private final double share;
    private int count;
    private double v;
    private double w;

    Controller(int steps, double share) {
      this.steps = steps;
      this.share = share;
    }

    @Override
    public void beginRun() {
      count = 0;
      v = 0;
      w = 0;
    }

    @Override
    public void move(Step step) {
      if (count++ % steps == 0) {
        v += share * (step.v() - v);
        w += share * (step.w() - w);
      }
      step.set(v, w);
    }
  }

  /** Each wheel by a motor of its own, with the same greatest acceleration. */
  private static Drawn wheels(MotionSite site) {
    double common = site.speed(0.7) + site.turn(0.7) * site.baseM() / 2;
    double most = perS2(site, common, 0.5);
    double base = site.baseM();
    return new Drawn(
        Map.of("rim_m_s2", Math.min(most, 1e6)),
        MotionChange.acting(Stage.ACTUATION, random -> new Wheels(Lag.limited(most), base)));
  }

  private static final class Wheels implements Acting {
    private final Lag.Approach motor;
    private final double baseM;
    private double left;
    private double right;

    Wheels(Lag.Approach motor, double baseM) {
      this.motor = motor;
      this.baseM = baseM;
    }

    @Override
    public void beginRun() {
      left = 0;
      right = 0;
    }

    @Override
    public void move(Step step) {
      left = motor.next(left, step.v() - step.w() * baseM / 2);
      right = motor.next(right, step.v() + step.w() * baseM / 2);
      step.set((left + right) / 2, (right - left) / baseM);
    }
  }

  /** With one clock declared a track can only be late, as a robot cannot know what comes. */
  private static Drawn offset(MotionSite site) {
    double s = site.robot().separateClocks() ? site.eitherWay(0.18) : site.sized(0.18);
    return new Drawn(Map.of("s", s), shifted(s));
  }

  /** A track whose times are too large by so much. */
  static MotionChange shifted(double byS) {
    return MotionChange.acting(
        Stage.TRACK,
        random ->
            new Acting() {
              @Override
              public double agoS(double frameS, double logShare) {
                return byS;
              }
            });
  }
}
