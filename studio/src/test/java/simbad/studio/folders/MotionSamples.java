package simbad.studio.folders;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.motion.CommandReach;
import simbad.motion.Robot;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.PinballLoss;
import simbad.motion.forecast.Spread;
import simbad.motion.format.DiagnosedMotion;

/** Drives of a robot that is a tenth slower than it is told, and their diagnosis. */
final class MotionSamples {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final double TRUE_SCALE = 0.9;
  private static final double TURN_RAD_PER_S = 0.3;

  /** Straight on at 0.1 m/s, then an arc at 0.2 m/s. */
  private static final double ARC_FROM_S = 10;

  private static final double END_S = 20;

  private MotionSamples() {}

  /** Adds robot, commands and track of two runs. */
  static void drive(Path folder) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(
        folder.resolve("robot.json"),
        "{\"format\": \"motion-gap/1\", \"kinematics\": \"unicycle\","
            + " \"track_sigma_m\": 0.001, \"track_sigma_deg\": 0.1}\n");
    StringBuilder commands = new StringBuilder("run,t_s,v_m_s,w_rad_s\n");
    StringBuilder track = new StringBuilder("run,t_s,x_m,z_m,heading_deg\n");
    for (String run : List.of("a", "b")) {
      // What is told again in between is no change.
      commands.append(run).append(",0,0.1,0\n").append(run).append(",5,0.1,0\n");
      commands.append(run).append(",10,0.2,0.3\n");
      for (int i = 0; i <= 10 * END_S; i++) {
        track.append(row(run, i / 10.0));
      }
    }
    Files.writeString(folder.resolve("commands.csv"), commands.toString());
    Files.writeString(folder.resolve("track.csv"), track.toString());
  }

  /** In closed form: a line of 0.09 m/s, then a circle of radius 0.18 / 0.3 m. */
  private static String row(String run, double timeS) {
    double straightM = TRUE_SCALE * 0.1 * Math.min(timeS, ARC_FROM_S);
    double turnedRad = TURN_RAD_PER_S * Math.max(0, timeS - ARC_FROM_S);
    double radiusM = TRUE_SCALE * 0.2 / TURN_RAD_PER_S;
    return String.format(
            Locale.ROOT,
            "%s,%.1f,%.6f,%.6f,%.4f%n",
            run,
            timeS,
            straightM + radiusM * Math.sin(turnedRad),
            -radiusM * (1 - Math.cos(turnedRad)),
            Math.toDegrees(turnedRad))
        .replace("\r", "");
  }

  /** Adds the diagnosis of a drive. */
  static void motion(Path folder, Path set) throws IOException {
    Files.createDirectories(folder);
    model(folder, set);
    ObjectNode json = said();
    json.put("format", "sonar-diagnosis/2").put("about", "motion").put("dataset", "robot");
    json.set(
        "effects",
        MAPPER.readTree(
            """
            [{"name": "speed-scale", "form": "speed-scale", "probability": 0.99, "parameters": {"factor": 0.9},
              "ci95": {"factor": [0.89, 0.91]}, "indistinguishable_from": [], "remedy": "multiply the speed by 0.9"}]
            """));
    json.putArray("explanation").add("speed-scale");
    write(folder, set, json.put("unknown_probability", 0.1));
  }

  /** Adds the diagnosis of a log with readings and a drive: its readings' half is there already. */
  static void joint(Path folder, Path set) throws IOException {
    model(folder, set);
    ObjectNode json = (ObjectNode) MAPPER.readTree(folder.resolve("diagnosis.json").toFile());
    json.put("about", "joint");
    json.set("motion", said());
    json.set(
        "shared",
        MAPPER.readTree(
            """
            [{"name": "speed-scale", "heard_as": "odometry-scale", "parameter": "factor", "one_cause": true,
              "seen_by_tracker": true, "heard_by_sonar": true, "tracker": {"value": 0.9, "ci95": [0.89, 0.91]},
              "sonar": {"value": 0.92, "ci95": [0.8, 1.0]}, "together": {"value": 0.9001, "ci95": [0.89, 0.91]}}]
            """));
    write(folder, set, json);
  }

  private static void model(Path folder, Path set) throws IOException {
    Files.copy(set.resolve("robot.json"), folder.resolve("robot.json"));
    FittedMotion slow =
        new FittedMotion(
            MotionForms.find("speed-scale", Robot.EXACT_UNICYCLE).orElseThrow(),
            new double[] {TRUE_SCALE});
    Spread exact = Spread.one(new double[3][PinballLoss.QUANTILES]);
    Files.writeString(
        folder.resolve("motion.json"),
        DiagnosedMotion.text(List.of(slow), Collections.nCopies(3, exact), CommandReach.ANY));
  }

  private static ObjectNode said() throws IOException {
    StringBuilder horizons = new StringBuilder();
    for (String horizon : List.of("0.5", "2", "5")) {
      horizons
          .append(horizons.isEmpty() ? "" : ",")
          .append(
              """
              {"horizon_s": %s, "along_m": {"before": 0.1, "after": 0.02}, "across_m": {"before": 0.05, "after": 0.01},
               "turn_rad": {"before": 0.2, "after": 0.1}}"""
                  .formatted(horizon));
    }
    return (ObjectNode)
        MAPPER.readTree(
            """
            {"verdict": "explained", "headline": "the robot is slower than it is told",
             "budget": [{"what": "speed-scale", "share": 0.8, "ci95": [0.7, 0.9]}, {"what": "floor", "share": 0.2, "ci95": [0.1, 0.3]}],
             "gap": {"rows_held_out": 78, "shrink": 0.8, "shrink_ci95": [0.7, 0.9], "horizons": [%s]},
             "where": [{"slice": {"t_s": [10, 19.5]}, "rows": 40, "share_of_gap": 0.6, "before": 1.4, "after": 0.3, "kind": "along"},
              {"slice": {"t_s": [0, 10]}, "rows": 40, "share_of_gap": 0.4, "before": 0.7, "after": 0.3, "kind": "along"},
              {"slice": {"run": "b"}, "rows": 40, "share_of_gap": 0.5, "before": 1, "after": 0.3, "kind": "across"},
              {"slice": {"since_change_s": [5.2, 10.5]}, "rows": 38, "share_of_gap": 0.4, "before": 1, "after": 0.3, "kind": "along"}]}
            """
                .formatted(horizons));
  }

  private static void write(Path folder, Path set, ObjectNode json) throws IOException {
    ObjectNode hashes = json.withObject("/provenance").putObject("sha256");
    new DataSetFolder(set).sha256().forEach(hashes::put);
    Files.writeString(folder.resolve("diagnosis.json"), json.toPrettyString());
  }
}
