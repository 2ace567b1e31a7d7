package simbad.blindworld.baseline;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.TestWorlds;
import simbad.blindworld.world.World;

/** A rule that names the largest sort of residual, and the data sets that it reads. */
class LargestResidualTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final Sensor SENSOR =
      new Sensor("s", 0.3, 0.02, 4, 0.1, 343, 0, 0.01, 0.01, 0.02, 0.1);
  private static final Scene SCENE =
      new Scene(4, SENSOR, List.of(TestWorlds.post("post", 0, 0, 2)));

  /** From 3.5 m to 0.5 m: the post is heard from 2 m on, by half of the pings. */
  private static final Recording ROWS = TestWorlds.approach(3.5, 0.5, 600);

  private static double[] nominal() {
    return new World(SCENE, Setup.nominal(SENSOR), List.of()).at(ROWS).read(99);
  }

  private static Optional<String> name(DoubleUnaryOperator change) {
    double[] readings = java.util.Arrays.stream(nominal()).map(change).toArray();
    return new LargestResidual(SCENE).name(ROWS, readings);
  }

  private static double echo(double reading, DoubleUnaryOperator change) {
    return reading < NONE ? change.applyAsDouble(reading) : reading;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5})
  void nominalReadings_haveNoName(long seed) {
    double[] readings =
        new World(SCENE, Setup.nominal(SENSOR), List.of()).at(ROWS).read(1000 + seed);
    assertEquals(Optional.empty(), new LargestResidual(SCENE).name(ROWS, readings));
  }

  @Test
  void largestSort_hasItsName() {
    Chance random = new Chance(3);
    assertEquals(Optional.of("dropout"), name(r -> random.nextInt(3) == 0 ? NONE : r));
    assertEquals(
        Optional.of("crosstalk"),
        name(r -> r == NONE && random.nextInt(3) == 0 ? random.nextDouble(0.1, 3) : r));
    assertEquals(Optional.of("range-offset"), name(r -> echo(r, x -> x + 0.3)));
    assertEquals(Optional.of("range-offset"), name(r -> echo(r, x -> x - 0.3)));
    assertEquals(Optional.of("sound-speed"), name(r -> echo(r, x -> x * 1.3)));
    assertEquals(
        Optional.of("range-noise"), name(r -> echo(r, x -> x + 0.4 * random.nextGaussian())));
  }

  /** The forecast's middle is the post's surface, 2 cm before its middle. */
  @Test
  void forecast_isTheNominalOne() {
    assertEquals(0.48, new LargestResidual(SCENE).forecast(ROWS).row(599)[9], 0.01);
    assertEquals(4, new LargestResidual(SCENE).forecast(ROWS).row(0)[9]);
  }

  private static final String SCENE_JSON =
      """
      {"no_echo_m": 4.5,
       "sensor": {"name": "SRF04", "cone_half_angle_deg": 18, "min_range_m": 0.03,
        "max_range_m": 4, "mount_height_m": 0.15, "assumed_sound_speed_m_s": 343,
        "resolution_m": 0.01, "range_noise_m": 0.004, "miss_rate": 0.02,
        "edge_width_m": 0.03, "update_period_s": 0.1},
       "obstacles": [
        {"name": "a", "x_m": 1, "z_m": -2, "turn_deg": 90,
         "outline_m": [[0, 0], [0.1, 0], [0, 0.2]], "detection": "table",
         "thresholds_m": [1, 2, 1.5]},
        {"name": "b", "x_m": 0, "z_m": 0, "turn_deg": 0,
         "outline_m": [[0, 0], [0.1, 0], [0, 0.2]], "detection": "uniform",
         "uniform_range_m": 2.5}]}
      """;

  @Test
  void scene_isRead(@TempDir Path folder) throws IOException, FormatException {
    Scene scene = DataSet.scene(Files.writeString(folder.resolve("scene.json"), SCENE_JSON));
    assertEquals(4.5, scene.noEchoM());
    assertEquals(
        new Sensor("SRF04", Math.toRadians(18), 0.03, 4, 0.15, 343, 0.01, 0.004, 0.02, 0.03, 0.1),
        scene.sensor());
    assertEquals("a", scene.obstacles().get(0).name());
    assertEquals(new Point(1, -2), scene.obstacles().get(0).place());
    assertEquals(Math.PI / 2, scene.obstacles().get(0).turnRad(), 1e-12);
    assertEquals(new Point(0, 0.2), scene.obstacles().get(0).outline().get(2));
    assertEquals(List.of(1.0, 2.0, 1.5), scene.obstacles().get(0).shadow().radiiM());
    assertEquals(List.of(2.5), scene.obstacles().get(1).shadow().radiiM());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "[[0, 0], [0.1, 0]]|[[0, 0], [0.1, 0], [0, 0.2]]",
        "[[0, 0], [0.1, 0], [1]]|[[0, 0], [0.1, 0], [0, 0.2]]",
        "[1, 2]|[1, 2, 1.5]",
        "\"no_echo_m\": -1|\"no_echo_m\": 4.5",
        "\"miss_rate\": 2|\"miss_rate\": 0.02",
      })
  void brokenScene_isRefused(String change, @TempDir Path folder) throws IOException {
    String[] words = change.split("\\|", 2);
    String broken = SCENE_JSON.replace(words[1], words[0]);
    Path file = Files.writeString(folder.resolve("scene.json"), broken);
    FormatException fault = assertThrows(FormatException.class, () -> DataSet.scene(file));
    assertTrue(String.valueOf(fault.getMessage()).contains("scene.json"), fault.toString());
  }

  @Test
  void rows_areRead() throws FormatException {
    Csv csv =
        Csv.parse(
            "f",
            "run,sensor,t_s,x_m,z_m,heading_deg,range_m\nr,s,0.5,1,2,180,\nr,t,1,3,4,0,1.25\n");
    Recording rows = DataSet.rows(csv);
    assertEquals(2, rows.size());
    assertEquals("t", rows.rows().get(1).sensor());
    assertEquals(0.5, rows.tS(0));
    assertEquals(1, rows.pose(0).xM());
    assertEquals(2, rows.pose(0).zM());
    assertEquals(Math.PI, rows.pose(0).headingRad(), 1e-12);
    assertArrayEquals(new double[] {NONE, 1.25}, DataSet.ranges(csv));
  }

  private static void set(Path folder, double addedM) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(
        folder.resolve("scene.json"),
        """
        {"no_echo_m": 4,
         "sensor": {"name": "s", "cone_half_angle_deg": 18, "min_range_m": 0.03,
          "max_range_m": 4, "mount_height_m": 0.15, "assumed_sound_speed_m_s": 343,
          "resolution_m": 0, "range_noise_m": 0.005, "miss_rate": 0, "edge_width_m": 0.01,
          "update_period_s": 0.1},
         "obstacles": [{"name": "b", "x_m": 0, "z_m": 0, "turn_deg": 0,
          "outline_m": [[-0.1, -0.1], [0.1, -0.1], [0.1, 0.1], [-0.1, 0.1]],
          "detection": "uniform", "uniform_range_m": 3}]}
        """);
    StringBuilder text = new StringBuilder("run,sensor,t_s,x_m,z_m,heading_deg,range_m\n");
    Chance random = new Chance(5);
    IntStream.range(0, 200)
        .forEach(
            i -> {
              double away = 0.5 + 0.01 * i;
              double range = away - 0.1 + addedM + 0.005 * random.nextGaussian();
              text.append("r,s,%d,%s,0,0,%s\n".formatted(i, -away, range));
            });
    Files.writeString(folder.resolve("readings.csv"), text);
  }

  /** One as believed, one 10 cm off, and one that cannot be read. */
  @Test
  void dataSets_areAnswered(@TempDir Path folder) throws IOException, FormatException {
    Path cases = folder.resolve("cases");
    Path out = folder.resolve("out");
    set(cases.resolve("a"), 0);
    set(cases.resolve("b"), 0.1);
    set(cases.resolve("c"), 0);
    Files.writeString(cases.resolve("c/scene.json"), "{}");
    Files.createDirectories(cases.resolve("d"));
    Path rows = folder.resolve("rows");
    Files.createDirectories(rows.resolve("a"));
    Files.createDirectories(rows.resolve("b"));
    Files.writeString(
        rows.resolve("a/rows.csv"), "run,sensor,t_s,x_m,z_m,heading_deg\nr,s,0,-1.1,0,0\n");
    Files.writeString(
        rows.resolve("b/sealed.csv"),
        "run,sensor,t_s,x_m,z_m,heading_deg\nr,s,0,-1.6,0,0\nr,s,1,-3.5,0,0\n");
    List<String> faults = Baseline.run(cases, rows, out);
    assertEquals(1, faults.size());
    JsonObject a = JsonObject.read(out.resolve("a/diagnosis.json"));
    assertEquals("none", a.text("verdict"));
    assertEquals("a", a.text("dataset"));
    assertEquals(List.of(), a.texts("explanation"));
    assertEquals("dropout", a.objects("effects").get(0).text("name"));
    assertEquals(0.4, a.objects("effects").get(0).number("probability"));
    assertEquals(0.1, a.number("unknown_probability"));
    JsonObject b = JsonObject.read(out.resolve("b/diagnosis.json"));
    assertEquals("explained", b.text("verdict"));
    assertEquals(List.of("range-offset"), b.texts("explanation"));
    assertEquals("range-offset", b.objects("effects").get(0).text("name"));
    assertEquals(0.6, b.objects("effects").get(0).number("probability"));
    assertEquals(0.2, b.number("unknown_probability"));
    Csv one = Csv.read(out.resolve("a/predictions.csv"));
    assertEquals(1, one.size());
    assertEquals(1, one.number(0, 9), 0.005);
    Csv two = Csv.read(out.resolve("b/predictions.csv"));
    assertEquals(1.5, two.number(0, 9), 0.005);
    assertEquals(4, two.number(1, 9));
    assertTrue(Files.notExists(out.resolve("d")));
    assertThrows(FormatException.class, () -> Baseline.run(folder.resolve("none"), rows, out));
  }
}
