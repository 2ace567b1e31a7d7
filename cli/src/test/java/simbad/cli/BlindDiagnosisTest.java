package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.experiments.workers.LocalWorkers;
import simbad.experiments.workers.Workers;

/** How cases are handed to a diagnosis, here a script, and how its answers are kept. */
class BlindDiagnosisTest {
  /** Notes what it sees, then answers. Tests' scripts are put before it. */
  private static final String ANSWERING =
      """
      case $1 in
      diagnose)
        mkdir -p answers/$2
        find . -type f | sort >>NOTES
        echo {} >answers/$2/diagnosis.json ;;
      predict)
        cat $3 >>NOTES
        cp $3 $5 ;;
      esac
      status=0
      """;

  /** Does commands line by line. */
  private static final String LOOP =
      """
      while read -r line; do
      set -- $line
      status=1
      SCRIPT
      echo "ended with status $status"
      done
      """;

  private static final Duration LONG = Duration.ofMinutes(5);

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private final List<String> complaints = Collections.synchronizedList(new ArrayList<>());
  private final AtomicInteger steps = new AtomicInteger();

  @BeforeEach
  void makeAWorld() throws IOException {
    for (String id : List.of("a", "b", "c")) {
      Path open = Files.createDirectories(folder.resolve("world/cases").resolve(id));
      Path truth = Files.createDirectories(folder.resolve("world/truth").resolve(id));
      Path rows = Files.createDirectories(folder.resolve("world/rows").resolve(id));
      Files.writeString(open.resolve("scene.json"), "scene");
      Files.writeString(open.resolve("readings.csv"), "readings");
      Files.writeString(open.resolve("notes.txt"), "no file of a data set");
      Files.writeString(truth.resolve("truth.json"), "truth");
      Files.writeString(rows.resolve("rows.csv"), "rows of " + id + "\n");
    }
    Files.writeString(folder.resolve("world/cases/b/reference.csv"), "reference");
  }

  private Path notes() {
    return folder.resolve("notes");
  }

  private BlindDiagnosis diagnosis(String script, Duration limit) throws IOException {
    Path file = folder.resolve("script");
    Files.writeString(file, LOOP.replace("SCRIPT", script).replace("NOTES", notes().toString()));
    String program = file.toString();
    return new BlindDiagnosis(
        () -> new JavaProgram(List.of("/bin/sh", program)),
        List.of("gain", "latency"),
        limit,
        folder.resolve("world"),
        folder.resolve("answers"));
  }

  private List<String> run(BlindDiagnosis diagnosis) throws Exception {
    return run(diagnosis, 1);
  }

  private List<String> run(BlindDiagnosis diagnosis, int jobs) throws Exception {
    try (Workers workers = new LocalWorkers(jobs)) {
      diagnosis.run(workers, steps::incrementAndGet, complaints::add);
    }
    return diagnosis.unanswered();
  }

  /** Scene, readings, reference of one case: nothing else is there until the diagnosis is. */
  @Test
  void diagnosis_seesOpenFilesOnly() throws Exception {
    assertEquals(List.of(), run(diagnosis(ANSWERING, LONG)));
    assertEquals(
        List.of(
            "./a/readings.csv",
            "./a/scene.json",
            "rows of a",
            "./b/readings.csv",
            "./b/reference.csv",
            "./b/scene.json",
            "rows of b",
            "./c/readings.csv",
            "./c/scene.json",
            "rows of c"),
        Files.readAllLines(notes()));
    assertEquals("rows of b\n", Files.readString(folder.resolve("answers/b/predictions.csv")));
    assertEquals(3, steps.get());
    assertEquals(List.of(), complaints);
  }

  /** A robot's folder is predicted as a whole; without a prediction its verdict counts. */
  @Test
  void motion_isAnsweredWithoutPredictions() throws Exception {
    Path open = Files.createDirectories(folder.resolve("world/cases/d"));
    Path rows = Files.createDirectories(folder.resolve("world/rows/d"));
    for (String name : List.of("robot.json", "commands.csv", "track.csv")) {
      Files.writeString(open.resolve(name), name);
      Files.writeString(rows.resolve(name), name + " sealed\n");
    }
    String script =
        """
        case $1 in
        diagnose)
          mkdir -p answers/$2
          echo {} >answers/$2/diagnosis.json
          status=0 ;;
        predict)
          ls $3 >>NOTES ;;
        esac
        """;
    BlindDiagnosis diagnosis = diagnosis(script, LONG);
    assertEquals(List.of("a", "b", "c"), run(diagnosis));
    Path answer = folder.resolve("answers/d");
    assertTrue(Files.exists(answer.resolve("diagnosis.json")));
    assertFalse(Files.exists(answer.resolve("predictions.csv")));
    assertTrue(Files.readAllLines(notes()).contains("track.csv"), "the folder is given");
  }

  @Test
  void answers_areTheSameWhoeverGivesThem() throws Exception {
    assertEquals(List.of(), run(diagnosis(ANSWERING, LONG), 3));
    for (String id : List.of("a", "b", "c")) {
      Path answer = folder.resolve("answers").resolve(id);
      assertEquals("rows of " + id + "\n", Files.readString(answer.resolve("predictions.csv")));
      assertEquals("{}\n", Files.readString(answer.resolve("diagnosis.json")));
    }
  }

  @Test
  void withheldEffects_areToldToTheProgram() throws Exception {
    run(diagnosis("echo \"$@\" >>NOTES\n" + ANSWERING, LONG));
    assertEquals(
        "diagnose a --out answers --withhold gain,latency", Files.readAllLines(notes()).get(0));
  }

  @Test
  void answered_isNotAskedAgain() throws Exception {
    run(diagnosis(ANSWERING, LONG));
    Files.delete(folder.resolve("answers/b/predictions.csv"));
    Files.delete(folder.resolve("answers/b/diagnosis.json"));
    Files.delete(folder.resolve("answers/b"));
    Files.delete(notes());
    assertEquals(List.of(), run(diagnosis("echo \"$@\" >>NOTES\n" + ANSWERING, LONG)));
    List<String> asked =
        Files.readAllLines(notes()).stream().filter(line -> line.contains("--out")).toList();
    assertEquals(2, asked.size(), asked.toString());
    assertTrue(asked.get(0).startsWith("diagnose b --out"));
  }

  /** The case is lost, the next one has a process of its own. */
  @Test
  void programThatDies_losesOneCase() throws Exception {
    String script = "[ $1$2 = diagnosea ] && { echo it broke >&2; exit 1; }\n" + ANSWERING;
    assertEquals(List.of("a"), run(diagnosis(script, LONG)));
    assertEquals(List.of("it broke", "diagnose a: its process ended"), complaints);
    assertEquals(3, steps.get());
    assertTrue(Files.exists(folder.resolve("answers/b/diagnosis.json")));
  }

  @Test
  void predictionThatFails_isNoAnswer() throws Exception {
    String script = "[ $1 = predict ] && echo no >&2 || {\n" + ANSWERING + "}\n";
    assertEquals(List.of("a", "b", "c"), run(diagnosis(script, LONG)));
    assertEquals(List.of("no", "no", "no"), complaints);
    assertFalse(Files.exists(folder.resolve("answers/a")));
  }

  /** The one case is given up; the others are answered. */
  @Test
  void programThatHangs_isEnded() throws Exception {
    String script = "[ $1$2 = diagnosea ] && exec sleep 600\n" + ANSWERING;
    assertEquals(List.of("a"), run(diagnosis(script, Duration.ofSeconds(1))));
    assertEquals(List.of("diagnose a: not done within 1 s"), complaints);
    assertEquals(3, steps.get());
  }

  @Test
  void predictionThatHangs_isEnded() throws Exception {
    String script = "[ $1 = predict ] && exec sleep 600\n" + ANSWERING;
    assertEquals(List.of("a", "b", "c"), run(diagnosis(script, Duration.ofSeconds(1))));
    assertEquals("predict answers/a: not done within 1 s", complaints.get(0));
  }
}
