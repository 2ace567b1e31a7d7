package simbad.cli;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import simbad.definition.Effect;
import simbad.gap.audit.AuditFinding;
import simbad.gap.diagnosis.AuditJson;
import simbad.gap.diagnosis.Diagnosis;
import simbad.gap.diagnosis.EffectFinding;
import simbad.gap.diagnosis.Verdict;

/**
 * A diagnosis in one line.
 *
 * @param dataset the data set's name
 * @param diagnosis of it
 * @param placements that are off alone, a sentence each
 * @param folder where it was written
 */
record DiagnoseSummary(String dataset, Diagnosis diagnosis, List<String> placements, Path folder)
    implements DataSetSummary {
  /** Copies the list. */
  DiagnoseSummary {
    placements = List.copyOf(placements);
  }

  @Override
  public List<AuditFinding> audit() {
    return diagnosis.audit();
  }

  /** For people: verdict, explanation with probabilities or why there is none, shrinkage. */
  @Override
  public String line() {
    return first()
        + placements.stream().map(one -> "\n" + dataset + ": " + one).collect(Collectors.joining());
  }

  private String first() {
    if (diagnosis.verdict() == Verdict.UNDECIDED) {
      return String.format(
          Locale.ROOT,
          "%s: undecided; %s; gap %.2f cm (floor %.2f cm)",
          dataset,
          diagnosis.reason(),
          diagnosis.gap().beforeCm(),
          diagnosis.gap().floorCm());
    }
    String gap =
        String.format(
            Locale.ROOT,
            "gap %.2f -> %.2f cm (shrink %.0f %%, floor %.2f cm)",
            diagnosis.gap().beforeCm(),
            diagnosis.gap().afterCm(),
            100 * diagnosis.gap().shrink(),
            diagnosis.gap().floorCm());
    return dataset
        + ": "
        + diagnosis.verdict().word()
        + explanation()
        + String.format(Locale.ROOT, ", unknown %.2f; ", diagnosis.unknownProbability())
        + gap
        + (diagnosis.reason().isEmpty() ? "" : "; " + diagnosis.reason());
  }

  private String explanation() {
    return diagnosis.explanation().isEmpty()
        ? ""
        : diagnosis.explanation().stream()
            .map(this::finding)
            .map(DiagnoseSummary::words)
            .collect(Collectors.joining(" + ", ", ", ""));
  }

  private static String words(EffectFinding named) {
    String others =
        named.indistinguishableFrom().stream().map(Effect::word).collect(Collectors.joining(", "));
    return String.format(Locale.ROOT, "%s %.2f", named.effect(), named.probability())
        + (others.isEmpty() ? "" : " (or " + others + ")");
  }

  private EffectFinding finding(Effect effect) {
    return diagnosis.effects().stream()
        .filter(finding -> finding.effect() == effect)
        .findFirst()
        .orElseThrow(() -> new IllegalStateException(effect + " has no finding"));
  }

  /** For programs: one object on one line. */
  @Override
  public String json() {
    ObjectNode node = new ObjectMapper().createObjectNode();
    node.put("dataset", dataset);
    AuditJson.add(node.putArray("audit"), audit());
    node.put("verdict", diagnosis.verdict().word());
    if (!diagnosis.reason().isEmpty()) {
      node.put("reason", diagnosis.reason());
    }
    ObjectNode probabilities = node.putObject("explanation");
    diagnosis
        .explanation()
        .forEach(effect -> probabilities.put(effect.word(), finding(effect).probability()));
    node.put("unknown_probability", diagnosis.unknownProbability());
    if (!placements.isEmpty()) {
      placements.forEach(node.putArray("placements_off")::add);
    }
    node.put("before_cm", diagnosis.gap().beforeCm());
    node.put("after_cm", diagnosis.gap().afterCm());
    node.put("floor_cm", diagnosis.gap().floorCm());
    node.put("shrink", diagnosis.gap().shrink());
    node.put("folder", folder.toString());
    return node.toString();
  }
}
