package simbad.gap.diagnosis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.definition.Effect;
import simbad.motion.effect.MotionForms;
import simbad.sonar.effect.Definitions;

class DiagnosisJsonTest {
  private static final Path SCHEMA = Path.of("..", "docs", "schema", "diagnosis.schema.json");

  private static ObjectNode sample() {
    return DiagnosisJson.tree(Samples.diagnosis(), Samples.DATA, Samples.PROVENANCE);
  }

  private static JsonSchema schema() throws IOException {
    return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012)
        .getSchema(Files.readString(SCHEMA));
  }

  @Test
  void sample_fitsTheSchema() throws IOException {
    assertEquals(Set.of(), schema().validate(sample()));
  }

  /** Unknown u and named p give u, (1 - u) p and (1 - u)(1 - p). */
  @Test
  void verdictsProbabilities_addUp() {
    Diagnosis sample = Samples.diagnosis();
    double unknown = sample.unknownProbability();
    double named = sample.namedProbability();
    assertTrue(unknown > 0 && unknown < 1 && named > 0 && named < 1, "a sample that tells");
    assertEquals(unknown, sample.probability(Verdict.UNEXPLAINED));
    assertEquals((1 - unknown) * named, sample.probability(Verdict.EXPLAINED), 1e-12);
    assertEquals((1 - unknown) * (1 - named), sample.probability(Verdict.NONE), 1e-12);
    assertEquals(0, sample.probability(Verdict.UNDECIDED), "no state of the world");
    assertFalse(sample().get("verdict_probability").has("undecided"));
    for (Verdict verdict : List.of(Verdict.NONE, Verdict.EXPLAINED, Verdict.UNEXPLAINED)) {
      assertEquals(
          sample.probability(verdict),
          sample().get("verdict_probability").get(verdict.word()).asDouble(),
          1e-9);
    }
  }

  @Test
  void aRemedy_isOfWhatIsNamed() {
    for (Verdict verdict : Verdict.values()) {
      ObjectNode tree =
          DiagnosisJson.tree(Samples.diagnosis(verdict), Samples.DATA, Samples.PROVENANCE);
      assertEquals(verdict.namesEffects(), tree.at("/effects/0").has("remedy"), verdict.word());
      assertFalse(tree.at("/effects/1").has("remedy"));
    }
  }

  @Test
  void text_isTheTree() throws IOException {
    String text = DiagnosisJson.text(Samples.diagnosis(), Samples.DATA, Samples.PROVENANCE);
    // Through text, because 1 and 1.0 are different nodes of one number.
    assertEquals(
        new ObjectMapper().readTree(sample().toString()), new ObjectMapper().readTree(text));
    assertTrue(text.endsWith("}\n"), text);
  }

  @Test
  void schema_namesTheWholeVocabulary() throws IOException {
    Set<String> words = new TreeSet<>();
    schema().getSchemaNode().at("/$defs/effect/enum").forEach(word -> words.add(word.asText()));
    Set<String> vocabulary = new TreeSet<>();
    Definitions.effects().stream().map(Effect::word).forEach(vocabulary::add);
    vocabulary.addAll(MotionForms.vocabulary());
    assertEquals(vocabulary, words);
  }

  /** The schema refuses what is none: otherwise fitting it would say nothing. */
  static Stream<Arguments> spoilt() {
    return Map.<String, Consumer<ObjectNode>>of(
            "verdict", root -> root.put("verdict", "maybe"),
            "format", root -> root.put("format", "sonar-diagnosis/3"),
            "unknown", root -> root.put("unknown_probability", 1.01),
            "gap", root -> root.withObject("gap").remove("floor_cm"),
            "effects", root -> root.withArray("effects").remove(3),
            "name", root -> root.withArray("explanation").add("ghosts"),
            "slice", root -> root.withObject("/where/0/slice").put("colour", "red"),
            "bound", root -> root.withObject("/at_bound/0").remove("allowed"),
            "interval", root -> root.withArray("/gap/shrink_ci95").add(1),
            "hash", root -> root.withObject("/provenance/sha256").put("scene.json", "?"))
        .entrySet()
        .stream()
        .map(entry -> Arguments.of(entry.getKey(), entry.getValue()));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("spoilt")
  void spoilt_doesNotFit(String what, Consumer<ObjectNode> spoil) throws IOException {
    ObjectNode root = sample();
    spoil.accept(root);
    assertFalse(schema().validate(root).isEmpty(), what);
  }

  @Test
  void figures_standWhereTheFormatSays() {
    JsonNode root = sample();
    assertEquals("sonar-diagnosis/2", root.at("/format").asText());
    assertEquals("unexplained", root.at("/verdict").asText());
    assertEquals("offset_m stands at the end", root.at("/reason").asText());
    assertEquals("range-offset", root.at("/at_bound/0/effect").asText());
    assertEquals("offset_m", root.at("/at_bound/0/parameter").asText());
    assertEquals(1, root.at("/at_bound/0/value").asDouble());
    assertEquals(-1, root.at("/at_bound/0/allowed/0").asDouble());
    assertEquals("range-offset", root.at("/explanation/0").asText());
    assertEquals(0.333333, root.at("/effects/0/parameters/offset_m").asDouble());
    assertEquals(0.04, root.at("/effects/0/ci95/offset_m/0").asDouble());
    assertTrue(root.at("/effects/0/ci95/offset_m/1").isNull(), "not bounded");
    assertTrue(root.at("/gap/shrink_ci95/0").isNull(), "not bounded");
    assertEquals(20, root.at("/where/0/slice/bearing_deg/1").asDouble());
    assertEquals("a", root.at("/where/0/slice/run").asText());
    assertEquals("missed echo", root.at("/where/0/kind").asText());
    assertTrue(root.at("/undetectable/0/least_size").isNull());
    assertEquals(0.25, root.at("/undetectable/1/least_size").asDouble());
    assertEquals("next-experiment.csv", root.at("/next_experiment/poses").asText());
    assertEquals(0.03, root.at("/calibration/tails/deviation_m").asDouble());
    assertEquals(123.456, root.at("/tried/0/held_out_nats").asDouble());
    assertEquals(7, root.at("/provenance/seed").asInt());
    assertEquals(2, root.at("/provenance/rows/readings").asInt());
  }
}
