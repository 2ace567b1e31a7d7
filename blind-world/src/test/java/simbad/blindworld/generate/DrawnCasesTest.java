package simbad.blindworld.generate;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.score.Truths;

/** Small orders that are made whole: each case is sealed, and shows what was asked of it. */
class DrawnCasesTest {

  private static Order order(Worlds worlds, int cases, Map<Kind, Double> mix, Order.Rows rows) {
    return new Order(
        cases,
        11,
        mix,
        0.5,
        worlds == Worlds.MOTION ? List.of("speed-scale", "turn-bias", "slope") : List.of(),
        List.of(),
        rows,
        20,
        worlds,
        Optional.of(new Order.Sizes(2, 3)),
        Set.of(Kind.UNKNOWN));
  }

  /** The truths of an order, by kind; the manifest binds them all. */
  private static List<JsonObject> made(Order order, Path folder)
      throws IOException, FormatException {
    Set<Integer> done = ConcurrentHashMap.newKeySet();
    String root = Generator.make(order, folder, order.cases(), Map.of("more", "said"), done::add);
    assertEquals(order.cases(), done.size());
    JsonObject manifest = JsonObject.read(folder.resolve("manifest.json"));
    assertEquals(root, manifest.text("root"));
    assertEquals("said", manifest.text("more"));
    assertEquals(order.worlds() != Worlds.EQUATIONS, manifest.has("worlds"));
    Truths truths = new Truths(folder.resolve("truth"), Set.of());
    assertEquals(order.cases(), truths.verify(folder.resolve("manifest.json")));
    List<JsonObject> all = new java.util.ArrayList<>();
    for (JsonObject entry : manifest.objects("cases")) {
      Path truth = folder.resolve("truth").resolve(entry.text("case")).resolve("truth.json");
      all.add(JsonObject.read(truth));
    }
    return all;
  }

  private static void assertSizes(JsonObject truth) throws FormatException {
    int effects = truth.object("effects").fields().size();
    List<Double> sizes = truth.numbers("sizes");
    assertEquals(effects, sizes.size());
    for (double size : sizes) {
      // Where it has to show a size may grow to 2^1.5 of what was drawn.
      assertTrue(size >= 2 && size <= 3 * 2.83, truth.fields().toString());
    }
    if (effects == 0) {
      assertEquals(0, truth.number("z"));
    }
  }

  @Test
  void equations_showWhatIsOutside(@TempDir Path folder) throws IOException, FormatException {
    Map<Kind, Double> mix =
        Map.of(Kind.NONE, 1.0, Kind.SINGLE, 1.0, Kind.UNKNOWN, 1.0, Kind.PAIR, 1.0);
    Set<String> kinds = new HashSet<>();
    int references = 0;
    Order order = order(Worlds.EQUATIONS, 4, mix, new Order.Rows(200, 300));
    for (JsonObject truth : made(order, folder)) {
      assertSizes(truth);
      kinds.add(truth.text("kind"));
      assertTrue(truth.number("rows") >= 150 && truth.number("rows") <= 1000);
      references += Boolean.TRUE.equals(truth.fields().get("reference")) ? 1 : 0;
      double oracle = truth.number("sealed_gap_oracle_cm");
      if (truth.text("kind").equals("unknown")) {
        assertTrue(truth.number("z") >= 5, truth.fields().toString());
        assertTrue(truth.number("sealed_gap_setup_cm") - oracle >= 0.5);
        assertTrue(truth.texts("outside_vocabulary").size() == 1);
      }
      if (truth.text("kind").equals("none")) {
        assertEquals(oracle, truth.number("sealed_gap_setup_cm"), 0.3 * oracle + 0.1);
      }
    }
    assertEquals(Set.of("none", "single", "unknown", "pair"), kinds);
    assertEquals(2, references);
  }

  @Test
  void motion_showsWhatIsOutside(@TempDir Path folder) throws IOException, FormatException {
    Map<Kind, Double> mix = Map.of(Kind.SINGLE, 1.0, Kind.UNKNOWN, 1.0);
    Order order = order(Worlds.MOTION, 2, mix, new Order.Rows(60, 80));
    for (JsonObject truth : made(order, folder)) {
      assertSizes(truth);
      assertEquals("motion", truth.text("worlds"));
      assertEquals(9, truth.numbers("sealed_nominal").size());
      if (truth.text("kind").equals("unknown")) {
        assertTrue(truth.number("z") >= 5, truth.fields().toString());
        assertEquals(List.of("slope"), truth.texts("outside_vocabulary"));
      } else {
        assertEquals(List.of(), truth.texts("outside_vocabulary"));
      }
    }
  }

  @Test
  void waves_areMade(@TempDir Path folder) throws IOException, FormatException {
    Order order = order(Worlds.WAVE, 1, Map.of(Kind.SINGLE, 1.0), new Order.Rows(100, 120));
    for (JsonObject truth : made(order, folder)) {
      assertSizes(truth);
      assertEquals(List.of(), truth.texts("outside_vocabulary"));
    }
  }

  /** A sample by lot: the first three of eight names. */
  @Test
  void firstCases_areThoseOfTheWhole(@TempDir Path folder) throws IOException, FormatException {
    Order order = order(Worlds.EQUATIONS, 8, Map.of(Kind.NONE, 1.0), new Order.Rows(200, 210));
    String root = Generator.make(order, folder.resolve("a"), 3, Map.of(), number -> {});
    assertEquals(root, Generator.make(order, folder.resolve("b"), 3, Map.of(), number -> {}));
    JsonObject manifest = JsonObject.read(folder.resolve("a/manifest.json"));
    assertEquals(
        Plan.of(order).subList(0, 3).stream().map(Plan.Assignment::id).toList(),
        manifest.objects("cases").stream()
            .map(c -> String.valueOf(c.fields().get("case")))
            .toList());
  }
}
