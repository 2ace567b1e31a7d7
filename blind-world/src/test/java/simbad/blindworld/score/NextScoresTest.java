package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.score.Parted.Outcome;

/** When effects that were tied count as told apart. */
class NextScoresTest {
  private static final Proposal GAIN_OR_ABSORPTION =
      new Proposal(List.of("absorption", "gain"), 12.5);

  private static Truth truth(String id, String... effects) {
    return new Truth(
        id, List.of(effects), Set.of(), false, List.of(), Optional.empty(), Optional.empty());
  }

  private static Answer answer(Verdict verdict, List<String> names, Map<String, List<String>> tie) {
    List<Answer.Named> effects =
        names.stream()
            .map(name -> new Answer.Named(name, 0.9, tie.getOrDefault(name, List.of())))
            .toList();
    return new Answer(
        verdict, names, effects, 0, Optional.empty(), Optional.empty(), Optional.empty());
  }

  private static Answer explained(String... names) {
    return answer(Verdict.EXPLAINED, List.of(names), Map.of());
  }

  private static Answer tied(String name, String... ties) {
    return answer(Verdict.EXPLAINED, List.of(name), Map.of(name, List.of(ties)));
  }

  private static Parted parted(Truth truth, Answer after) {
    return new Parted(
        truth, GAIN_OR_ABSORPTION, tied("gain", "absorption"), Optional.ofNullable(after));
  }

  private static Outcome outcome(Truth truth, Answer after) {
    return parted(truth, after).outcome();
  }

  @Test
  void whatIsAtWork_hasToBeNamedWithoutTheOther() {
    Truth gain = truth("c", "gain");
    assertEquals(Outcome.RIGHT, outcome(gain, explained("gain")));
    assertEquals(Outcome.RIGHT, outcome(gain, explained("gain", "latency")));
    assertEquals(Outcome.RIGHT, outcome(gain, tied("gain", "early-timeout")));
    assertEquals(Outcome.WRONG, outcome(gain, explained("absorption")));
    assertEquals(Outcome.WRONG, outcome(gain, explained("gain", "absorption")));
    assertEquals(Outcome.WRONG, outcome(gain, answer(Verdict.NONE, List.of(), Map.of())));
    assertEquals(Outcome.WRONG, outcome(gain, tied("absorption", "early-timeout")));
    assertEquals(Outcome.WRONG, outcome(gain, answer(Verdict.UNEXPLAINED, List.of(), Map.of())));
  }

  @Test
  void whatIsStillTied_isNeitherRightNorWrong() {
    Truth gain = truth("c", "gain");
    assertEquals(Outcome.TIED, outcome(gain, tied("gain", "absorption")));
    assertEquals(Outcome.TIED, outcome(gain, tied("absorption", "gain")));
    assertEquals(Outcome.TIED, outcome(gain, tied("early-timeout", "absorption", "gain")));
    assertEquals(Outcome.TIED, outcome(gain, answer(Verdict.UNDECIDED, List.of(), Map.of())));
  }

  @Test
  void whereNeitherIsAtWork_neitherMayBeNamed() {
    Truth latency = truth("c", "latency");
    assertEquals(List.of(), parted(latency, explained("latency")).atWork());
    assertEquals(Outcome.RIGHT, outcome(latency, explained("latency")));
    assertEquals(Outcome.WRONG, outcome(latency, explained("gain")));
    assertEquals(Outcome.WRONG, outcome(latency, tied("latency", "gain")));
    assertEquals(Outcome.TIED, outcome(latency, tied("gain", "absorption")));
  }

  /** Beside "unexplained" stands what fits best, which is no conclusion. */
  @Test
  void unexplained_namesNothing() {
    Answer unexplained = answer(Verdict.UNEXPLAINED, List.of("gain"), Map.of());
    assertEquals(Outcome.WRONG, outcome(truth("c", "gain"), unexplained));
    assertEquals(Outcome.RIGHT, outcome(truth("c", "latency"), unexplained));
    Answer partly = answer(Verdict.PARTLY, List.of("gain"), Map.of());
    assertEquals(Outcome.RIGHT, outcome(truth("c", "gain"), partly));
    assertEquals(Outcome.WRONG, outcome(truth("c", "latency"), partly));
  }

  @Test
  void whereBothAreAtWork_bothAreNamed() {
    Truth both = truth("c", "gain", "absorption");
    assertEquals(Outcome.RIGHT, outcome(both, explained("gain", "absorption")));
    assertEquals(Outcome.WRONG, outcome(both, explained("gain")));
  }

  @Test
  void table_hasALineForEachCaseAndShares() {
    Map<String, Proposal> proposals = new HashMap<>();
    Map<String, Answer> before = new HashMap<>();
    for (String id : List.of("a", "b", "c")) {
      proposals.put(id, GAIN_OR_ABSORPTION);
      before.put(id, tied("absorption", "gain"));
    }
    proposals.put("c", new Proposal(List.of("gain", "latency"), Double.POSITIVE_INFINITY));
    before.put("d", explained("gain"));
    NextScores scores =
        new NextScores(
            List.of(truth("a", "gain"), truth("b"), truth("c", "gain"), truth("d", "gain")),
            false,
            proposals,
            before,
            Map.of("a", explained("gain"), "b", explained("gain")));
    assertEquals(
        """
        case,level,kind,so,separates,at_work,expected_log_odds,outcome,said_before,said_after,standing_before,standing_after
        a,L1,single,gain,absorption+gain,gain,12.50,right,absorption,gain,right,right
        b,L1,none,none,absorption+gain,,12.50,wrong,absorption,gain,wrong,wrong
        c,L1,single,gain,gain+latency,gain,,wrong,absorption,(no answer),right,wrong
        """,
        scores.csv());
    String text = scores.text();
    assertTrue(text.startsWith("next experiments: 3 of 4 answers propose one\n"), text);
    assertTrue(text.contains("  told apart rightly                 1/3 33% [6-79]\n"), text);
    assertTrue(text.contains("    where one of them is at work     1/2 50% [9-91]\n"), text);
    assertTrue(text.contains("  right before                       2/3"), text);
    assertTrue(text.contains("  right after                        1/3"), text);
  }

  @Test
  void withoutProposals_thereAreNoShares() {
    String text =
        new NextScores(List.of(truth("a")), true, Map.of(), Map.of("a", explained()), Map.of())
            .text();
    assertTrue(text.startsWith("next experiments: 0 of 1 answers propose one\n"), text);
    assertTrue(text.contains("told apart rightly                 -\n"), text);
  }

  private static Map<String, Proposal> read(Path folder, String json)
      throws IOException, FormatException {
    Path one = Files.createDirectories(folder.resolve("a"));
    Files.writeString(one.resolve("diagnosis.json"), json);
    return Proposal.read(folder, List.of(truth("a"), truth("unanswered")));
  }

  @Test
  void proposals_areRead(@TempDir Path folder) throws IOException, FormatException {
    assertEquals(Map.of(), read(folder, "{\"verdict\": \"none\"}"));
    String next = "{\"next_experiment\": {\"separates\": [\"absorption\", \"gain\"%s}}";
    assertEquals(
        Map.of("a", GAIN_OR_ABSORPTION),
        read(folder, next.formatted("], \"expected_log_odds\": 12.5")));
    assertEquals(
        Map.of("a", new Proposal(List.of("absorption", "gain"), Double.POSITIVE_INFINITY)),
        read(folder, next.formatted("], \"expected_log_odds\": null")));
    FormatException fault =
        assertThrows(
            FormatException.class,
            () -> read(folder, "{\"next_experiment\": {\"separates\": [\"gain\"]}}"));
    assertTrue(
        String.valueOf(fault.getMessage())
            .endsWith("next_experiment, separates: expected two effects or more"));
    assertThrows(IllegalArgumentException.class, () -> new Proposal(List.of("a", "b"), Double.NaN));
  }
}
