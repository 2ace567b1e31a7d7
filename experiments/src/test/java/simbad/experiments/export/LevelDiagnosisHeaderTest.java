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
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.catalogue.SetupForms;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A diagnosis under the level law as a header, compiled and run, beside the diagnosed model. */
class LevelDiagnosisHeaderTest {
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
            NO_ECHO_M)
        .under(SensorLaw.Model.LEVEL);
  }

  private static FittedForm law(SensingSetup setup, double squintDeg, double rangeScale) {
    Form form = LevelForms.law(setup);
    List<Double> values = new ArrayList<>(Arrays.stream(form.neutral()).boxed().toList());
    for (int i = 0; i < values.size(); i++) {
      String name = form.parameters().get(i).name();
      if (name.equals("squint_deg")) {
        values.set(i, squintDeg);
      } else if (name.equals("range_scale")) {
        values.set(i, rangeScale);
      } else if (name.equals("miss_rate")) {
        values.set(i, 0.0);
      }
    }
    return new FittedForm(form, values);
  }

  /** Strengths that rise and fall round the obstacle, and echoes from up to 4 cm behind. */
  private static List<FittedForm> known() {
    Form strength = LevelForms.strength("angle");
    Form path = LevelForms.path("angle");
    double usualDb = setup().sensor().levelLaw().strengthDb(1.8);
    List<Double> decibels = new ArrayList<>();
    List<Double> metres = new ArrayList<>();
    for (int i = 0; i < strength.parameters().size(); i++) {
      double bearing = i * 2 * Math.PI / LevelForms.BEARINGS;
      decibels.add(i < LevelForms.BEARINGS ? usualDb + 6 * Math.cos(3 * bearing) : 0.0);
    }
    for (int i = 0; i < path.parameters().size(); i++) {
      double bearing = i * 2 * Math.PI / LevelForms.BEARINGS;
      metres.add(i < LevelForms.BEARINGS ? 0.02 + 0.02 * Math.sin(2 * bearing) : 0.0);
    }
    Form tails = SetupForms.find("tails", setup(), SENSORS).orElseThrow();
    return List.of(
        new FittedForm(strength, decibels),
        new FittedForm(path, metres),
        new FittedForm(tails, List.of(0.03, 0.02)));
  }

  /** Effects as "effect/form value value", separated by commas. */
  private static FittedModel model(boolean calibrated, String effects) {
    SensingSetup setup = setup();
    List<FittedForm> calibration = new ArrayList<>();
    calibration.add(calibrated ? law(setup, 2, 0.99) : law(setup, 0, 1));
    if (calibrated) {
      calibration.addAll(known());
    }
    List<FittedForm> forms = new ArrayList<>();
    for (String effect : effects.isEmpty() ? new String[0] : effects.split(",", -1)) {
      String[] words = effect.strip().split("[/ ]", -1);
      Form form =
          Forms.find(Definitions.find(words[0]).orElseThrow(), words[1], setup, SENSORS)
              .orElseThrow(() -> new AssertionError(effect));
      forms.add(new FittedForm(form, Arrays.stream(words).skip(2).map(Double::valueOf).toList()));
    }
    return new FittedModel(setup, SENSORS, calibration, forms);
  }

  private static List<ReadingRow> rows(List<int[]> poses) {
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
    return rows;
  }

  private List<String> readInC(LevelHeader header, String compiler, List<int[]> poses)
      throws Exception {
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
        "gcc; true; gain/level -3, range-offset/constant 0.03",
        "clang; true; absorption/level 1.5, beam-misalignment/all 4, stale-reading/count 2",
        "gcc; true; beam-width/aperture 1.2, sound-speed/scale 350, near-clamp/clamp 0.3",
        "gcc; true; near-clamp/limit 0.3",
        "clang; false; obstacle-offset/all 0.05 -0.03, obstacle-turn/all 12, gain/level 4",
        "gcc; true; dead-zone/sharp 0.4, early-timeout/sharp 1.5, no-echo-code/far 6.5 1 0"
      })
  void readsWhatTheDiagnosedModelExpects(String compiler, boolean calibrated, String effects)
      throws Exception {
    Compilers.need(compiler);
    FittedModel model = model(calibrated, effects);
    LevelHeader header = new LevelHeader(new FoldedDiagnosis(model, ""), "sonar");
    List<int[]> poses = HeaderPoses.all(2.9, 3);
    List<String> lines = readInC(header, compiler, poses);
    IntegerDiagnosis whole = header.diagnosisInIntegers();
    ChangedModel diagnosed = model.diagnosed();
    Geometry geometry = diagnosed.geometry(new PingLog(rows(poses)));
    List<ReadingDistribution> forecast = diagnosed.forecast(geometry);
    int echoes = 0;
    int other = 0;
    int wholeOther = 0;
    for (int i = 0; i < lines.size(); i++) {
      String[] read = lines.get(i).split(" ", -1);
      int[] pose = poses.get(i);
      int mm = Integer.parseInt(read[0]);
      assertEquals(whole.readNextMm(pose[0], pose[1], pose[2]), mm, Arrays.toString(pose));
      double expected = median(forecast.get(i));
      double metres = Double.parseDouble(read[1]);
      boolean alike = metres < 0 ? expected < 0 : Math.abs(metres - expected) < 1e-4;
      other += alike || isNearEdge(geometry, model.changes(), i, 0.1) ? 0 : 1;
      boolean wholeAlike = mm < 0 ? expected < 0 : Math.abs(mm / 1000.0 - expected) < 4e-3;
      wholeOther += wholeAlike || isNearEdge(geometry, model.changes(), i, 1.5) ? 0 : 1;
      echoes += expected >= 0 ? 1 : 0;
    }
    assertTrue(echoes > 500, echoes + " echoes");
    // Half-way between two corners, where either may be the nearest, and what is repeated of it.
    assertTrue(other <= poses.size() / 5000, other + " of " + poses.size() + " read otherwise");
    assertTrue(wholeOther <= poses.size() / 1000, wholeOther + " whole ones");
  }

  /**
   * A least range lies anywhere in its last step: half of that step is heard more often than not.
   * Left out is where that and the strength are both unsure, which a header has no figure for.
   */
  @Test
  void aroundTheLeastRange_itReadsWhatTheDiagnosedModelExpects() throws Exception {
    Compilers.need("gcc");
    FittedModel model = model(true, "");
    LevelHeader header = new LevelHeader(new FoldedDiagnosis(model, ""), "sonar");
    List<int[]> poses = HeaderPoses.all(0.07, 5);
    List<String> lines = readInC(header, "gcc", poses);
    Geometry geometry = model.diagnosed().geometry(new PingLog(rows(poses)));
    List<ReadingDistribution> forecast = model.diagnosed().forecast(geometry);
    double least = setup().sensor().minRangeM();
    int within = 0;
    int other = 0;
    for (int i = 0; i < lines.size(); i++) {
      double metres = Double.parseDouble(lines.get(i).split(" ", -1)[1]);
      double expected = median(forecast.get(i));
      boolean alike = metres < 0 ? expected < 0 : Math.abs(metres - expected) < 1e-4;
      double nearer = least - geometry.nearestM(i);
      boolean isSure =
          Math.abs(geometry.excessDb(i)) > geometry.excessDeviationDb(i)
              && Math.abs(nearer - 0.0025) > 0.0005;
      if (nearer > 0 && isSure) {
        other += alike ? 0 : 1;
        within += expected >= 0 ? 1 : 0;
      }
    }
    assertTrue(within > 100, within + " echoes nearer than the least range");
    assertTrue(other <= poses.size() / 5000, other + " of " + poses.size() + " read otherwise");
  }

  /** The middle of what is expected; -1 for no echo. */
  private static double median(ReadingDistribution one) {
    return one.noEchoProbability() > 0.5 ? -1 : one.quantileM(0.5, NO_ECHO_M);
  }

  private static boolean isNearEdge(
      Geometry geometry, List<Change> changes, int ping, double nearlyDb) {
    return Math.abs(geometry.excessDb(ping) + geometry.addedDb(changes, ping)) < nearlyDb;
  }

  @ParameterizedTest
  @CsvSource({"hysteresis/both 0.2", "multipath/added 0.3 0.2 0.05", "latency/time 0.2"})
  void effectWithoutForm_isRefusedByName(String effect) {
    FittedModel model = model(true, effect);
    String message =
        String.valueOf(
            assertThrows(IllegalArgumentException.class, () -> new FoldedDiagnosis(model, ""))
                .getMessage());
    assertTrue(message.contains("effect " + effect.replaceFirst(" .*", "")), message);
    assertTrue(
        message.endsWith("that cannot be written in C where the sensor hears by the level law"));
  }

  /** Of every calibration on a reference; where echoes come from near by as well. */
  @Test
  void header_saysWhatIsLeftOut() {
    FittedModel model = model(true, "");
    List<FittedForm> calibration = new ArrayList<>(model.calibration());
    Form near = LevelForms.nearField(model.setup(), "angle");
    calibration.add(new FittedForm(near, List.of(1.0)));
    calibration.add(new FittedForm(LevelForms.nearRange(), List.of(-0.02, -0.01, 0.0, 0.0)));
    FittedModel whole = new FittedModel(model.setup(), SENSORS, calibration, List.of());
    String text = new LevelHeader(new FoldedDiagnosis(whole, ""), "s").text("test");
    assertTrue(text.contains("since they only scatter: setup/tails."), text);
    assertTrue(text.contains("some centimetres: setup/near-field:angle, setup/near-range."), text);
  }

  @Test
  void header_saysWhatIsInIt() {
    FoldedDiagnosis folded = new FoldedDiagnosis(model(true, "gain/level -3"), "");
    assertTrue(folded.isLevel());
    String text = new LevelHeader(folded, "s").text("test");
    assertTrue(
        text.contains("included: setup/level, setup/strength:angle, setup/path:angle, gain/level."),
        text);
    assertTrue(text.contains("s_read_next(s_memory *memory, s_pose at)"));
  }
}
