package simbad.gap;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.gap.diagnosis.AtBound;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.Blocks;
import simbad.gap.score.GapGain;
import simbad.gap.search.Weighed;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;

/**
 * What is concluded of a log. What holds whatever the probabilities say: nothing is explained by a
 * value at the end of the search, and "none" never stands beside a gap that is plainly there.
 *
 * @param verdict of the log
 * @param reason why these data cannot tell, or why what fits is no explanation; empty for none
 * @param atBound values of the best set at the end of the search
 */
record Conclusion(Verdict verdict, String reason, List<AtBound> atBound) {
  /** A place of the gap that is no chance. */
  static final double SURE_PLACE = 0.01;

  /** Beside a large gap that its reference excuses, "none" has to be as sure as this. */
  private static final double SURELY_NOTHING = 0.1;

  /**
   * A name is said where it, or a tie with it, is as probable as this: a wrong name costs five
   * times what it costs to leave the log undecided.
   */
  private static final double SURE_NAME = 0.8;

  private static final long RESAMPLING = 1;

  /**
   * Something that has no name among the effects.
   *
   * @param probability that it is at work, in [0, 1]
   * @param signs by which it is so probable, by name
   * @param what it does, in words; empty where that is not known
   */
  record Unnamed(double probability, Map<String, Double> signs, String what) {
    /** What the verdict says of it, where it is as likely as not. */
    String reason() {
      return what.isEmpty() ? "" : what + ", and no effect of the list does that";
    }
  }

  /** Copies the list. */
  Conclusion {
    atBound = List.copyOf(atBound);
  }

  /**
   * Concludes.
   *
   * @param weighed the best set and what it gains
   * @param unnamed something that has no name
   * @param where the places of the gap
   * @param blocks of the log
   * @param tieNats evidence that still leaves two effects alike
   */
  static Conclusion of(
      Weighed weighed, Unnamed unnamed, List<Place> where, Blocks blocks, double tieNats) {
    if (!blocks.canBeHeldOut()) {
      return undecided(noHalves(weighed.gain()));
    }
    Hypothesis best = weighed.taken().hypothesis();
    List<AtBound> atBound = atBound(best);
    if (!atBound.isEmpty()) {
      return new Conclusion(Verdict.UNEXPLAINED, bounds(atBound), atBound);
    }
    double unknown = unnamed.probability();
    if (unknown > 0.5) {
      return new Conclusion(Verdict.UNEXPLAINED, unnamed.reason(), List.of());
    }
    if (!best.forms().isEmpty()) {
      return leavesMuch(weighed)
          ? new Conclusion(Verdict.UNEXPLAINED, left(weighed.gain()), List.of())
          : named(weighed, unknown, blocks, tieNats);
    }
    String doubt = doubt(weighed, unknown, where);
    return doubt.isEmpty() ? new Conclusion(Verdict.NONE, "", List.of()) : undecided(doubt);
  }

  /**
   * Concludes the same of a log in which no ping has an echo. What weakens echoes, loses them or
   * stops listening too early then looks alike: that one of them fits, or none, says nothing.
   */
  Conclusion ofSilence() {
    return verdict == Verdict.NONE
        ? this
        : undecided(
            "no ping of this log has an echo, and echoes that are too weak, lost or not waited for"
                + " look alike then: look at the cable and at the target first");
  }

  /**
   * Concludes the same where something more makes the readings plainly likelier, though it hardly
   * shows in the gap: then they are neither nothing nor wholly explained.
   *
   * @param more what does
   */
  Conclusion beside(Weighed.Unseen more) {
    String why =
        String.format(
            Locale.ROOT,
            "some readings are off as by %s (%.0f nats likelier with it); they are too few to show"
                + " in the gap, but too many for chance",
            more.effect(),
            more.nats());
    return switch (verdict) {
      case NONE -> undecided(why);
      case EXPLAINED -> new Conclusion(Verdict.PARTLY, why, List.of());
      default -> this;
    };
  }

  /** A table is read off the bearings that a half of the log has, and leaves those of the other. */
  private static boolean leavesMuch(Weighed weighed) {
    return !weighed.taken().hypothesis().hasTable() && weighed.gain().leavesMuch();
  }

  private static String left(GapGain gain) {
    return String.format(
        Locale.ROOT,
        "a gap of %.2f cm is left, but the diagnosed model expects only %.2f cm from scatter",
        100 * gain.afterM(),
        100 * gain.floorM());
  }

  /**
   * Concludes of what is sure, where of all of it that cannot be said. Empty where all of the best
   * set is sure but for what has no name: nothing is known to stand beside it then.
   *
   * @param sure effects that are sure
   * @param weighed the best set and what it gains
   * @param unnamed something that has no name
   * @param tieNats evidence that still leaves two effects alike
   */
  Optional<Conclusion> partly(Set<Effect> sure, Weighed weighed, Unnamed unnamed, double tieNats) {
    if (verdict != Verdict.UNDECIDED) {
      return Optional.of(new Conclusion(Verdict.PARTLY, reason, List.of()));
    }
    Set<Effect> others = new TreeSet<>(weighed.taken().hypothesis().effects());
    others.removeAll(sure);
    if (others.isEmpty()) {
      return Optional.empty();
    }
    String doubt = doubtfulName(others, weighed, unnamed.probability(), tieNats);
    String why = doubt.isEmpty() ? reason : doubt;
    return Optional.of(new Conclusion(Verdict.PARTLY, why, List.of()));
  }

  private static Conclusion named(Weighed weighed, double unknown, Blocks blocks, double tieNats) {
    List<Effect> names = weighed.taken().hypothesis().effects();
    String doubt = doubtfulName(names, weighed, unknown, tieNats);
    doubt = doubt.isEmpty() ? sponge(weighed, blocks) : doubt;
    return doubt.isEmpty() ? new Conclusion(Verdict.EXPLAINED, "", List.of()) : undecided(doubt);
  }

  /**
   * Why one of these effects cannot be named: one that two others could stand for is no name for
   * what happened, nor is one hardly likely. Empty where all can.
   */
  private static String doubtfulName(
      Iterable<Effect> names, Weighed weighed, double unknown, double tieNats) {
    for (Effect effect : names) {
      List<Effect> rivals = weighed.probabilities().tiesOf(effect, tieNats);
      if (rivals.size() > 1) {
        return "these data cannot tell " + effect.word() + " from " + words(rivals, ", ");
      }
      Set<Effect> tie = new TreeSet<>(rivals);
      tie.add(effect);
      double probability = (1 - unknown) * weighed.probabilities().ofAny(tie);
      if (probability < SURE_NAME) {
        return unsure(tie, probability);
      }
    }
    return "";
  }

  /** Rounded down: what is below the limit does not read like it. */
  private static String unsure(Set<Effect> tie, double probability) {
    return String.format(
        Locale.ROOT,
        "%s is likely (%.0f %%), but not likely enough to be named (%.0f %% is needed)",
        words(List.copyOf(tie), " or "),
        Math.floor(100 * probability),
        100 * SURE_NAME);
  }

  /**
   * Why an explanation that takes up a little of anything is none: the readings are likelier with
   * it, but the gap may be as large as before. Empty where it shrinks beyond chance.
   */
  private static String sponge(Weighed weighed, Blocks blocks) {
    Interval shrink = weighed.gain().shrinkage95(blocks, RESAMPLING);
    List<Effect> soaking =
        weighed.taken().hypothesis().effects().stream()
            .filter(effect -> Definitions.with(Trait.SOAKS_UP).contains(effect))
            .toList();
    return soaking.isEmpty() || shrink.low() > 0
        ? ""
        : String.format(
            Locale.ROOT,
            "%s can take up a little of any difference, and in another log the gap may be "
                + "as large as before: it shrinks by %.0f %% (95 %% interval %.0f to %.0f %%)",
            words(soaking, " + "),
            100 * weighed.gain().shrinkage(),
            100 * shrink.low(),
            100 * shrink.high());
  }

  private static Conclusion undecided(String reason) {
    return new Conclusion(Verdict.UNDECIDED, reason, List.of());
  }

  private static String noHalves(GapGain gain) {
    int rows = gain.before().observedM().length;
    if (rows >= 2 * Blocks.LEAST_ROWS) {
      return "all readings have the same time, but an effect is fitted on one stretch of "
          + "time and tested on another";
    }
    return String.format(
        Locale.ROOT,
        "there are too few readings: %d, where %d are needed, half of them to fit an effect and"
            + " half to test it",
        rows,
        2 * Blocks.LEAST_ROWS);
  }

  /** Why "none" cannot be said of what no effect explains; empty where it can. */
  private static String doubt(Weighed weighed, double unknown, List<Place> where) {
    GapGain gain = weighed.gain();
    if (gain.leavesMuch() || (unknown > SURELY_NOTHING && gain.isManyFloors())) {
      return String.format(
          Locale.ROOT,
          "no effect was found, but the gap is %.2f cm where the simulator expects %.2f cm from"
              + " scatter alone",
          100 * gain.beforeM(),
          100 * gain.floorM());
    }
    if (!weighed.enlarging().isEmpty()) {
      return "what makes these readings likelier ("
          + words(weighed.enlarging().get(0).hypothesis().effects(), " + ")
          + ") makes the gap larger on readings that it was not fitted on";
    }
    List<Place> sure = where.stream().filter(place -> place.qValue() < SURE_PLACE).toList();
    if (sure.isEmpty()) {
      return "";
    }
    Place largest = sure.get(0);
    String what =
        largest.shareOfGap() < 1
            ? String.format(
                Locale.ROOT,
                "one place of the log has %.0f %% of the gap",
                largest.shareOfGap() * 100)
            : "the gap is larger all over the log";
    return String.format(
        Locale.ROOT,
        "no effect was found, but %s, more than chance gives (q = %.1g)",
        what,
        largest.qValue());
  }

  private static String bounds(List<AtBound> atBound) {
    return atBound.stream()
            .map(
                one ->
                    String.format(
                        Locale.ROOT,
                        "%s of %s is at the end of the range that was searched (%s, from %s to %s)",
                        one.parameter(),
                        one.effect(),
                        number(one.value()),
                        number(one.allowed().low()),
                        number(one.allowed().high())))
            .collect(Collectors.joining("; "))
        + ", so it fits but explains nothing";
  }

  private static String number(double value) {
    return String.format(Locale.ROOT, "%.4g", value);
  }

  private static String words(List<Effect> effects, String between) {
    return effects.stream().map(Effect::word).collect(Collectors.joining(between));
  }

  private static List<AtBound> atBound(Hypothesis best) {
    List<AtBound> found = new ArrayList<>();
    for (int i = 0; i < best.forms().size(); i++) {
      Form form = best.forms().get(i);
      double[] values = best.valuesOf(i);
      for (int p = 0; p < values.length; p++) {
        Parameter parameter = form.parameters().get(p);
        if (parameter.isAtBound(values[p])) {
          Interval allowed = new Interval(parameter.low(), parameter.high());
          found.add(new AtBound(form.effect(), parameter.name(), values[p], allowed));
        }
      }
    }
    return found;
  }
}
