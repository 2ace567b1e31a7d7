package simbad.gap.joint;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import simbad.definition.Effect;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;

/**
 * What two halves say together. A half that is too short says nothing.
 *
 * @param shared causes that show in both halves or might
 * @param sensing half
 * @param motion half
 * @param isHeard whether there are readings enough to say anything
 */
record Together(List<Shared> shared, Diagnosis sensing, MotionDiagnosis motion, boolean isHeard) {

  JointDiagnosis diagnosis() {
    Set<String> names = new LinkedHashSet<>();
    shared.stream().filter(Shared::isOne).map(Shared::name).forEach(names::add);
    motion.findings().stream().map(MotionFinding::effect).forEach(names::add);
    if (sensing.verdict().namesEffects()) {
      sensing.explanation().stream()
          .filter(effect -> !isSharedOne(effect))
          .map(Effect::word)
          .forEach(names::add);
    }
    Verdict verdict = verdict(heard(), moved(), !names.isEmpty());
    return new JointDiagnosis(
        verdict,
        reason(),
        List.copyOf(names),
        1 - (1 - unknownHeard()) * (1 - unknownMoved()),
        shared,
        sensing,
        motion,
        isHeard);
  }

  /** What is heard of a cause that has its name from the motion. */
  private boolean isSharedOne(Effect effect) {
    return shared.stream().anyMatch(one -> one.isOne() && one.isHeard() && one.effect() == effect);
  }

  /** What is not sure of the readings alone is sure where the track shows the same. */
  private Verdict heard() {
    boolean confirmed =
        sensing.verdict() == Verdict.UNDECIDED
            && !sensing.explanation().isEmpty()
            && sensing.explanation().stream()
                .allMatch(
                    effect ->
                        shared.stream()
                            .anyMatch(
                                one -> one.isOne() && one.isTracked() && one.effect() == effect));
    return confirmed ? Verdict.EXPLAINED : isHeard ? sensing.verdict() : Verdict.NONE;
  }

  private Verdict moved() {
    return motion.isSilent() ? Verdict.NONE : motion.verdict();
  }

  private double unknownHeard() {
    return isHeard ? sensing.unknownProbability() : 0;
  }

  private double unknownMoved() {
    return motion.isSilent() ? 0 : motion.unknownProbability();
  }

  private Verdict verdict(Verdict heard, Verdict moved, boolean named) {
    List<Verdict> both = List.of(heard, moved);
    if (!isHeard && motion.isSilent()) {
      return Verdict.UNDECIDED;
    }
    if (both.contains(Verdict.PARTLY) || both.contains(Verdict.UNEXPLAINED)) {
      return named ? Verdict.PARTLY : Verdict.UNEXPLAINED;
    }
    if (both.contains(Verdict.UNDECIDED)) {
      return Verdict.UNDECIDED;
    }
    return named ? Verdict.EXPLAINED : Verdict.NONE;
  }

  private String reason() {
    List<String> said = new ArrayList<>();
    shared.stream().map(Shared::words).forEach(said::add);
    said.add("motion: " + motion.headline());
    String readings = sensing.verdict().word() + because(sensing.reason());
    said.add("readings: " + readings);
    return String.join("; ", said);
  }

  private static String because(String reason) {
    return reason.isEmpty() ? "" : ", " + reason;
  }
}
