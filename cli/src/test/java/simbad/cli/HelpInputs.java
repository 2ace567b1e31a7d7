package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.stream.Stream;
import simbad.bench.capture.Approach;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Journal;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.TriedDistance;
import simbad.bench.protocol.PingStatus;
import simbad.experiments.bench.CaptureFolder;

/**
 * What the examples of the help take for granted: a reader's own files and folders, by the names
 * that the examples give them.
 */
final class HelpInputs {
  private static final String POSES =
      "run,sensor,t_s,x_m,z_m,heading_deg\nnext-1,S,0,0,0.5,90\nnext-1,S,1,0,0.6,90\n";
  private static final String PROGRAM =
      """
      import javax.vecmath.Vector3d;
      import simbad.gui.Simbad;
      import simbad.sim.*;

      public class MyProgram extends EnvironmentDescription {
        public MyProgram() {
          add(new Agent(new Vector3d(), "robot") {
            public void performBehavior() {
              setTranslationalVelocity(0.5);
            }
          });
        }

        public static void main(String[] args) {
          new Simbad(new MyProgram(), false);
        }
      }
      """;
  private static final String TABLE =
      "# object: a post\nbearing_deg,threshold_m\n0,0.9\n90,1.0\n180,1.1\n270,1.0\n";
  private static final Map<String, String> FILES =
      Map.ofEntries(
          Map.entry("my-table.csv", TABLE),
          Map.entry("my-angle.csv", TABLE),
          Map.entry("predicted.csv", TABLE),
          Map.entry("my-post-outline.csv", "x_mm,z_mm\n-10,-10\n10,-10\n10,10\n-10,10\n"),
          Map.entry("bench.csv", "Angle [deg],Distance (cm)\n0,90\n120,95\n240,100\n"),
          Map.entry("plot.csv", "phi,cm_max\n0,90\n120,95\n240,100\n"),
          Map.entry("numbers.txt", "49\n".repeat(72)),
          Map.entry("rows.csv", POSES),
          Map.entry("my-odometry.txt", "# time v w\n10.0 0.1 0\n10.5 0.1 0.2\n"),
          Map.entry("my-track.txt", "# time x y heading\n10.0 0 0 0\n10.5 0.05 0 0\n"),
          Map.entry("next-experiment.csv", POSES),
          Map.entry("my-spec.json", "{}"),
          Map.entry("my-log.csv", "true_cm,reading_cm\n10,9.8\n20,19.7\n30,29.9\n"),
          Map.entry(
              "my-scan.csv",
              "x_mm,y_mm,up_deg,us\n0,-300,0,1700\n50,-300,10,0\n100,-300,20,1900\n"),
          Map.entry(
              "tuning/results.csv",
              "sensor,status,controller.crossing_angle_deg,controller.curl_rad_per_step,"
                  + "mean_abs_cm,simulated_s\n"
                  + "shadow,done,20,0.01,3,50\nshadow,done,30,0.01,2,60\n"
                  + "shadow,done,20,0.02,4,40\nshadow,done,30,0.02,3,55\n"));

  private final Path prepared;

  /** Keeps in a folder what takes a while to make. */
  HelpInputs(Path prepared) {
    this.prepared = prepared;
  }

  /** Makes what the words of an example name, in a folder; of data sets, as few rows as will do. */
  void make(Path folder, List<String> words) throws Exception {
    for (String word : words) {
      String first = word.replaceFirst("^diagnosed:", "").split(",", 2)[0];
      if (FILES.containsKey(first)) {
        Files.writeString(folder.resolve(first), FILES.get(first));
      } else if (first.equals("my-batch") && words.contains("batch-plot")) {
        Path results = Files.createDirectories(folder.resolve(first)).resolve("results.csv");
        Files.writeString(results, FILES.get("tuning/results.csv"));
      } else if (first.equals("tuning")) {
        Path results = Files.createDirectories(folder.resolve(first)).resolve("results.csv");
        Files.writeString(results, FILES.get("tuning/results.csv"));
      } else if (first.equals("AngleRobot.log")) {
        Files.copy(Path.of("src/test/resources/guides", first), folder.resolve(first));
      }
    }
    if (words.contains("my-program")) {
      Path sources = Files.createDirectories(folder.resolve("my-program"));
      Files.writeString(sources.resolve("MyProgram.java"), PROGRAM);
    }
    String line = String.join(" ", words);
    if (line.contains("diagnose my-bench") || line.contains("mend my-bench")) {
      BenchData.write(folder.resolve("my-bench"), BenchData.rows(30, 0.05));
    }
    if (line.contains("export bag my-run")) {
      String run = folder.resolve("my-run").toString();
      Shell said =
          Shell.simbad(
              "run", "round", "--sensor", "shadow", "--speed", "0.5", "--readings", "--out", run);
      assertEquals(0, said.status(), said.err());
    }
    if (line.contains("diagnoses/")) {
      String name = line.replaceFirst(".*diagnoses/([\\w-]+).*", "$1");
      diagnosis(folder, name);
    }
    if (line.matches(".* (resume|table) angle-capture.*")) {
      capture(folder.resolve("angle-capture"), line.contains(" resume ") ? 2 : 3);
    }
  }

  /** What {@code simbad diagnose} leaves of thirty rows; diagnosed once, copied for each. */
  private void diagnosis(Path folder, String name) throws Exception {
    Path diagnoses = prepared.resolve("diagnoses");
    Path diagnosed = diagnoses.resolve("my-bench");
    if (!Files.exists(diagnosed)) {
      Path data = BenchData.write(prepared.resolve("my-bench"), BenchData.rows(30, 0.05));
      Shell said = Shell.simbad("diagnose", data.toString(), "--out", diagnoses.toString());
      assertEquals(0, said.status(), said.err());
    }
    Path copy = Files.createDirectories(folder.resolve("diagnoses").resolve(name));
    try (Stream<Path> files = Files.list(diagnosed).filter(Files::isRegularFile)) {
      for (Path file : files.toList()) {
        Files.copy(file, copy.resolve(String.valueOf(file.getFileName())));
      }
    }
    // Not every diagnosis leaves one.
    Files.writeString(copy.resolve("next-experiment.csv"), POSES);
  }

  /** A sweep of three bearings, of which so many are done. */
  private static void capture(Path where, int done) throws IOException {
    SweepPlan plan = SweepPlan.ofBearings(3).with(2, 1, 0.02);
    CaptureSettings settings =
        new CaptureSettings(
            plan,
            OptionalDouble.of(20),
            Map.of("obstacle", "angle", "model", "shadow", "seed", "1", "mode", "frame"));
    try (Journal journal = new CaptureFolder(where).begin(settings)) {
      for (int bearing = 0; bearing < done; bearing++) {
        journal.append(entries(bearing));
      }
    }
  }

  private static List<Entry> entries(int bearing) {
    List<Entry> entries = new ArrayList<>();
    for (PingStatus status :
        Arrays.asList(PingStatus.ECHO, PingStatus.ECHO, PingStatus.NO_ECHO, PingStatus.NO_ECHO)) {
      double distanceM = status == PingStatus.ECHO ? 1 : 1.02;
      entries.add(
          new Entry.Taken(
              1.8e9 + entries.size(),
              bearing,
              new TriedDistance(distanceM, Approach.OUT),
              entries.size(),
              status,
              OptionalInt.of(5800),
              OptionalDouble.of(20)));
    }
    entries.add(new Entry.Done(bearing));
    return entries;
  }
}
