package simbad.gap.motion;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Verdict;
import simbad.motion.Command;
import simbad.motion.effect.FittedMotion;
import simbad.motion.forecast.MotionForecast;
import simbad.sonar.check.Checks;

/**
 * What a diagnosis of motion concludes.
 *
 * @param verdict of the whole
 * @param headline one sentence that says why
 * @param findings the effects of the explanation, the surest first
 * @param others every other name of the vocabulary, most probable first
 * @param unknownProbability that something without a name is at work
 * @param signs by which it is judged how sure this is, by name; empty where nothing was judged
 * @param gap how far forecasts are off before and after
 * @param budget how the gap before is made up, in units of it; adds up to 1
 * @param places where the gap is
 * @param undetectable effects that these data could not have shown
 * @param next a drive that would tell tied effects apart
 * @param fitted the forms of the diagnosed model beside what is believed, those first that a
 *     reference has shown
 * @param forecast the diagnosed model, as it was fitted to the whole log
 */
public record MotionDiagnosis(
    Verdict verdict,
    String headline,
    List<MotionFinding> findings,
    List<MotionFinding> others,
    double unknownProbability,
    Map<String, Double> signs,
    Gap gap,
    List<Part> budget,
    List<MotionPlace> places,
    List<Hidden> undetectable,
    Optional<NextDrive> next,
    List<FittedMotion> fitted,
    MotionForecast forecast) {
  /** Copies the lists. */
  public MotionDiagnosis {
    Checks.number("unknownProbability", unknownProbability);
    findings = List.copyOf(findings);
    others = List.copyOf(others);
    budget = List.copyOf(budget);
    signs = Collections.unmodifiableMap(new LinkedHashMap<>(signs));
    places = List.copyOf(places);
    undetectable = List.copyOf(undetectable);
    fitted = List.copyOf(fitted);
  }

  /** Tells whether the log was too short to say anything. */
  public boolean isSilent() {
    return gap.windows() == 0;
  }

  /** Returns how probable it is that a verdict is the right one; 0 where nothing was judged. */
  public double probability(Verdict of) {
    return signs.isEmpty() ? 0 : MotionConstants.own().verdict(of, signs);
  }

  /** Returns the same with another model. */
  MotionDiagnosis with(List<FittedMotion> model, MotionForecast foretelling) {
    return new MotionDiagnosis(
        verdict,
        headline,
        findings,
        others,
        unknownProbability,
        signs,
        gap,
        budget,
        places,
        undetectable,
        next,
        model,
        foretelling);
  }

  /**
   * How far forecasts are off, on blocks that were not fitted.
   *
   * @param windows of half a second that were scored
   * @param before of the nominal model by horizon (0.5, 2, 5 s) and component (along m, across m,
   *     turn rad)
   * @param after of the diagnosed model
   * @param coverage share of what was seen within forecasts of 90 %, of the diagnosed model
   * @param ratio the gap: the mean of the nine, each in units of its nominal value
   * @param ratioHere95 interval of it, as stretches of this log tell it
   * @param ratioCi95 where it would lie on another drive of the robot, 19 times of 20
   * @param floor the gap that scatter alone would leave, in the same units
   */
  @SuppressWarnings("ArrayRecordComponent") // Nine numbers, never compared.
  public record Gap(
      int windows,
      double[][] before,
      double[][] after,
      double[][] coverage,
      double ratio,
      Interval ratioHere95,
      Interval ratioCi95,
      double floor) {
    /** Refuses what is no number. */
    public Gap {
      Checks.numbers("before", before);
      Checks.numbers("after", after);
      Checks.numbers("coverage", coverage);
      Checks.number("ratio", ratio);
      Checks.number("floor", floor);
    }

    /** Returns by how much the gap shrinks, a fraction. */
    public double shrink() {
      return 1 - ratio;
    }

    /** Returns the interval of that, as stretches of this log tell it. */
    public Interval shrinkHere95() {
      return shrinks(ratioHere95);
    }

    /** Returns by how much the gap of another drive of the robot would shrink, 19 times of 20. */
    public Interval shrinkCi95() {
      return shrinks(ratioCi95);
    }

    private static Interval shrinks(Interval ratio) {
      return new Interval(1 - ratio.high(), 1 - ratio.low());
    }
  }

  /**
   * A part of the gap.
   *
   * @param what an effect's name, rest or floor
   * @param share of the gap before
   * @param ci95 interval of it
   */
  public record Part(String what, double share, Interval ci95) {
    /** Refuses what is no number. */
    public Part {
      Checks.number("share", share);
    }
  }

  /**
   * An effect that these data could not have shown.
   *
   * @param effect its name
   * @param parameter whose size is meant
   * @param leastSize that would have shown; infinite where none would
   */
  public record Hidden(String effect, String parameter, double leastSize) {
    /** Refuses what is no number. */
    public Hidden {
      Checks.number("leastSize", leastSize);
    }
  }

  /**
   * A drive that would tell effects apart.
   *
   * @param separates their names
   * @param commands to give
   * @param expectedLogOdds between the two, nats
   */
  public record NextDrive(List<String> separates, List<Command> commands, double expectedLogOdds) {
    /** Copies the lists. */
    public NextDrive {
      Checks.number("expectedLogOdds", expectedLogOdds);
      separates = List.copyOf(separates);
      commands = List.copyOf(commands);
    }
  }
}
