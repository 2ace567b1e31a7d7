package simbad.experiments.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A diagnosis as a header, compiled and run, beside the diagnosed model itself. */
class DiagnosisHeaderTest {
  private static final List<String> SENSORS = List.of("front");
  private static final double NO_ECHO_M = 6;

  @TempDir private Path folder = Path.of("");

  private static SensingSetup setup() {
    ObstacleType angle = Catalogue.find("angle").orElseThrow();
    return new SensingSetup(
        Catalogue.srf04().withScatter(0, 0, 1e-6).withResolution(0),
        new Scene(
            List.of(
                new Obstacle(
                    "angle",
                    Placement.IDENTITY,
                    angle.outline(),
                    new TableDetection(angle.thresholds().table())))),
        NO_ECHO_M);
  }

  /** Effects as "effect/form value value", separated by commas. */
  private static FittedModel model(String effects) {
    SensingSetup setup = setup();
    List<FittedForm> forms = new ArrayList<>();
    for (String effect : effects.split(",", -1)) {
      String[] words = effect.strip().split("[/ ]", -1);
      Form form =
          Forms.find(Definitions.find(words[0]).orElseThrow(), words[1], setup, SENSORS)
              .orElseThrow(() -> new AssertionError(effect));
      forms.add(new FittedForm(form, Arrays.stream(words).skip(2).map(Double::valueOf).toList()));
    }
    return new FittedModel(setup, SENSORS, List.of(), forms);
  }

  /** What the diagnosed model expects of each pose, after the poses before it; -1 for no echo. */
  private static double[] expected(FittedModel fitted, List<int[]> poses) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int[] pose : poses) {
      double heading = Math.toRadians(pose[2] / 100.0);
      rows.add(
          new ReadingRow(
              "run",
              "front",
              rows.size() * 0.05,
              Pose.of(pose[0] / 1000.0, pose[1] / 1000.0, heading),
              NoEcho.NO_ECHO));
    }
    ChangedModel model = fitted.diagnosed();
    List<ReadingDistribution> forecast = model.forecast(model.geometry(new PingLog(rows)));
    return forecast.stream()
        .mapToDouble(one -> one.noEchoProbability() > 0.5 ? -1 : one.quantileM(0.5, NO_ECHO_M))
        .toArray();
  }

  private List<String> readInC(FittedModel model, String compiler, List<int[]> poses)
      throws Exception {
    SonarHeader header = new SonarHeader(new FoldedDiagnosis(model, ""), "sonar");
    Files.writeString(folder.resolve("sonar.h"), header.text("test"));
    Files.writeString(folder.resolve("main.c"), HeaderPoses.READ_NEXT_OF_ALL);
    String trap = compiler.equals("clang") ? "-fsanitize-trap=undefined" : "-fno-sanitize-recover";
    Compilers.run(
        folder,
        "",
        (compiler
                + " -std=c99 -O2 -Wall -Wextra -Wconversion -Werror -pedantic -fsanitize=undefined "
                + trap
                + " main.c -o main -lm")
            .split(" ", -1));
    String input =
        poses.stream()
            .map(p -> p[0] + " " + p[1] + " " + p[2])
            .collect(Collectors.joining("\n", "", "\n"));
    return Compilers.run(folder, input, "./main").lines().toList();
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = ';',
      value = {
        "gcc; gain/factor 0.85, beam-misalignment/all 4, range-offset/constant 0.03",
        "clang; hysteresis/both 0.2, stale-reading/count 2, sound-speed/scale 350",
        "gcc; obstacle-offset/all 0.05 -0.03, obstacle-turn/all 12, near-clamp/clamp 0.3",
        "gcc; hysteresis/metres 0.2, no-echo-code/far 6.5 1 0, beam-width/cone 4",
        "gcc; near-clamp/limit 0.3, range-offset/constant -0.02",
        "clang; dead-zone/sharp 0.4, early-timeout/sharp 1.5, range-noise/constant 0.02"
      })
  void readsWhatTheDiagnosedModelExpects(String compiler, String effects) throws Exception {
    Compilers.need(compiler);
    FittedModel model = model(effects);
    List<int[]> poses = HeaderPoses.all(2.9, 3);
    List<String> lines = readInC(model, compiler, poses);
    IntegerDiagnosis whole =
        new SonarHeader(new FoldedDiagnosis(model, ""), "sonar").diagnosisInIntegers();
    double[] expected = expected(model, poses);
    int echoes = 0;
    int other = 0;
    for (int i = 0; i < lines.size(); i++) {
      String[] read = lines.get(i).split(" ", -1);
      int[] pose = poses.get(i);
      assertEquals(
          whole.readNextMm(pose[0], pose[1], pose[2]),
          Integer.parseInt(read[0]),
          Arrays.toString(pose));
      double metres = Double.parseDouble(read[1]);
      boolean alike = metres < 0 ? expected[i] < 0 : Math.abs(metres - expected[i]) < 1e-4;
      other += alike ? 0 : 1;
      echoes += expected[i] >= 0 ? 1 : 0;
    }
    assertTrue(echoes > 500, echoes + " echoes");
    // Those at which an edge is nearer than floats can tell.
    assertTrue(other <= poses.size() / 10_000, other + " of " + poses.size() + " read otherwise");
  }

  /** Steps: the float's lie at the model's but for rounding at their ends. */
  @ParameterizedTest
  @CsvSource({"start", "centre", "nearest"})
  void steps_areThoseOfTheModel(String form) throws Exception {
    Compilers.need("gcc");
    FittedModel model = model("coarse-resolution/" + form + " 0.05");
    List<int[]> poses = HeaderPoses.all(2.9, 3).subList(15_000, 24_000);
    List<String> lines = readInC(model, "gcc", poses);
    double[] expected = expected(model, poses);
    int other = 0;
    for (int i = 0; i < lines.size(); i++) {
      String[] read = lines.get(i).split(" ", -1);
      double mm = Integer.parseInt(read[0]);
      double metres = Double.parseDouble(read[1]);
      boolean heard = expected[i] >= 0;
      other += heard == metres >= 0 && (!heard || Math.abs(metres - expected[i]) < 1e-3) ? 0 : 1;
      other += heard == mm >= 0 && (!heard || Math.abs(mm / 1000 - expected[i]) < 2e-3) ? 0 : 1;
    }
    // A whole millimetre is rounded before it is cut into steps.
    assertTrue(other <= poses.size() / 100, other + " of " + poses.size());
  }

  @Test
  void header_saysWhatIsInIt() {
    String text =
        new SonarHeader(
                new FoldedDiagnosis(model("gain/factor 0.9, range-noise/constant 0.02"), ""), "s")
            .text("test");
    assertTrue(
        text.contains(
            "included: gain/factor. Left out, since they only scatter: range-noise/constant"));
  }

  @ParameterizedTest
  @CsvSource({
    "multipath/added 0.3 0.2 0.05",
    "latency/time 0.2",
    "stale-reading/time 0.4",
    "odometry-scale/path 1.1"
  })
  void effectWithoutForm_isRefusedByName(String effect) {
    String name = effect.replaceFirst(" .*", "");
    FittedModel model = model(effect);
    IllegalArgumentException thrown =
        assertThrows(IllegalArgumentException.class, () -> new FoldedDiagnosis(model, ""));
    assertTrue(String.valueOf(thrown.getMessage()).contains("effect " + name), thrown.getMessage());
  }

  @Test
  void obstacle_mustBeInTheScene() {
    FittedModel model = new FittedModel(setup(), SENSORS, List.of(), List.of());
    assertThrows(IllegalArgumentException.class, () -> new FoldedDiagnosis(model, "door"));
    assertEquals("angle", new FoldedDiagnosis(model, "angle").type().name());
  }
}
