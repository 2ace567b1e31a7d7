package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What an answer of a withheld check proposes is measured, diagnosed again and scored. */
class BlindNextTest {
  private static final int ASKED = 40;
  private static final ObjectMapper MAPPER = new ObjectMapper();

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path out() {
    return folder.resolve("check");
  }

  private Shell check(String... more) {
    String order =
        "blind-check --cases 1 --seed 13 --rows 300-320 --mix single:1 --effects range-offset"
            + " --sizes 3-4 --reference 0 --out";
    List<String> all = new ArrayList<>(List.of(order.split(" ")));
    all.add(out().toString());
    all.addAll(List.of(more));
    Shell shell = Shell.simbad(all.toArray(String[]::new));
    assertEquals(0, shell.status(), shell.err());
    return shell;
  }

  private String onlyCase() throws IOException {
    try (Stream<Path> cases = Files.list(out().resolve("world/cases"))) {
      return cases.findFirst().orElseThrow().getFileName().toString();
    }
  }

  /** The answer says that its effect is tied with another, and where to look; returns the rows. */
  private List<String> propose(String id) throws IOException {
    Path answer = out().resolve("answers").resolve(id);
    ObjectNode diagnosis = (ObjectNode) MAPPER.readTree(answer.resolve("diagnosis.json").toFile());
    ObjectNode next = diagnosis.putObject("next_experiment");
    next.putArray("separates").add("range-offset").add("sound-speed");
    next.put("poses", "next-experiment.csv").put("expected_log_odds", 12.5);
    MAPPER.writeValue(answer.resolve("diagnosis.json").toFile(), diagnosis);
    Path rows = out().resolve("world/rows").resolve(id).resolve("rows.csv");
    List<String> lines = new ArrayList<>(Files.readAllLines(rows).subList(0, ASKED + 1));
    for (int row = 1; row < lines.size(); row++) {
      lines.set(row, lines.get(row).replaceFirst("[^,]*", "next-1"));
    }
    Files.write(answer.resolve("next-experiment.csv"), lines);
    return lines.subList(1, lines.size());
  }

  @Test
  void proposal_isMeasuredDiagnosedAndScored() throws IOException {
    check();
    String id = onlyCase();
    List<String> asked = propose(id);
    Shell shell = check("--next");
    assertTrue(shell.out().contains("next experiments: 1 of 1 answers propose one"), shell.out());
    assertTrue(shell.out().contains("told apart rightly                 1/1 100%"), shell.out());
    List<String> lines = Files.readAllLines(out().resolve("next.csv"));
    assertEquals(2, lines.size());
    String begin = id + ",L1,single,range-offset,range-offset+sound-speed,range-offset,12.50,right";
    assertTrue(lines.get(1).startsWith(begin), lines.get(1));
    assertTrue(lines.get(1).endsWith(",right,right"), lines.get(1));
    String page = Files.readString(out().resolve("report.html"));
    assertTrue(page.contains("next/answers/" + id + "/report.html"), "on the check's page");
    checkMeasured(id, asked);
    checkResumed(id);
  }

  /** The rows are behind the readings as they were, and nothing that tells the truth is there. */
  private void checkMeasured(String id, List<String> asked) throws IOException {
    Path open = out().resolve("next/world/cases").resolve(id);
    try (Stream<Path> files = Files.list(open)) {
      assertEquals(
          List.of("readings.csv", "scene.json"),
          files.map(file -> file.getFileName().toString()).sorted().toList());
    }
    List<String> before =
        Files.readAllLines(out().resolve("world/cases").resolve(id).resolve("readings.csv"));
    List<String> after = Files.readAllLines(open.resolve("readings.csv"));
    assertEquals(before, after.subList(0, before.size()));
    List<String> added = after.subList(before.size(), after.size());
    assertEquals(ASKED, added.size());
    for (int row = 0; row < ASKED; row++) {
      assertTrue(added.get(row).startsWith(asked.get(row) + ","), added.get(row));
    }
    assertFalse(Files.exists(out().resolve("next/world/truth")));
  }

  /** A second call keeps what was measured and makes a lost answer anew. */
  private void checkResumed(String id) throws IOException {
    Path answer = out().resolve("next/answers").resolve(id);
    Path readings = out().resolve("next/world/cases").resolve(id).resolve("readings.csv");
    String scores = Files.readString(out().resolve("next.csv"));
    FileTime time = Files.getLastModifiedTime(readings);
    Files.delete(answer.resolve("predictions.csv"));
    Files.move(answer, folder.resolve("lost"));
    check("--next");
    assertTrue(Files.exists(answer.resolve("predictions.csv")));
    assertEquals(time, Files.getLastModifiedTime(readings));
    assertEquals(scores, Files.readString(out().resolve("next.csv")));
  }
}
