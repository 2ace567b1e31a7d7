package simbad.studio.folders;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.bench.capture.Approach;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Journal;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.TriedDistance;
import simbad.bench.protocol.PingStatus;
import simbad.experiments.bench.CaptureFolder;
import simbad.experiments.report.RunFiles;
import simbad.experiments.report.RunOrigin;
import simbad.experiments.run.Experiment;
import simbad.experiments.run.RunSettings;
import simbad.experiments.run.SensorKind;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.TableDocument;
import simbad.sonar.shape.ThresholdBand;
import simbad.sonar.shape.ThresholdTable;

/** A folder with one of each kind, as commands leave them. */
public final class Samples {
  /** A name that would be an element of a page that was careless. */
  public static final String MARKUP = "<img src=x onerror=boom()>";

  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final double BELIEVED_M_PER_S = 340;
  private static final double TRUE_M_PER_S = 357;

  private Samples() {}

  /** Fills a folder. */
  public static void write(Path folder) throws Exception {
    run(folder.resolve("runs/one"), 1);
    run(folder.resolve("runs/two"), 2);
    dataSet(folder.resolve("sets/wall"));
    diagnosis(folder.resolve("diagnoses/wall"), folder.resolve("sets/wall"));
    diagnosis(folder.resolve("diagnoses/again"), folder.resolve("sets/wall"));
    MotionSamples.drive(folder.resolve("sets/robot"));
    MotionSamples.motion(folder.resolve("motion/robot"), folder.resolve("sets/robot"));
    MotionSamples.motion(folder.resolve("motion/second"), folder.resolve("sets/robot"));
    dataSet(folder.resolve("sets/joint/wall"));
    MotionSamples.drive(folder.resolve("sets/joint/wall"));
    diagnosis(folder.resolve("joint/wall"), folder.resolve("sets/joint/wall"));
    MotionSamples.joint(folder.resolve("joint/wall"), folder.resolve("sets/joint/wall"));
    batch(folder.resolve("batch"));
    capture(folder.resolve("captures/post"), "post");
    capture(folder.resolve("captures/again"), "angle");
    batch(folder.resolve(MARKUP));
  }

  /** A table with an uncertainty, so that there is an interval to be shown. */
  private static ObstacleType post() {
    ObstacleType round = Catalogue.find("round").orElseThrow();
    ThresholdTable table = ThresholdTable.uniform(36, 1.5);
    ThresholdBand band =
        new ThresholdBand(ThresholdTable.uniform(36, 1.4), ThresholdTable.uniform(36, 1.6));
    return new ObstacleType(
        "post",
        round.parts(),
        new TableDocument(
            table,
            Map.of("provenance", "captured", "pings", "720 in all, 10 at each distance"),
            Optional.of(band)));
  }

  private static void run(Path folder, long seed) throws IOException {
    RunSettings settings =
        new RunSettings(
            List.of(post()),
            List.of(SensorKind.ORIGINAL, SensorKind.SHADOW),
            Catalogue.srf04(),
            0.5,
            Optional.empty(),
            seed);
    RunFiles.write(
        Files.createDirectories(folder),
        new RunOrigin("test", settings),
        Experiment.run(settings, result -> {}));
  }

  /** A wall, before which sound is faster than is believed; nothing is heard beyond 2 m. */
  private static void dataSet(Path folder) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(
        folder.resolve("scene.json"),
        """
        {"format": "sonar-gap/1", "no_echo_m": 4.0,
         "sensor": {"name": "SRF04", "cone_half_angle_deg": 27.5, "min_range_m": 0.03, "max_range_m": 4.0,
          "mount_height_m": 0.15, "assumed_sound_speed_m_s": 340, "resolution_m": 0, "range_noise_m": 0.004,
          "miss_rate": 0.005, "edge_width_m": 0.02, "update_period_s": 0.05},
         "obstacles": [{"name": "wall", "x_m": 0, "z_m": 0, "turn_deg": 0,
          "outline_m": [[0.5, 0.01], [0.5, -0.01], [-0.5, -0.01], [-0.5, 0.01]],
          "detection": "uniform", "uniform_range_m": 2.5}]}
        """);
    StringBuilder rows = new StringBuilder("run,sensor,t_s,x_m,z_m,heading_deg,range_m\n");
    for (int i = 0; i < 60; i++) {
      double distanceM = 0.2 + 0.04 * i;
      double rangeM = (distanceM - 0.01) * BELIEVED_M_PER_S / TRUE_M_PER_S;
      rows.append(
          String.format(
              Locale.ROOT,
              "a,one,%.2f,0,%.4f,90,%s%n",
              0.05 * i,
              distanceM,
              distanceM < 2 ? String.format(Locale.ROOT, "%.4f", rangeM) : ""));
    }
    Files.writeString(folder.resolve("readings.csv"), rows.toString().replace("\r", ""));
  }

  private static void diagnosis(Path folder, Path set) throws IOException {
    Files.createDirectories(folder);
    Files.copy(set.resolve("scene.json"), folder.resolve("scene.json"));
    Files.writeString(
        folder.resolve("model.json"),
        """
        {"format": "sonar-model/1", "sensors": ["one"], "setup": [], "changes": [
         {"effect": "sound-speed", "form": "scale", "parameters": {"sound_speed_m_s": 357}}]}
        """);
    ObjectNode json =
        (ObjectNode)
            MAPPER.readTree(
                """
                {"format": "sonar-diagnosis/2", "dataset": "wall", "audit": [], "verdict": "explained",
                 "explanation": ["sound-speed"], "unknown_probability": 0.02,
                 "gap": {"rows_held_out": 30, "before_cm": 20, "after_cm": 5, "floor_cm": 4, "shrink": 0.75, "shrink_ci95": [0.6, 0.8]},
                 "budget": [{"what": "sound-speed", "cm": 15, "ci95": [12, 17]}, {"what": "rest", "cm": 1, "ci95": [0, 2]},
                  {"what": "floor", "cm": 4, "ci95": [3, 5]}],
                 "effects": [{"name": "sound-speed", "probability": 0.97, "form": "scale", "parameters": {"sound_speed_m_s": 357},
                  "ci95": {"sound_speed_m_s": [355, 359]}, "remedy": "compute with 357 m/s", "indistinguishable_from": []}],
                 "where": [{"slice": {"distance_m": [1.0, 2.0]}, "rows": 12, "share_of_gap": 0.6, "before_cm": 8, "after_cm": 1,
                   "kind": "range error", "q_value": 0.001},
                  {"slice": {"distance_m": [2.0, 3.0], "run": "a"}, "rows": 6, "share_of_gap": 0.3, "before_cm": 90, "after_cm": 90,
                   "kind": "missed echo", "q_value": 0.01}]}
                """);
    ObjectNode hashes = json.putObject("provenance").putObject("sha256");
    new DataSetFolder(set).sha256().forEach(hashes::put);
    Files.writeString(folder.resolve("diagnosis.json"), json.toPrettyString());
  }

  private static void batch(Path folder) throws IOException {
    Files.createDirectories(folder);
    Files.writeString(
        folder.resolve("batch.json"), "{\"format\": \"simbad-batch/1\", \"runs\": 4}");
    Files.writeString(
        folder.resolve("results.csv"),
        """
        run,scene,obstacle,sensor,speed_m_per_s,seed,status,error,mean_abs_cm,lateral_mean_cm,edge_kept
        0,post,post,original,0.1,1,done,,51.2,40.1,0.1
        1,post,post,original,0.2,1,done,,52.2,41.1,0.1
        2,post,post,shadow,0.1,1,done,,0.6,0.5,1
        3,post,post,shadow,0.2,1,failed,it was stopped,,,
        """);
  }

  private static void capture(Path folder, String obstacle) throws IOException {
    SweepPlan plan = SweepPlan.ofBearings(4);
    CaptureSettings settings =
        new CaptureSettings(plan, OptionalDouble.of(20), Map.of("obstacle", obstacle));
    List<Entry> entries = new ArrayList<>();
    for (int bearing = 0; bearing < 2; bearing++) {
      for (int level = 0; level < 3; level++) {
        // Ten pings at each distance: all, half, none of them heard.
        for (int ping = 0; ping < plan.pings(); ping++) {
          entries.add(taken(entries.size(), bearing, 1 + 0.1 * level, 5 * level <= ping));
        }
      }
      entries.add(new Entry.Done(bearing));
    }
    entries.add(taken(entries.size(), 2, 1, true));
    try (Journal journal = new CaptureFolder(folder).begin(settings)) {
      journal.append(entries);
    }
  }

  private static Entry taken(int number, int bearing, double distanceM, boolean isHeard) {
    return new Entry.Taken(
        0.07 * number,
        bearing,
        new TriedDistance(distanceM, Approach.OUT),
        number,
        isHeard ? PingStatus.ECHO : PingStatus.NO_ECHO,
        isHeard ? OptionalInt.of(5800) : OptionalInt.empty(),
        OptionalDouble.empty());
  }
}
