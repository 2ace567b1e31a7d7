package simbad.figures.blindcheck;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.experiments.blindcheck.CheckScores;
import simbad.experiments.blindcheck.CheckSummary;
import simbad.experiments.blindcheck.ToldApart;
import simbad.sonar.format.DataFormatException;

class CheckFilesTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private List<String> lines(String name) throws IOException {
    return Files.readAllLines(folder.resolve(name));
  }

  @Test
  void tables_holdTheScorersFigures() throws IOException {
    CheckReport.write(folder, SampleScores.order(), SampleScores.scores());
    assertEquals("part,answers,score,value,low95,high95,counted", lines("scores.csv").get(0));
    assertTrue(
        lines("scores.csv")
            .contains(SampleScores.L1 + ",diagnosis,shrink claimed vs sealed,3.25,1.5,30.0,n = 9"));
    assertFalse(lines("scores.csv").toString().contains("withheld"), "of 0 cases nothing is said");
    // Three parts, three sorts of answers, two claims, ten bins.
    assertEquals(1 + 3 * 3 * 2 * 10, lines("calibration.csv").size());
    assertTrue(
        lines("kinds.csv")
            .contains(SampleScores.ALL + ",oracle,single,\"explained, named rightly\",8"));
    assertTrue(lines("standings.csv").contains(SampleScores.L1 + ",diagnosis,single,cautious,2"));
    String wronglyExplained = SampleScores.L1 + ",diagnosis,all wrongly explained,0.1,";
    assertTrue(lines("scores.csv").stream().anyMatch(line -> line.startsWith(wronglyExplained)));
    assertTrue(lines("confusion.csv").contains(SampleScores.ALL + ",diagnosis,gain,gain+wind,1"));
    assertTrue(
        lines("effects.csv").contains(SampleScores.L1 + ",diagnosis,(wind),0.5,0.1,0.9,1,2"));
    assertEquals(41, lines("cases.csv").size());
    assertEquals("c0,L1,single,gain,(no answer),false,,,,,,,,", lines("cases.csv").get(1));
  }

  @Test
  void json_holdsOrderAndScores() throws IOException {
    CheckReport.write(folder, SampleScores.order("gain"), SampleScores.scores());
    JsonNode check = new ObjectMapper().readTree(folder.resolve("check.json").toFile());
    assertEquals("blind-check/1", check.at("/format").asText());
    assertEquals(0.25, check.at("/order/reference_share").asDouble());
    assertEquals("gain", check.at("/order/withheld/0").asText());
    assertEquals("300-400", check.at("/order/options/1").asText());
    assertEquals(SampleScores.scores().document().get("scores"), check.get("scores"));
    assertEquals(40, check.get("cases").size());
  }

  @Test
  void sameScores_sameBytes() throws IOException {
    CheckReport.write(folder, SampleScores.order(), SampleScores.scores());
    String first = Files.readString(folder.resolve(CheckReport.PAGE));
    CheckReport.write(folder, SampleScores.order(), SampleScores.scores());
    assertEquals(first, Files.readString(folder.resolve(CheckReport.PAGE)));
  }

  private static final String NEXT =
      """
      case,level,kind,so,separates,outcome,said_before,said_after
      c1,L1,single,latency,latency+obstacle-offset,right,undecided,latency
      c2,L1,faint,hysteresis,hysteresis+early-timeout,wrong,undecided,none
      """;

  private List<ToldApart> next(String text) throws IOException, DataFormatException {
    return ToldApart.read(Files.writeString(folder.resolve("next.csv"), text));
  }

  @Test
  void proposalsThatWereMeasured_areOnThePage() throws IOException, DataFormatException {
    CheckReport.write(folder, SampleScores.order(), SampleScores.scores(), next(NEXT));
    String page = Files.readString(folder.resolve(CheckReport.PAGE));
    assertTrue(page.contains("Do the proposed measurements tell effects apart?"));
    assertTrue(page.contains("next/answers/c2/report.html"));
    // Wilson (1927) of 1 of 2: the middle is a half, its half width 1.96 / (1 + 1.92) * 0.605.
    assertEquals(0.0945, ToldApart.share(next(NEXT), "right").estimate().low(), 5e-4);
    assertTrue(page.contains("9&nbsp;% to 91&nbsp;%"), page);
    CheckReport.write(folder, SampleScores.order(), SampleScores.scores());
    assertFalse(Files.readString(folder.resolve(CheckReport.PAGE)).contains("proposed measure"));
  }

  @Test
  void otherOutcomes_areRefusedByLine() {
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> next(NEXT.replace(",wrong,", ",perhaps,")));
    assertEquals(
        folder.resolve("next.csv") + ":3: outcome: perhaps, expected one of [right, tied, wrong]",
        fault.getMessage());
    assertThrows(DataFormatException.class, () -> next("case\nc1\n"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "[]", "{", "{\"format\": \"blind-scores/2\", \"scores\": {}}", "7"})
  void otherFiles_areRefusedByName(String text) throws IOException {
    Path file = Files.writeString(folder.resolve("scores.json"), text);
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> CheckScores.read(file));
    assertEquals(file + ": not the scores of a check, expected blind-scores/1", fault.getMessage());
  }

  @Test
  void summary_statesTheLevelOverEveryFigure() {
    List<String> lines = CheckSummary.lines(SampleScores.scores());
    assertEquals(SampleScores.ALL, lines.get(0));
    assertTrue(lines.contains(SampleScores.L2));
    assertTrue(
        lines.stream()
            .anyMatch(line -> line.matches(" *no effect: called none +100 % +80 to 100 .*")));
  }

  @Test
  void command_repeatsTheOrder() {
    assertEquals(
        "./simbad blind-check --cases 40 --seed 3 --reference 0.25 --rows 300-400 --withhold"
            + " gain,latency --out DIR",
        SampleScores.order("gain", "latency").command());
    assertEquals(
        "./simbad blind-check --foreign their <sets> --level 'L3' --out DIR",
        SampleScores.foreign().command());
    assertEquals("L3", SampleScores.foreign().json().get("level").asText());
  }
}
