package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.world.Forecast;

/** Numbers of answers, held against truths that are written by hand. */
class ParticularsTest {

  private static JsonObject json(String text) throws FormatException {
    return JsonObject.parse("a.json", text.replace('\'', '"'));
  }

  private static List<Particulars.Parameter> hits(String truth, String said)
      throws FormatException {
    return ParameterHits.of(
        json("{'effects': {" + truth + "}}"),
        json("{'explanation': ['turn-bias', 'speed-scale'], 'effects': [" + said + "]}"));
  }

  private static String bias(String value, String interval) {
    return "{'name': 'turn-bias', 'parameters': {'bias_rad_s': "
        + value
        + "}, 'ci95': {'bias_rad_s': "
        + interval
        + "}}";
  }

  /** The true 0.10 before 0.08, of which the interval goes up to 0.11 and down to 0.04. */
  @Test
  void number_isOffInHalfWidthsOfItsSide() throws FormatException {
    String truth = "'turn-bias': {'form': 'always', 'rad_s': 0.10}";
    Particulars.Parameter hit = hits(truth, bias("0.08", "[0.04, 0.11]")).get(0);
    assertEquals("turn-bias", hit.effect());
    assertEquals(0.02 / 0.03, hit.off(), 1e-9);
    assertTrue(hit.isIn95() && hit.isIn90());
    Particulars.Parameter below = hits(truth, bias("0.12", "[0.098, 0.13]")).get(0);
    assertEquals(0.02 / 0.022, below.off(), 1e-9);
    assertTrue(below.isIn95());
    assertFalse(below.isIn90(), "1.645 of 1.96 deviations are left of it");
    assertFalse(hits(truth, bias("0.08", "[0.07, 0.09]")).get(0).isIn95());
    assertFalse(hits(truth, bias("0.08", "[0.08, 0.08]")).get(0).isIn95(), "no width");
    assertTrue(hits(truth, bias("0.10", "[0.10, 0.10]")).get(0).isIn95());
  }

  @Test
  void number_isInTheAnswersUnit() throws FormatException {
    String truth = "'turn-bias': {'form': 'heading', 'deg': 90}, 'capture-offset': {}";
    assertEquals(List.of(), hits(truth, bias("1", "[0, 2]")), "of another sense");
    JsonObject said =
        json(
            "{'explanation': ['capture-offset'], 'effects': [{'name': 'capture-offset',"
                + " 'parameters': {'heading_rad': 1.5}, 'ci95': {'heading_rad': [1.4, 1.6]}}]}");
    JsonObject turned = json("{'effects': {'capture-offset': {'form': 'heading', 'deg': 90}}}");
    double off = ParameterHits.of(turned, said).get(0).off();
    assertEquals((Math.PI / 2 - 1.5) / 0.1, off, 1e-9);
  }

  @Test
  void numbers_areOfNamesThatAreRightAndBounded() throws FormatException {
    String truth = "'turn-bias': {'form': 'always', 'rad_s': 0.10}";
    assertEquals(List.of(), hits("", bias("0.1", "[0, 1]")), "not at work");
    assertEquals(List.of(), hits(truth, bias("0.1", "[null, null]")), "not bounded");
    assertEquals(List.of(), hits(truth, "{'name': 'turn-bias'}"), "no number");
    assertEquals(
        List.of(),
        ParameterHits.of(
            json("{'effects': {" + truth + "}}"),
            json("{'explanation': [], 'effects': [" + bias("0.1", "[0, 1]") + "]}")),
        "not concluded");
    String message =
        Objects.toString(
            assertThrows(FormatException.class, () -> hits(truth, bias("0.1", "[0.2, 0.3]")))
                .getMessage());
    assertTrue(message.contains("bias_rad_s: [0.2, 0.3], expected two ends about 0.1"), message);
  }

  private static final String POST =
      "{'no_echo_m': 4, 'sensor': {'name': 's', 'cone_half_angle_deg': 20, 'min_range_m': 0.02,"
          + " 'max_range_m': 4, 'mount_height_m': 0.1, 'assumed_sound_speed_m_s': 343,"
          + " 'resolution_m': 0.01, 'range_noise_m': 0.01, 'miss_rate': 0, 'edge_width_m': 0.02,"
          + " 'update_period_s': 0.1}, 'obstacles': [{'name': 'post', 'x_m': 0, 'z_m': 0,"
          + " 'turn_deg': 0, 'outline_m': [[-0.1, -0.1], [-0.1, 0.1], [0.1, 0.1], [0.1, -0.1]],"
          + " 'detection': 'uniform', 'uniform_range_m': 2}]}";

  /** A forecast that says the same of each row. */
  private static String forecast(List<Double> each) {
    StringBuilder text = new StringBuilder();
    for (int q = 1; q <= Forecast.LEVELS; q++) {
      text.append(q == 1 ? "" : ",").append(String.format("q%02d", 5 * q));
    }
    for (double value : each) {
      text.append('\n').append(value).append(("," + value).repeat(Forecast.LEVELS - 1));
    }
    return text.append('\n').toString();
  }

  /**
   * Twenty rows from 0.55 m to 2.45 m to the right of the post, looking at it. Half a metre is read
   * too long beyond 1.5 m, and the true world knows that.
   */
  private static Map<String, Particulars> read(Path folder, String where) throws Exception {
    Path truth = Files.createDirectories(folder.resolve("truth/c"));
    Path answer = Files.createDirectories(folder.resolve("answers/c"));
    Path nominal = Files.createDirectories(folder.resolve("nominal/c"));
    Path cases = Files.createDirectories(folder.resolve("cases/c"));
    StringBuilder rows = new StringBuilder("run,sensor,t_s,x_m,z_m,heading_deg,range_m\n");
    List<Double> believed = new ArrayList<>();
    List<Double> real = new ArrayList<>();
    for (int i = 0; i < 20; i++) {
      double x = 0.55 + 0.1 * i;
      believed.add(x - 0.1);
      real.add(x > 1.5 ? x + 0.4 : x - 0.1);
      rows.append(String.format("r,left,%d,%.2f,0,180,%.2f%n", i, x, real.get(i)));
    }
    Files.writeString(cases.resolve("scene.json"), POST.replace('\'', '"'));
    Files.writeString(truth.resolve("sealed.csv"), rows);
    Files.writeString(truth.resolve("oracle.csv"), forecast(real));
    Files.writeString(nominal.resolve("predictions.csv"), forecast(believed));
    Files.writeString(truth.resolve("truth.json"), "{\"effects\": {}}");
    Files.writeString(
        answer.resolve("diagnosis.json"),
        ("{'explanation': [], 'effects': [], 'where': [" + where + "]}").replace('\'', '"'));
    Truth known =
        new Truth("c", List.of(), Set.of(), false, real, Optional.of(25.0), Optional.of(0.0));
    return new CaseParticulars(
            folder.resolve("truth"),
            folder.resolve("answers"),
            Optional.of(folder.resolve("nominal")),
            Optional.of(folder.resolve("cases")))
        .read(List.of(known));
  }

  private static Particulars.Place place(Path folder, String slice) throws Exception {
    Particulars said = Objects.requireNonNull(read(folder, "{'slice': " + slice + "}").get("c"));
    assertEquals(1, said.told());
    assertEquals(1, said.places().size(), slice);
    return said.places().get(0);
  }

  @Test
  void place_holdsItsShareOfWhatCanGo(@TempDir Path folder) throws Exception {
    assertEquals(new Particulars.Place(true, 0.5, 1), place(folder, "{'distance_m': [1.5, 2.5]}"));
    assertEquals(new Particulars.Place(false, 0.5, 0), place(folder, "{'distance_m': [0.5, 1.5]}"));
    Particulars.Place wide =
        place(folder, "{'distance_m': [1.0, 2.5], 'bearing_deg': [85, 95], 'obstacle': 'post'}");
    assertTrue(wide.isLarger());
    assertEquals(0.75, wide.rows(), 1e-9);
    assertEquals(1, wide.removable(), 1e-9);
    Particulars.Place late =
        place(folder, "{'t_s': [15, 21], 'off_axis_deg': [-1, 1], 'sensor': 'left', 'run': 'r'}");
    assertEquals(0.25, late.rows(), 1e-9);
    assertEquals(0.5, late.removable(), 1e-9);
  }

  /** All rows, no row, four rows, and a speed say nothing. */
  @Test
  void place_thatSealedRowsSayNothingOf_isNotHeldAgainstThem(@TempDir Path folder)
      throws Exception {
    for (String slice :
        List.of(
            "{'distance_m': [0, 3]}",
            "{'sensor': 'right'}",
            "{'distance_m': [0.5, 0.9]}",
            "{'speed_m_s': [0, 1]}")) {
      Particulars said = Objects.requireNonNull(read(folder, "{'slice': " + slice + "}").get("c"));
      assertEquals(List.of(), said.places(), slice);
    }
    String message =
        Objects.toString(
            assertThrows(FormatException.class, () -> place(folder, "{'distance_m': [0.5]}"))
                .getMessage());
    assertTrue(message.endsWith("distance_m: expected two numbers"), message);
    assertTrue(message.contains("diagnosis.json, where[0], slice"), message);
  }

  @Test
  void withoutAnAnswer_thereIsNothing(@TempDir Path folder) throws IOException, FormatException {
    Truth known =
        new Truth("c", List.of(), Set.of(), false, List.of(), Optional.empty(), Optional.empty());
    Path none = Files.createDirectories(folder.resolve("answers"));
    assertEquals(
        Map.of(),
        new CaseParticulars(folder, none, Optional.empty(), Optional.empty()).read(List.of(known)));
  }

  @Test
  void shares_areOfAllCases() {
    Truth truth =
        new Truth("c", List.of(), Set.of(), false, List.of(), Optional.empty(), Optional.empty());
    Truth other =
        new Truth("d", List.of(), Set.of(), false, List.of(), Optional.empty(), Optional.empty());
    Particulars one =
        new Particulars(
            List.of(
                new Particulars.Parameter("gain", 0.5),
                new Particulars.Parameter("gain", 0.9),
                new Particulars.Parameter("latency", 2)),
            List.of(new Particulars.Place(true, 0.2, 0.6), new Particulars.Place(false, 0.5, 0.1)),
            2);
    Particulars none = new Particulars(List.of(), List.of(), 0);
    Scores scores =
        new Scores(
            List.of(new Graded(truth, Optional.empty()), new Graded(other, Optional.empty())),
            Map.of("c", one, "d", none));
    Map<String, Proportion> shares = scores.shares();
    assertEquals(new Proportion(2, 3), shares.get("parameter intervals cover"));
    assertEquals(new Proportion(1, 3), shares.get("parameter intervals of 90 % cover"));
    assertEquals(new Proportion(1, 2), shares.get("places larger on sealed rows"));
    assertEquals(new Proportion(1, 2), shares.get("none without a place"));
    assertEquals(List.of(0.5, 0.9, 2.0), scores.offs());
    assertEquals(1, scores.density().size());
    assertEquals(3, scores.density().get(0), 1e-9);
  }
}
