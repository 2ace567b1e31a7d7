package simbad.experiments.cli;

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

/** How cases are handed to a diagnosis, here a script, and how its answers are kept. */
class BlindDiagnosisTest {
  /** Notes what it sees, then answers; ends up as the tests' diagnosis with more lines before. */
  private static final String ANSWERING =
      """
      case $1 in
      diagnose)
        shift
        for id; do
          case $id in --*) break ;; esac
          mkdir -p answers/$id
          find . -type f | sort >>NOTES
          echo {} >answers/$id/diagnosis.json
        done ;;
      predict)
        cat $3 >>NOTES
        cp $3 $5 ;;
      esac
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
    Files.writeString(file, script.replace("NOTES", notes().toString()));
    return new BlindDiagnosis(
        new JavaProgram(List.of("/bin/sh", file.toString())),
        List.of("gain", "latency"),
        limit,
        folder.resolve("world"),
        folder.resolve("answers"));
  }

  private List<String> run(BlindDiagnosis diagnosis) throws Exception {
    diagnosis.run(steps::incrementAndGet, complaints::add);
    return diagnosis.unanswered();
  }

  /** Scene, readings, reference: nothing else is there until the diagnosis is. */
  @Test
  void diagnosis_seesOpenFilesOnly() throws Exception {
    assertEquals(List.of(), run(diagnosis(ANSWERING, LONG)));
    List<String> seen = Files.readAllLines(notes());
    assertEquals(
        List.of(
            "./a/readings.csv",
            "./a/scene.json",
            "./b/readings.csv",
            "./b/reference.csv",
            "./b/scene.json",
            "./c/readings.csv",
            "./c/scene.json"),
        seen.subList(0, 7));
    assertFalse(seen.toString().contains("truth"));
    assertEquals("rows of b\n", Files.readString(folder.resolve("answers/b/predictions.csv")));
    assertEquals(3, steps.get());
    assertEquals(List.of(), complaints);
  }

  @Test
  void withheldEffects_areToldToTheProgram() throws Exception {
    run(diagnosis("echo \"$@\" >>NOTES\n" + ANSWERING, LONG));
    assertEquals(
        "diagnose a b c --out answers --withhold gain,latency", Files.readAllLines(notes()).get(0));
  }

  @Test
  void answered_isNotAskedAgain() throws Exception {
    run(diagnosis(ANSWERING, LONG));
    Files.delete(folder.resolve("answers/b/predictions.csv"));
    Files.delete(folder.resolve("answers/b/diagnosis.json"));
    Files.delete(folder.resolve("answers/b"));
    Files.delete(notes());
    assertEquals(List.of(), run(diagnosis("echo \"$@\" >>NOTES\n" + ANSWERING, LONG)));
    assertTrue(Files.readAllLines(notes()).get(0).startsWith("diagnose b --out"));
  }

  @Test
  void programThatDies_leavesWhatItAnswered() throws Exception {
    String script = "[ $1 = predict ] || { set -- diagnose a; echo it broke >&2; }\n" + ANSWERING;
    assertEquals(List.of("b", "c"), run(diagnosis(script, LONG)));
    assertEquals(List.of("it broke"), complaints);
    assertEquals(3, steps.get());
    assertTrue(Files.exists(folder.resolve("answers/a/diagnosis.json")));
  }

  @Test
  void predictionThatFails_isNoAnswer() throws Exception {
    String script = "[ $1 = predict ] && { echo no >&2; exit 1; }\n" + ANSWERING;
    assertEquals(List.of("a", "b", "c"), run(diagnosis(script, LONG)));
    assertFalse(Files.exists(folder.resolve("answers/a")));
  }

  /** One case after which nothing more comes is given up; the others are asked for again. */
  @Test
  void programThatHangs_isEnded() throws Exception {
    String script = "[ $1 = diagnose ] && [ $2 = a ] && exec sleep 600\n" + ANSWERING;
    List<String> left = run(diagnosis(script, Duration.ofSeconds(1)));
    assertTrue(left.contains("a"), left.toString());
    assertTrue(complaints.get(0).startsWith("a: no diagnosis within 1 s"), complaints.toString());
    int cores = Math.min(3, Runtime.getRuntime().availableProcessors());
    assertEquals(cores, left.size());
    assertEquals(3, steps.get());
  }

  @Test
  void predictionThatHangs_isEnded() throws Exception {
    String script = "[ $1 = predict ] && exec sleep 600\n" + ANSWERING;
    assertEquals(List.of("a", "b", "c"), run(diagnosis(script, Duration.ofSeconds(1))));
    assertTrue(complaints.get(0).startsWith("a: no prediction within 1 s"));
  }
}
