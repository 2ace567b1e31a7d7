package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import simbad.definition.Trait;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Tries;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Placement;
import simbad.sonar.ping.PingLog;

/**
 * Looks for the arc of headings over which a sensor that stood at one place heard its one obstacle,
 * beside the arc over which it should have: the arc whose pings, less those outside it, most often
 * have such echoes (the largest sum of a stretch, Kadane 1977), so that strays tell nothing.
 */
public final class ArcSearch {
  /** Echoes of one obstacle before a sensor that turns: within a tenth of their middle. */
  private static final double ALIKE = 0.1;

  /** Fewer echoes are no arc. */
  private static final int LEAST = 4;

  private final LogClues clues;
  private final PingLog log;

  /** From the direction of the obstacle as the hypothesis has it, to the left, by ping. */
  private final double[] leftRad;

  private final List<Integer> byAngle;

  private ArcSearch(LogClues clues) {
    this.clues = clues;
    log = clues.log;
    leftRad =
        IntStream.range(0, log.size())
            .mapToDouble(ping -> -clues.geometry.offAxisRad(ping))
            .toArray();
    byAngle =
        IntStream.range(0, leftRad.length)
            .boxed()
            .sorted(Comparator.comparingDouble(ping -> leftRad[ping]))
            .toList();
  }

  /**
   * Returns where to begin with two at a time: with what turns or moves something and with a cone
   * of the arc's width. A search for one after the other stops halfway, where a cone as wide as all
   * of the arc is the best single answer.
   *
   * @param given the log
   * @param forms that are looked for
   * @return none where {@link Clues#heardArc} has none
   */
  public static List<Hypothesis> starts(CalibratedLog given, List<Form> forms) {
    Optional<Clues.HeardArc> arc = new LogClues(given, Hypothesis.NONE).heardArc();
    List<Hypothesis> starts = new ArrayList<>();
    for (int i = 0; arc.isPresent() && i < forms.size(); i++) {
      Optional<Hypothesis> one = with(Hypothesis.NONE, forms.get(i), arc.get());
      for (int j = i + 1; one.isPresent() && j < forms.size(); j++) {
        Form second = forms.get(j);
        boolean isOther = soaksUp(second) != soaksUp(forms.get(i));
        Optional<Hypothesis> both = with(one.get(), second, arc.get());
        both.filter(set -> isOther).ifPresent(starts::add);
      }
    }
    return starts;
  }

  private static Optional<Hypothesis> with(Hypothesis set, Form form, Clues.HeardArc arc) {
    return Definitions.of(form.effect())
        .whereHeard(form, arc)
        .map(values -> set.and(form, Tries.within(form, values)));
  }

  /** What moves or turns something; the others are about the cone. */
  private static boolean soaksUp(Form form) {
    return Definitions.of(form.effect()).traits().contains(Trait.SOAKS_UP_PLACEMENTS);
  }

  /** Empty where the sensor moved, hears by levels, has several obstacles, or heard nothing. */
  static Optional<Clues.HeardArc> find(LogClues clues) {
    boolean isLone = clues.obstacles() == 1 && clues.geometry.ears() == null;
    return isLone && clues.log.echoes() >= LEAST && clues.log.isOfOnePlace()
        ? new ArcSearch(clues).found()
        : Optional.empty();
  }

  private Optional<Clues.HeardArc> found() {
    double middle =
        Robust.median(
            IntStream.range(0, log.size()).filter(log::echo).mapToDouble(log::rangeM).toArray());
    double[] heard =
        arc(ping -> log.echo(ping) && Math.abs(log.rangeM(ping) - middle) < ALIKE * middle);
    double[] expected = arc(ping -> clues.nearestM(ping) < Double.POSITIVE_INFINITY);
    if (heard.length == 0 || expected.length == 0) {
      return Optional.empty();
    }
    double turn = (heard[0] + heard[1] - expected[0] - expected[1]) / 2;
    double wider = (heard[1] - heard[0] - expected[1] + expected[0]) / 2;
    return Optional.of(arc(turn, wider));
  }

  private Clues.HeardArc arc(double turnRad, double widerRad) {
    Placement there = clues.geometry.scene().obstacles().get(0).worldFromObstacle();
    double x = there.xM() - log.xM(0);
    double z = there.zM() - log.zM(0);
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    // Counter-clockwise seen from above, where z grows down the page.
    return new Clues.HeardArc(turnRad, widerRad, x * cos + z * sin - x, z * cos - x * sin - z);
  }

  /**
   * The headings at which the best stretch of pings begins and ends; none where no ping is such.
   */
  private double[] arc(IntPredicate isSuch) {
    int sum = 0;
    int most = 0;
    int from = 0;
    double[] arc = {};
    for (int at = 0; at < byAngle.size(); at++) {
      from = sum <= 0 ? at : from;
      sum = Math.max(sum, 0) + (isSuch.test(byAngle.get(at)) ? 1 : -1);
      if (sum > most) {
        most = sum;
        arc = new double[] {leftRad[byAngle.get(from)], leftRad[byAngle.get(at)]};
      }
    }
    return Arrays.stream(arc).map(Angles::signed).toArray();
  }
}
