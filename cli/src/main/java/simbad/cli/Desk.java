package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import simbad.sonar.format.WholeFile;

/**
 * A diagnosing process in a folder of its own, far from the truths, that holds one case at a time:
 * scene, readings and reference, and the rows to predict once the diagnosis is there. Not
 * thread-safe.
 */
final class Desk implements AutoCloseable {
  private static final AtomicInteger NUMBER = new AtomicInteger();
  private static final Duration GLANCE = Duration.ofMillis(100);
  private static final String ANSWERS = "answers";
  private static final String ROWS = "rows";

  private final StagedDirectory folder;
  private final ChildProcess process;
  private final BlockingQueue<String> heard;
  private boolean stands = true;

  private Desk(StagedDirectory folder, ChildProcess process, BlockingQueue<String> heard) {
    this.folder = folder;
    this.process = process;
    this.heard = heard;
  }

  /**
   * Starts the process.
   *
   * @param program that does commands as {@link StandingMain} does
   */
  static Desk open(JavaProgram program) throws IOException {
    Path place = Path.of(System.getProperty("java.io.tmpdir"));
    StagedDirectory folder =
        StagedDirectory.beside(place.resolve("simbad-desk" + NUMBER.incrementAndGet()));
    BlockingQueue<String> heard = new LinkedBlockingQueue<>();
    try {
      return new Desk(
          folder, ChildProcess.spokenTo(program.command(), folder.path(), heard::add), heard);
    } catch (IOException e) {
      folder.close();
      throw e;
    }
  }

  /** Tells whether it takes another case; false when its process ended or was given up. */
  boolean stands() {
    return stands;
  }

  /**
   * Has a case answered.
   *
   * @param one case
   * @param withheld effects that the diagnosis is not told of
   * @param limit after which a diagnosis, or a prediction, is given up
   */
  CaseAnswer answer(OpenCase one, List<String> withheld, Duration limit)
      throws IOException, InterruptedException {
    ArrayList<String> complaints = new ArrayList<>();
    TreeMap<String, byte[]> files = new TreeMap<>();
    Path answer = folder.path().resolve(ANSWERS).resolve(one.id());
    write(one.open(), folder.path().resolve(one.id()));
    if (isDone(diagnosing(one, withheld), limit, complaints)) {
      write(one.later(), folder.path().resolve(ROWS).resolve(one.id()));
      // Of motion a verdict counts without predictions, which the scorer then says are missing.
      if (isDone(predicting(one), limit, complaints) || one.isMotion()) {
        take(answer, files);
      }
    }
    clear();
    return new CaseAnswer(one.id(), files, complaints);
  }

  private static void write(Map<String, byte[]> files, Path target) throws IOException {
    Files.createDirectories(target);
    for (var file : files.entrySet()) {
      WholeFile.write(target.resolve(file.getKey()), file.getValue());
    }
  }

  private static List<String> diagnosing(OpenCase one, List<String> withheld) {
    List<String> words = new ArrayList<>(List.of("diagnose", one.id(), "--out", ANSWERS));
    if (!withheld.isEmpty()) {
      words.addAll(List.of("--withhold", String.join(",", withheld)));
    }
    return words;
  }

  private static List<String> predicting(OpenCase one) {
    String answer = ANSWERS + "/" + one.id();
    String folder = ROWS + "/" + one.id();
    String rows = one.isMotion() ? folder : folder + "/" + OpenCase.ROWS;
    return List.of("predict", answer, rows, "--out", answer + "/" + BlindDiagnosis.PREDICTIONS);
  }

  private boolean isDone(List<String> words, Duration limit, List<String> complaints)
      throws InterruptedException {
    process.say(String.join("\t", words));
    long begunNs = System.nanoTime();
    while (System.nanoTime() - begunNs < limit.toNanos()) {
      boolean ended = process.hasEnded();
      @Nullable String line = heard.poll(GLANCE.toMillis(), TimeUnit.MILLISECONDS);
      if (line != null && line.startsWith(StandingMain.ENDED)) {
        return line.equals(StandingMain.ENDED + ExitStatus.DONE);
      }
      if (line != null) {
        complaints.add(line);
      } else if (ended) {
        return givenUp(words, "its process ended", complaints);
      }
    }
    return givenUp(words, "not done within " + limit.toSeconds() + " s", complaints);
  }

  private boolean givenUp(List<String> words, String why, List<String> complaints) {
    complaints.add(words.get(0) + " " + words.get(1) + ": " + why);
    stands = false;
    return false;
  }

  private static void take(Path answer, Map<String, byte[]> files) throws IOException {
    try (Stream<Path> entries = Files.list(answer)) {
      for (Path file : entries.toList()) {
        files.put(file.getFileName().toString(), Files.readAllBytes(file));
      }
    }
  }

  /** So that the next case is alone. */
  private void clear() throws IOException {
    if (!stands) {
      return;
    }
    try (Stream<Path> entries = Files.walk(folder.path())) {
      for (Path path : entries.sorted(Comparator.reverseOrder()).toList()) {
        if (!path.equals(folder.path())) {
          Files.delete(path);
        }
      }
    }
  }

  @Override
  public void close() {
    stands = false;
    process.close();
    folder.close();
  }
}
