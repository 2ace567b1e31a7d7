package simbad.gap.search;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.gap.calibrate.SetupLeave;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fit;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fit.Placements;
import simbad.gap.score.Probabilities;
import simbad.gap.unexplained.SetupScores;
import simbad.sonar.change.LevelDrift;
import simbad.sonar.change.LevelScatter;
import simbad.sonar.change.RangeSwing;
import simbad.sonar.check.Checks;
import simbad.sonar.effect.Form;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.PingLog;

/**
 * What has no name among the effects, and happens all the same: echoes whose strength scatters,
 * drifts, or changes along something as no effect does. Where it does as well in the place of an
 * effect, that effect only stands in for it. Under the level law alone, which knows how strong an
 * echo is.
 */
public final class Strangers {
  private static final double MOST_SCATTER_DB = 20;
  private static final double MOST_DB = 30;
  private static final double MOST_SWING_M = 0.5;

  /** Beyond, in natural logarithms, one is sure. */
  private static final double MOST_NATS = 50;

  private final CalibratedLog given;
  private final SetupLeave leave;
  private final double durationS;
  private final List<Form> forms;

  /**
   * Looks for them.
   *
   * @param given the log, under the level law
   * @param leave that the set-up has
   */
  public Strangers(CalibratedLog given, SetupLeave leave) {
    this.given = given;
    this.leave = leave;
    PingLog log = given.log();
    // Where things are placed one after the other, a drift is what each placement is off by.
    durationS = new Placements(log).areRepeated() ? 0 : log.lastsS();
    forms = forms(durationS);
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
    /** Refuses what is no number. */
    public Found {
      Checks.number("odds", odds);
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
    double own = nats(polished(new Fitter(given, Fold.ALL), named));
    Optional<Swinging.Found> swing = swing(named);
    List<Claim> claims = new ArrayList<>();
    rests(named, worthNats)
        .forEach(
            (rest, costNats) -> {
              forms.parallelStream()
                  .map(form -> fitted(rest, form))
                  .map(claim -> claim.less(costNats))
                  .forEachOrdered(claims::add);
              wandering(rest).map(claim -> claim.less(costNats)).forEach(claims::add);
              swing.map(found -> swinging(rest, found).less(costNats)).ifPresent(claims::add);
            });
    double odds = 0;
    Claim most = new Claim(Double.NEGATIVE_INFINITY, "");
    for (Claim claim : claims) {
      odds += Math.exp(Math.min(MOST_NATS, (claim.nats - own) / temperature));
      most = claim.nats > most.nats ? claim : most;
    }
    return new Found(odds, odds > 1 ? most.what : "");
  }

  /** Something without a name: how likely the log is with it, and what it does. */
  private record Claim(double nats, String what) {
    Claim less(double costNats) {
      return new Claim(nats - costNats, what);
    }
  }

  /** What may stand beside it of a set of effects, and what it has to gain there. */
  private static Map<Hypothesis, Double> rests(Hypothesis named, double worthNats) {
    Map<Hypothesis, Double> rests = new LinkedHashMap<>();
    rests.put(named, worthNats);
    for (Effect effect : named.effects()) {
      rests.put(named.without(effect), isOfLevels(effect, named) ? worthNats : 0);
    }
    return rests;
  }

  /** Whether an effect is itself a matter of levels: a stranger does all that it does. */
  private static boolean isOfLevels(Effect effect, Hypothesis set) {
    int at = set.effects().indexOf(effect);
    return set.forms().get(at).with(set.valuesOf(at)) instanceof LevelChange;
  }

  private Claim fitted(Hypothesis rest, Form form) {
    double[] start = form.parameters().stream().mapToDouble(p -> p.tries().get(0)).toArray();
    Fitter fitter = new Fitter(given, Fold.ALL);
    Fit far = fitter.settle(rest.and(form, start), rest.size(), 20 + 20 * start.length, 0);
    Fit fit = polished(fitter, far.hypothesis());
    return new Claim(nats(fit), words(fit.hypothesis()));
  }

  private Stream<Claim> wandering(Hypothesis rest) {
    return leave
        .leeway()
        .map(open -> new Wandering(open, given, rest, durationS).curves())
        .orElse(List.of())
        .stream()
        .map(curve -> new Claim(curve.nats() - ofValues(rest), curve.what()));
  }

  /** The likeliest swing beside a set, if the log is long enough for any. */
  private Optional<Swinging.Found> swing(Hypothesis named) {
    Geometry geometry = given.geometry(given.model(named));
    return new Swinging(
            SetupScores.perMetre(named, given::logLikelihood), geometry::sinceStartS, durationS)
        .likeliest();
  }

  /** Ranges that swing beside some effects, with a period that all of them left over. */
  private Claim swinging(Hypothesis rest, Swinging.Found found) {
    RangeSwing likeliest = found.swing();
    Form form =
        new Form(
            Optional.empty(),
            "range-swing",
            List.of(metres("sine_m", likeliest.sineM()), metres("cosine_m", likeliest.cosineM())),
            v -> new RangeSwing(v[0], v[1], likeliest.periodS()));
    // The period is a value, too.
    return fitted(rest, form).less(found.choiceNats() + Probabilities.NATS_PER_VALUE);
  }

  private static Parameter metres(String name, double start) {
    double within = Math.max(-MOST_SWING_M, Math.min(MOST_SWING_M, start));
    return Parameter.of(name, 0, -MOST_SWING_M, MOST_SWING_M, within);
  }

  /** A table has too many values for it: it stays as it was read off the log. */
  private static Fit polished(Fitter fitter, Hypothesis set) {
    return set.hasTable() ? fitter.polish(set, 0) : fitter.settle(set, 0, 0, 20 + 15 * set.size());
  }

  private double nats(Fit fit) {
    Hypothesis set = fit.hypothesis();
    return fit.logLikelihood() + leave.nats(set) - ofValues(set);
  }

  private static double ofValues(Hypothesis set) {
    return Probabilities.NATS_PER_VALUE * set.size();
  }

  private static String words(Hypothesis set) {
    int last = set.forms().size() - 1;
    Change change = set.forms().get(last).with(set.valuesOf(last));
    if (change instanceof LevelScatter scatter) {
      return String.format(
          Locale.ROOT,
          "echoes get stronger and weaker from ping to ping, by %.1f dB more than the set-up's do",
          scatter.scatterDb());
    }
    if (change instanceof RangeSwing swing) {
      return String.format(
          Locale.ROOT,
          "readings swing to and fro by %.1f cm, once in %.2f s",
          100 * swing.amplitudeM(),
          swing.periodS());
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
