package simbad.gap.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.Placements;
import simbad.gap.score.Probabilities;
import simbad.sonar.change.LevelDrift;
import simbad.sonar.change.LevelScatter;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.PingLog;

/**
 * What has no name among the effects, and happens all the same: echoes whose strength scatters or
 * drifts. Where it does as well in the place of an effect, that effect only stands in for it. Under
 * the level law alone, which knows how strong an echo is.
 */
public final class Strangers {
  private static final double MOST_SCATTER_DB = 20;
  private static final double MOST_DB = 30;

  /** Beyond, in natural logarithms, one is sure. */
  private static final double MOST_NATS = 50;

  private final Evidence evidence;
  private final SetupLeave leave;
  private final List<Form> forms;

  /**
   * Looks for them.
   *
   * @param evidence the log, under the level law
   * @param leave that the set-up has
   */
  public Strangers(Evidence evidence, SetupLeave leave) {
    this.evidence = evidence;
    this.leave = leave;
    PingLog log = evidence.log();
    // Where things are placed one after the other, a drift is what each placement is off by.
    forms = forms(new Placements(log).areRepeated() ? 0 : log.lastsS());
  }

  private static List<Form> forms(double durationS) {
    List<Form> forms = new ArrayList<>();
    forms.add(
        new Form(
            Optional.empty(),
            "level-scatter",
            List.of(decibels("mean_db"), Parameter.of("scatter_db", 0, 0, MOST_SCATTER_DB, 3)),
            v -> new LevelScatter(v[0], v[1])));
    if (durationS > 0) {
      forms.add(
          new Form(
              Optional.empty(),
              "level-drift",
              List.of(decibels("first_db"), decibels("halfway_db"), decibels("last_db")),
              v -> new LevelDrift(v[0], v[1], v[2], durationS)));
    }
    return forms;
  }

  private static Parameter decibels(String name) {
    return Parameter.of(name, 0, -MOST_DB, MOST_DB, -2);
  }

  /**
   * What was found.
   *
   * @param odds how many times as likely as the named set they are, together
   * @param what the likeliest of them does, in words; empty where the named set is likelier than
   *     all
   */
  public record Found(double odds, String what) {
    /** Returns the probability of the named set against all of them, in (0, 1]. */
    public double share() {
      return 1 / (1 + odds);
    }
  }

  /**
   * Weighs a set of effects against what does as well without a name: in the place of each of its
   * effects, and beside all of them. Beside them, and in the place of an effect of levels, whose
   * work it can do besides its own, it has to gain what a further effect has to.
   *
   * @param named the set
   * @param worthNats what a further effect must gain to be as probable as its absence
   * @param temperature by which nats are divided
   */
  public Found against(Hypothesis named, double worthNats, double temperature) {
    if (System.getProperty("dev") != null) { dev(named, worthNats, temperature); }

    List<Rival> rivals = new ArrayList<>();
    for (Form form : forms) {
      rivals.add(new Rival(named, form, worthNats));
      for (Effect effect : named.effects()) {
        double cost = isOfLevels(effect, named) ? worthNats : 0;
        rivals.add(new Rival(named.without(effect), form, cost));
      }
    }
    double own = nats(polished(new Fitter(evidence, Fold.ALL), named));
    List<Weight> weights =
        rivals.parallelStream()
            .map(rival -> rival.fitted(this))
            .map(fit -> fit.weight(own, temperature))
            .toList();
    double sum = weights.stream().mapToDouble(Weight::times).sum();
    Weight most = Collections.max(weights, Comparator.comparingDouble(Weight::times));
    return new Found(sum, sum > 1 ? words(most.set) : "");
  }

  private void dev(Hypothesis named, double worthNats, double temperature) {
    double own = nats(polished(new Fitter(evidence, Fold.ALL), named));
    System.out.printf("DEV named %s own %.1f worth %.1f temperature %.2f%n", named.effects(), own, worthNats, temperature);
    double duration = new Placements(evidence.log()).areRepeated() ? 0 : evidence.log().lastsS();
    List<Hypothesis> rests = new ArrayList<>();
    rests.add(named);
    for (Effect effect : named.effects()) { rests.add(named.without(effect)); }
    if (named.effects().size() > 1) { rests.add(Hypothesis.NONE); }
    for (Hypothesis rest : rests) {
      double plain = Arrays.stream(evidence.logLikelihood(rest)).sum() + leave.nats(rest) - 0.5 * rest.size();
      System.out.printf("DEV  rest %s plain %+.1f%n", rest.effects(), plain - own);
      for (Wandering.Curve curve : new Wandering(leave.leeway().orElseThrow(), evidence, rest, duration).curves()) {
        System.out.printf("DEV    %+.1f %s%n", curve.nats() - 0.5 * rest.size() - own, curve.what());
      }
    }
  }

  /** Whether an effect is itself a matter of levels: a stranger does all that it does. */
  private static boolean isOfLevels(Effect effect, Hypothesis set) {
    int at = set.effects().indexOf(effect);
    return set.forms().get(at).with(set.valuesOf(at)) instanceof LevelChange;
  }

  /** A stranger beside some effects, and what it has to gain. */
  private record Rival(Hypothesis rest, Form form, double costNats) {
    Fitted fitted(Strangers log) {
      double[] start = form.parameters().stream().mapToDouble(p -> p.tries().get(0)).toArray();
      Hypothesis first = rest.and(form, start);
      Fitter fitter = new Fitter(log.evidence, Fold.ALL);
      Fit far = fitter.refine(first, rest.size(), 20 + 20 * start.length);
      Fit fit = polished(fitter, far.hypothesis());
      return new Fitted(fit.hypothesis(), log.nats(fit) - costNats);
    }
  }

  private record Fitted(Hypothesis set, double nats) {
    Weight weight(double own, double temperature) {
      return new Weight(set, Math.exp(Math.min(MOST_NATS, (nats - own) / temperature)));
    }
  }

  /** How many times as likely as the named set. */
  private record Weight(Hypothesis set, double times) {}

  /** A table has too many values for it: it stays as it was read off the log. */
  private static Fit polished(Fitter fitter, Hypothesis set) {
    return fitter.polish(set, set.hasTable() ? 0 : 20 + 15 * set.size());
  }

  private double nats(Fit fit) {
    Hypothesis set = fit.hypothesis();
    return fit.logLikelihood() + leave.nats(set) - Probabilities.NATS_PER_VALUE * set.size();
  }

  private static String words(Hypothesis set) {
    int last = set.forms().size() - 1;
    if (set.forms().get(last).with(set.valuesOf(last)) instanceof LevelScatter scatter) {
      return String.format(
          Locale.ROOT,
          "echoes get stronger and weaker from ping to ping, by %.1f dB more than the set-up's do",
          scatter.scatterDb());
    }
    double[] drift = set.valuesOf(last);
    return String.format(
        Locale.ROOT,
        "the strength of echoes drifts while the log is taken: %.1f dB at the start, %.1f dB halfway,"
            + " %.1f dB at the end",
        drift[0],
        drift[1],
        drift[2]);
  }
}
