package simbad.benchmarks.constants;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.gap.score.IntervalWidths;

class FitIntervalsTest {
  private static Path check(Path folder, String name, String widths) throws IOException {
    Path check = Files.createDirectories(folder.resolve(name));
    Files.writeString(check.resolve("order.json"), "{\"practice\": 7}");
    Files.writeString(
        check.resolve("check.json"),
        ("{'scores': {'all cases': {'diagnosis': {" + widths + "}}, 'some': {'diagnosis': {}}}}")
            .replace('\'', '"'));
    return check;
  }

  private static String upTo(int most) {
    return IntStream.rangeClosed(1, most)
        .mapToObj(i -> String.valueOf(i / 50.0))
        .collect(Collectors.joining(", ", "'parameter_half_widths': [", "]"));
  }

  /** Nine in ten of 0.02, 0.04 .. 2 are up to 1.8. */
  @Test
  void wider_isForNineInTen() {
    List<Double> off = IntStream.rangeClosed(1, 100).mapToObj(i -> i / 50.0).toList();
    assertEquals(1.8 * 1.96 / 1.6449, FitIntervals.wider(off), 1e-9);
  }

  @Test
  void checks_areFittedByTheirGroup_andFewValuesTeachNothing(@TempDir Path folder)
      throws IOException {
    check(folder, "a", upTo(60));
    check(folder, "b", upTo(40));
    check(folder, "few", upTo(39));
    Path out = folder.resolve("constants.json");
    FitIntervals.main(
        new String[] {
          out.toString(),
          "2026-01-02",
          "level=" + folder.resolve("a") + "," + folder.resolve("b"),
          "motion=" + folder.resolve("few")
        });
    JsonNode root = new ObjectMapper().readTree(Files.readString(out));
    IntervalWidths own = IntervalWidths.own();
    IntervalWidths fitted = IntervalWidths.of(root);
    assertEquals(own.threshold(), fitted.threshold(), 0);
    assertEquals(own.motion(), fitted.motion(), 0);
    // The 90th of 100: of the first 60 and 40 it is 1.0.
    assertEquals(own.level() * 1.96 / 1.6449, fitted.level(), 2e-3);
    JsonNode figures = root.at("/origin/narrowed_to_90_percent/level");
    assertEquals(100, figures.path("values").asInt());
    assertEquals(0.9, figures.path("held_after").asDouble(), 0.011);
    List<String> of = root.at("/origin/checks").findValuesAsText("of");
    assertEquals(List.of("level", "level", "motion"), of.subList(of.size() - 3, of.size()));
    assertEquals(Set.of("threshold"), Set.copyOf(of.subList(0, of.size() - 3)), "kept");
    assertEquals("few", folder.resolve("few").getFileName().toString());
  }

  @Test
  void whatIsNotThere_isSaid(@TempDir Path folder) throws IOException {
    check(folder, "old", "'cases': 3");
    String out = folder.resolve("c.json").toString();
    String[] arguments = {out, "2026-01-02", "level=" + folder.resolve("old")};
    String message =
        Objects.toString(
            assertThrows(IOException.class, () -> FitIntervals.main(arguments)).getMessage());
    assertTrue(message.endsWith("not there; a check of an older program"), message);
    String[] unknown = {out, "2026-01-02", "waves=" + folder};
    assertThrows(IllegalArgumentException.class, () -> FitIntervals.main(unknown));
    assertThrows(IllegalArgumentException.class, () -> FitIntervals.main(new String[] {out}));
  }
}
