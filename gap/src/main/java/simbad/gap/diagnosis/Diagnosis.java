package simbad.gap.diagnosis;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import simbad.definition.Effect;
import simbad.gap.audit.AuditFinding;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.check.Checks;
import simbad.sonar.scene.SensorLaw;

/**
 * A diagnosis of one data set.
 *
 * @param verdict what is concluded
 * @param reason why these data cannot tell, or why what was fitted is no explanation, in a sentence
 *     without its full stop; empty where nothing needs one
 * @param explanation the effects concluded to be at work; empty for none
 * @param effects every name of the vocabulary, most probable first
 * @param unknownProbability that something outside the vocabulary is at work, alone or beside named
 *     effects
 * @param namedProbability that some effect of the vocabulary is at work, given that nothing outside
 *     it is
 * @param atBound parameters of the explanation that stand at an end of what was searched
 * @param gap its size before and after
 * @param budget how the gap before is made up; adds up to it
 * @param where the places of the gap, largest share first
 * @param undetectable effects that these data could not have shown
 * @param nextExperiment what to measure next; empty where nothing is tied
 * @param fitted the explanation with its forms and values
 * @param calibration what was calibrated of the set-up on the reference
 * @param tried sets of effects that were fitted together, best first, with their held-out log
 *     likelihood beyond the nominal model's in nats
 * @param signs of something without a name, by the names that their weights have
 * @param setupError how far the calibrated set-up is off on rows of the reference that it was not
 *     fitted on; empty where none were held out
 * @param audit what was found of the data before anything was fitted, worst first; empty where none
 *     was asked for
 */
public record Diagnosis(
    Verdict verdict,
    String reason,
    List<Effect> explanation,
    List<EffectFinding> effects,
    double unknownProbability,
    double namedProbability,
    List<AtBound> atBound,
    GapFigures gap,
    List<BudgetEntry> budget,
    List<Place> where,
    List<Undetectable> undetectable,
    Optional<NextExperiment> nextExperiment,
    Hypothesis fitted,
    Hypothesis calibration,
    List<Attempt> tried,
    Map<String, Double> signs,
    Optional<SetupError> setupError,
    List<AuditFinding> audit) {
  /** Copies the lists. */
  public Diagnosis {
    Checks.number("unknownProbability", unknownProbability);
    Checks.number("namedProbability", namedProbability);
    explanation = List.copyOf(explanation);
    effects = List.copyOf(effects);
    atBound = List.copyOf(atBound);
    budget = List.copyOf(budget);
    where = List.copyOf(where);
    undetectable = List.copyOf(undetectable);
    tried = List.copyOf(tried);
    // In their order, which Map.copyOf does not keep.
    signs = Collections.unmodifiableMap(new LinkedHashMap<>(signs));
    audit = List.copyOf(audit);
  }

  /** Returns the same with another model of what was concluded. */
  public Diagnosis with(Hypothesis model) {
    return with(verdict, reason, model, audit);
  }

  /** Returns the same with what an audit found of the data, worst first. */
  public Diagnosis with(List<AuditFinding> findings) {
    return with(verdict, reason, fitted, findings);
  }

  /** Returns the same undecided, for a reason. */
  public Diagnosis undecided(String why) {
    return with(Verdict.UNDECIDED, why, fitted, audit);
  }

  private Diagnosis with(Verdict told, String why, Hypothesis model, List<AuditFinding> findings) {
    return new Diagnosis(
        told,
        why,
        explanation,
        effects,
        unknownProbability,
        namedProbability,
        atBound,
        gap,
        budget,
        where,
        undetectable,
        nextExperiment,
        model,
        calibration,
        tried,
        signs,
        setupError,
        findings);
  }

  /** Returns by which law the set-up was taken to hear. */
  public SensorLaw.Model model() {
    return calibration.forms().stream().anyMatch(LevelForms::isLaw)
        ? SensorLaw.Model.LEVEL
        : SensorLaw.Model.THRESHOLD;
  }

  /**
   * Returns how probable it is that a verdict is the right one. None, explained and unexplained add
   * up to 1. Partly is unexplained as well, and has its probability; undecided says nothing of the
   * world, so its probability is 0.
   */
  public double probability(Verdict of) {
    return switch (of) {
      case NONE -> (1 - unknownProbability) * (1 - namedProbability);
      case EXPLAINED -> (1 - unknownProbability) * namedProbability;
      case PARTLY, UNEXPLAINED -> unknownProbability;
      case UNDECIDED -> 0;
    };
  }

  /**
   * A set of effects that was fitted.
   *
   * @param effects in the set; empty for the nominal model
   * @param heldOutNats held-out log likelihood beyond the nominal model's
   * @param behindNats by how much it is behind the likeliest set once each has paid for its effects
   *     and values and hanging together is divided out; infinity for a set that was left out
   */
  public record Attempt(List<Effect> effects, double heldOutNats, double behindNats) {
    /** Copies the list. */
    public Attempt {
      Checks.number("heldOutNats", heldOutNats);
      Checks.number("behindNats", behindNats);
      effects = List.copyOf(effects);
    }
  }
}
