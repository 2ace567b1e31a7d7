package simbad.studio;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.experiments.control.EdgeFollower;
import simbad.experiments.control.Tuning;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.RobotKind;
import simbad.experiments.run.SensorKind;
import simbad.experiments.run.Trace;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.obstacles.Catalogue;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.FittedForm;
import simbad.sonar.effect.Form;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.frame.Point;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/** Worlds as the page asks for them. */
class WorldsTest {
  private static final double SPEED = 0.5;

  /** Half as fast as it is told, which is exact in binary. */
  private static final RobotKind LAME =
      new RobotKind(
          "lame",
          MotionChain.EXACT.with(
              new MotionChange() {
                @Override
                public double speed(double speedMPerS, double turnRadPerS) {
                  return speedMPerS / 2;
                }
              }));

  private final Worlds worlds =
      new Worlds(
          new Choices(
              List.of(
                  SensorKind.SHADOW,
                  SensorKind.ORIGINAL,
                  SensorKind.LEVEL,
                  SensorKind.RAY,
                  SensorKind.OVERLAP,
                  fittedByLevel()),
              List.of(LAME)));

  /** The believed set-up, calibrated to hear by the level law as its own figures state it. */
  private static SensorKind fittedByLevel() {
    SensingSetup setup =
        new SensingSetup(Catalogue.srf04(), new Scene(List.of()), 4, SetupDetails.NONE);
    Form law = LevelForms.law(setup);
    List<Double> neutral =
        law.parameters().stream()
            .map(value -> Math.max(value.low(), Math.min(value.high(), value.neutral())))
            .toList();
    return SensorKind.diagnosed(
        "by-level",
        new FittedModel(setup, List.of(), List.of(new FittedForm(law, neutral)), List.of()));
  }

  private static String question(String sensor, String more, int from, int count) {
    return """
        {"scene": {"format": "simbad-studio/1", "obstacle": "round", "sensor": "%s",
          "speed_m_per_s": %s, "seed": 1, "moves": [%s]}, "from": %d, "count": %d}"""
        .formatted(sensor, SPEED, more, from, count);
  }

  private JsonNode frames(String question) throws Exception {
    return new ObjectMapper().readTree(worlds.frames(question)).path("frames");
  }

  /** What is shown is what {@code simbad run} does, step for step. */
  @Test
  void placesAreThoseOfTheRun() throws Exception {
    Circuit circuit =
        new Circuit(
            Catalogue.find("round").orElseThrow(),
            List.of(),
            SensorKind.SHADOW,
            Catalogue.srf04(),
            SPEED,
            Optional.empty(),
            1);
    Trace trace = circuit.drive(new EdgeFollower(Tuning.standard(SPEED, Circuit.STEP_S)));
    JsonNode frames = frames(question("shadow", "", 1, 1000));

    // A run notes where the robot is after each step, the page where it is before.
    assertEquals(1000, frames.size());
    for (int i = 0; i < frames.size(); i++) {
      assertEquals(trace.xM(i), frames.get(i).get(0).asDouble(), 1e-4, "step " + i);
      assertEquals(trace.zM(i), frames.get(i).get(1).asDouble(), 1e-4, "step " + i);
    }
  }

  /** The same on a robot that moves otherwise: it is that of {@code run --robot}. */
  @Test
  void placesOnAnotherRobotAreThoseOfTheRun() throws Exception {
    Circuit circuit =
        new Circuit(
            Catalogue.find("round").orElseThrow(),
            List.of(),
            SensorKind.SHADOW.on(LAME),
            Catalogue.srf04(),
            SPEED,
            Optional.empty(),
            1);
    Trace trace = circuit.drive(new EdgeFollower(Tuning.standard(SPEED, Circuit.STEP_S)));
    String question = question("shadow", "", 1, 500);
    JsonNode frames = frames(question.replace("\"seed\"", "\"robot\": \"lame\", \"seed\""));
    JsonNode exact = frames(question);

    for (int i = 0; i < frames.size(); i++) {
      assertEquals(trace.xM(i), frames.get(i).get(0).asDouble(), 1e-4, "step " + i);
      assertEquals(trace.zM(i), frames.get(i).get(1).asDouble(), 1e-4, "step " + i);
    }
    assertTrue(
        Math.abs(exact.get(400).get(0).asDouble() - frames.get(400).get(0).asDouble()) > 0.05);
  }

  /** A narrower cone hears less of what stands aside. */
  @Test
  void aSonarOfTheCatalogueHasItsOwnFigures() throws Exception {
    // 5 degrees off the axis of one, 25 off the next: cones of 27.5 and of 20.
    String near = question("shadow", "{\"step\": 0, \"robot\": [0.0875, 1]}", 0, 1);
    JsonNode wide = frames(near).get(0);
    JsonNode narrow =
        frames(near.replace("\"seed\"", "\"sonar\": \"maxbotix-lv-ez1\", \"seed\"")).get(0);

    assertTrue(heard(wide) > heard(narrow), wide + " " + narrow);
  }

  private static int heard(JsonNode frame) {
    int heard = 0;
    for (int i = 6; i < 18; i++) {
      heard += frame.get(i).asInt() >= 0 ? 1 : 0;
    }
    return heard;
  }

  /**
   * Where the echo just reaches the threshold is the table's edge: the law is made of the table.
   */
  @Test
  void loudnessEndsAtTheTable_andGrowsInwards() throws Exception {
    JsonNode map = loudness("level");
    ThresholdTable table = Catalogue.find("angle").orElseThrow().thresholds().table();

    assertEquals("[0,6,12,18,24]", map.path("levels_db").toString());
    for (int bearing = 0; bearing < LoudnessMap.BEARINGS; bearing++) {
      double edgeM = map.path("reach_m").get(0).get(bearing).asDouble();
      // Nearer to the body than the sonar's least range nothing is heard.
      assertEquals(table.valueM(bearing), edgeM, 0.07, "bearing " + 5 * bearing);
      for (int level = 1; level < 5; level++) {
        assertTrue(
            map.path("reach_m").get(level).get(bearing).asDouble()
                <= map.path("reach_m").get(level - 1).get(bearing).asDouble());
      }
    }
    assertEquals("[]", loudness("shadow").path("levels_db").toString());
    assertThrows(DataFormatException.class, () -> loudness("none"));
  }

  private JsonNode loudness(String sensor) throws Exception {
    String question =
        "{\"obstacle\": \"angle\", \"sensor\": \"" + sensor + "\", \"sonar\": \"srf04\"}";
    return new ObjectMapper().readTree(worlds.loudness(question));
  }

  /** Asked for again, in parts, or after others, a scene is the same. */
  @Test
  void aSceneIsTheSameHoweverItIsAskedFor() throws Exception {
    String whole = frames(question("shadow", "", 0, 60)).toString();
    frames(question("original", "", 0, 10));
    StringBuilder parts = new StringBuilder();
    for (int from = 0; from < 60; from += 20) {
      String part = frames(question("shadow", "", from, 20)).toString();
      parts.append(from == 0 ? "[" : ",").append(part, 1, part.length() - 1);
    }

    assertEquals(whole, parts.append(']').toString());
  }

  /** As far out as the first, a third of a turn apart; the first is not touched by the others. */
  @Test
  void severalRobotsStartAround_andTheFirstIsAsAlone() throws Exception {
    String one = question("shadow", "", 0, 40);
    JsonNode alone = frames(one);
    JsonNode three = frames(one.replace("\"seed\"", "\"robots\": 3, \"seed\""));

    assertEquals(6 + 24 + 2 * 27, three.get(0).size());
    for (int step = 0; step < 40; step++) {
      for (int i = 0; i < 30; i++) {
        assertEquals(alone.get(step).get(i), three.get(step).get(i), "step " + step);
      }
    }
    double radius = Math.hypot(alone.get(0).get(0).asDouble(), alone.get(0).get(1).asDouble());
    double first = Math.atan2(alone.get(0).get(0).asDouble(), alone.get(0).get(1).asDouble());
    for (int robot = 1; robot < 3; robot++) {
      double x = three.get(0).get(30 + 27 * (robot - 1)).asDouble();
      double z = three.get(0).get(31 + 27 * (robot - 1)).asDouble();
      assertEquals(radius, Math.hypot(x, z), 1e-3);
      double apart = Math.atan2(x, z) - first;
      assertEquals(0, Math.sin((apart - robot * 2 * Math.PI / 3) / 2), 1e-3);
    }
  }

  @Test
  void oneOfSeveralRobotsIsMovedByHand() throws Exception {
    String moved =
        question("shadow", "{\"step\": 3, \"robot\": [1, 0.5], \"number\": 1}", 0, 5)
            .replace("\"seed\"", "\"robots\": 2, \"seed\"");
    JsonNode frame = frames(moved).get(3);

    assertEquals(1, frame.get(30).asDouble(), 1e-9);
    assertEquals(0.5, frame.get(31).asDouble(), 1e-9);
    assertTrue(Math.abs(frame.get(0).asDouble() - 1) > 0.1, frame.toString());
    assertThrows(
        DataFormatException.class,
        () -> worlds.frames(moved.replace("\"number\": 1", "\"number\": 2")));
  }

  /** Rays end at bodies, and robots are some; a shadow is that of the obstacle alone. */
  @Test
  void robotsHearEachOtherWithRaysAlone() throws Exception {
    for (String sensor : List.of("ray", "shadow")) {
      String question =
          question(
                  sensor,
                  "{\"step\": 0, \"robot\": [5, 5]},"
                      + " {\"step\": 0, \"robot\": [5.5, 5], \"number\": 1}",
                  0,
                  1)
              .replace("\"seed\"", "\"robots\": 2, \"seed\"");
      assertEquals(sensor.equals("ray") ? 1 : 0, heard(frames(question).get(0)), sensor);
    }
  }

  /** Of a world that runs fast some steps are shown: the very same ones. */
  @Test
  void someOfTheSteps_areThoseOfAll() throws Exception {
    JsonNode all = frames(question("shadow", "", 0, 400));
    String sparse = question("shadow", "", 3, 20).replace("\"count\"", "\"every\": 19, \"count\"");
    JsonNode some = frames(sparse);

    assertEquals(20, some.size());
    for (int i = 0; i < some.size(); i++) {
      assertEquals(all.get(3 + 19 * i), some.get(i));
    }
    // Nobody makes the program step for ever with one question.
    String far =
        question("shadow", "", 0, 2000).replace("\"count\"", "\"every\": 60000, \"count\"");
    assertEquals(1, frames(far).size());
  }

  @Test
  void sceneOfAFile_isRefusedByItsField(@TempDir Path folder) throws Exception {
    String scene =
        new ObjectMapper().readTree(question("shadow", "", 0, 1)).path("scene").toString();
    Path file = folder.resolve("scene.json");
    Files.writeString(file, scene.replace("\"moves\"", "\"beside\": \"\", \"moves\""));
    assertTrue(worlds.scene(file).contains("simbad-studio/1"));

    for (String bad :
        List.of(
            scene.replace("shadow", "none"),
            scene.replace("\"moves\"", "\"beside\": \"none\", \"moves\""),
            scene.replace("\"moves\"", "\"robots\": 99, \"moves\""),
            "[]",
            "")) {
      Files.writeString(file, bad);
      String refusal =
          String.valueOf(
              assertThrows(DataFormatException.class, () -> worlds.scene(file), bad).getMessage());
      assertTrue(refusal.contains("scene.json"), refusal);
    }
  }

  @Test
  void whatIsMovedByHandIsThereFromThatStepOn() throws Exception {
    JsonNode frames =
        frames(
            question(
                "shadow",
                "{\"step\": 5, \"robot\": [1, 0.5]}, {\"step\": 8, \"obstacle\": [0.2, 0]}",
                0,
                20));

    assertTrue(Math.abs(frames.get(4).get(0).asDouble() - 1) > 0.1, frames.get(4).toString());
    assertEquals(1, frames.get(5).get(0).asDouble(), 1e-9);
    assertEquals(0, frames.get(7).get(3).asDouble(), 1e-9);
    assertEquals(0.2, frames.get(8).get(3).asDouble(), 1e-9);
  }

  /** Beyond the table's 2 m nothing is heard; the reasons say why, of each model its own. */
  @Test
  void reasonsAreThoseOfTheModel() throws Exception {
    String far = "{\"step\": 0, \"robot\": [0, 2.4]}";
    JsonNode byShadow = frames(question("shadow", far, 0, 1)).get(0);
    JsonNode byOriginal = frames(question("original", far, 0, 1)).get(0);
    JsonNode byLevel = frames(question("level", far, 0, 1)).get(0);

    assertTrue(has(byShadow, Reasons.OUTSIDE_SHADOW), byShadow.toString());
    assertTrue(has(byOriginal, Reasons.HEARD), byOriginal.toString());
    boolean tooWeak = false;
    for (int i = 18; i < byLevel.size(); i++) {
      tooWeak |= byLevel.get(i).asInt() > Reasons.TOO_WEAK;
    }
    assertTrue(tooWeak, byLevel.toString());
  }

  /** A fitted sensor that hears by a level law is too far by decibels, not by a table's edge. */
  @Test
  void aFittedLevelLawSpeaksInDecibels() throws Exception {
    String far = "{\"step\": 0, \"robot\": [0, 2.4]}";
    JsonNode frame = frames(question("diagnosed-by-level", far, 0, 1)).get(0);

    boolean tooWeak = false;
    for (int i = 18; i < frame.size(); i++) {
      tooWeak |= frame.get(i).asInt() > Reasons.TOO_WEAK;
    }
    assertTrue(tooWeak, frame.toString());
    assertFalse(has(frame, Reasons.OUTSIDE_SHADOW), frame.toString());
  }

  /** A ray passes by, or is too short; a cone that the shadow does not meet is apart from it. */
  @Test
  void raysAndOverlapHaveReasonsOfTheirOwn() throws Exception {
    JsonNode near = frames(question("ray", "{\"step\": 0, \"robot\": [0, 1]}", 0, 1)).get(0);
    JsonNode far = frames(question("ray", "{\"step\": 0, \"robot\": [0, 3]}", 0, 1)).get(0);
    JsonNode apart = frames(question("overlap", "{\"step\": 0, \"robot\": [0, 9]}", 0, 1)).get(0);

    assertTrue(has(near, Reasons.RAY_PASSES), near.toString());
    assertFalse(has(near, Reasons.NOTHING_IN_CONE), near.toString());
    assertTrue(has(far, Reasons.OUT_OF_RANGE), far.toString());
    assertTrue(has(apart, Reasons.CONE_APART), apart.toString());
    assertFalse(has(apart, Reasons.OUTSIDE_SHADOW), apart.toString());
  }

  @Test
  void anObstacleIsTurnedByHand() throws Exception {
    JsonNode frames =
        frames(
            question(
                "shadow",
                "{\"step\": 2, \"obstacle\": [0, 0], \"turn_deg\": 30},"
                    + " {\"step\": 4, \"obstacle\": [0.1, 0], \"turn_deg\": -45}",
                0,
                6));

    assertEquals(0, frames.get(1).get(5).asDouble(), 1e-9);
    assertEquals(Math.toRadians(30), frames.get(3).get(5).asDouble(), 1e-4);
    assertEquals(Math.toRadians(-45), frames.get(5).get(5).asDouble(), 1e-4);
  }

  /** Simbad's own sensor measures to the nearest point, not to the middle. */
  @Test
  void theOriginalEdgeIsSoFarFromTheNearestPoint() throws Exception {
    Outline outline = Catalogue.find("angle").orElseThrow().outline();
    double leastM = Double.POSITIVE_INFINITY;
    double mostM = 0;
    for (Point point : OriginalEdge.of(outline)) {
      assertEquals(2.5, outline.distanceM(point.xM(), point.zM()), 1e-9);
      double centreM = Math.hypot(point.xM(), point.zM());
      leastM = Math.min(leastM, centreM);
      mostM = Math.max(mostM, centreM);
    }
    assertTrue(mostM > leastM + 1e-3, leastM + " to " + mostM);
  }

  private static boolean has(JsonNode frame, int reason) {
    for (int i = 18; i < frame.size(); i++) {
      if (frame.get(i).asInt() == reason) {
        return true;
      }
    }
    return false;
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "simbad-studio/1 | simbad-studio/9 | format",
        "round | no-such-thing | obstacle",
        "\"shadow\" | \"no-such-sensor\" | sensor",
        "\"seed\": 1 | \"robot\": \"none\", \"seed\": 1 | robot",
        "\"seed\": 1 | \"sonar\": \"none\", \"seed\": 1 | sonar",
        "0.5, \"seed\" | -1, \"seed\" | speed_m_per_s",
        "\"seed\": 1 | \"seed\": 1.5 | seed",
        "\"seed\": 1 | \"robots\": 0, \"seed\": 1 | robots",
        "\"count\": 5 | \"every\": -1, \"count\": 5 | every",
        "\"moves\": [] | \"moves\": [{\"step\": -1, \"robot\": [0, 0]}] | step",
        "\"moves\": [] | \"moves\": [{\"step\": 1, \"robot\": [0]}] | robot",
        "\"moves\": [] | \"moves\": [{\"step\": 1, \"obstacle\": [0, 0], \"turn_deg\": 400}] | turn_deg",
        "\"moves\": [] | \"moves\": [{\"step\": 1, \"robot\": [0, 0], \"turn_deg\": 4}] | turn_deg",
        "\"moves\": [] | \"moves\": [{\"step\": 1, \"robot\": [0, 1e9]}] | robot",
        "\"moves\": [] | \"moves\": [{\"step\": 3, \"robot\": [0, 0]}, {\"step\": 1, \"robot\": [0, 0]}] | out of order",
        "\"count\": 5 | \"count\": 1e12 | count"
      })
  void aBadQuestionIsRefusedByItsField(String good, String bad, String named) {
    String question = question("shadow", "", 0, 5).replace(good, bad);
    String refusal =
        String.valueOf(
            assertThrows(DataFormatException.class, () -> worlds.frames(question)).getMessage());

    assertTrue(refusal.contains(named), refusal);
  }
}
