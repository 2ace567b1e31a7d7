package simbad.experiments.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Has cases diagnosed by a process that sees their open files and nothing else.
 *
 * <p>The process runs in a folder of its own, far from the truths, to which the cases' scene,
 * readings and reference are copied. The rows to predict are brought in after the diagnosis is
 * there. Each answer is kept as soon as it is whole, so that a check that ends early goes on where
 * it was.
 */
final class BlindDiagnosis {
  /** So many cases share one start of Java; of a process that dies no more can be lost. */
  private static final int BATCH = 32;

  private static final Duration GLANCE = Duration.ofMillis(100);
  private static final List<String> OPEN = List.of("scene.json", "readings.csv", "reference.csv");

  /** Written last of a diagnosis, and asked for when a case counts as answered. */
  private static final String PREDICTIONS = "predictions.csv";

  private static final String ANSWERS = "answers";
  private static final String ROWS = "rows.csv";
  private static final String PARTIAL = ".unfinished";

  private final JavaProgram program;
  private final List<String> withheld;
  private final Duration limit;
  private final Path world;
  private final Path answers;

  /**
   * A diagnosis of a world's cases.
   *
   * @param program that knows {@code diagnose} and {@code predict}
   * @param withheld effects that it is not told of
   * @param limit after which a case without a sign of life is given up
   * @param world with cases/ and rows/
   * @param answers the folder for the answers, made if need be
   */
  BlindDiagnosis(
      JavaProgram program, List<String> withheld, Duration limit, Path world, Path answers) {
    this.program = program;
    this.withheld = List.copyOf(withheld);
    this.limit = limit;
    this.world = world;
    this.answers = answers;
  }

  /** The cases without an answer, in the order of their names. */
  List<String> unanswered() throws IOException {
    try (Stream<Path> cases = Files.list(world.resolve("cases"))) {
      return cases
          .map(one -> one.getFileName().toString())
          .filter(id -> !Files.exists(answers.resolve(id).resolve(PREDICTIONS)))
          .sorted()
          .toList();
    }
  }

  /**
   * Answers what is unanswered; what fails stays so.
   *
   * @param answered called after each answer, and after each case that is given up
   * @param complaints told each line of the process's standard error
   */
  void run(Runnable answered, Consumer<String> complaints)
      throws IOException, InterruptedException {
    Files.createDirectories(answers);
    deletePartial();
    Deque<String> left = new ArrayDeque<>(unanswered());
    while (!left.isEmpty()) {
      List<String> batch = new ArrayList<>();
      while (batch.size() < BATCH && !left.isEmpty()) {
        batch.add(left.remove());
      }
      List<String> again = new Batch(batch, answered, complaints).run();
      for (int i = again.size() - 1; i >= 0; i--) {
        left.addFirst(again.get(i));
      }
    }
  }

  private void deletePartial() throws IOException {
    try (Stream<Path> entries = Files.list(answers)) {
      for (Path one : entries.filter(p -> p.toString().endsWith(PARTIAL)).toList()) {
        try (Stream<Path> files = Files.list(one)) {
          for (Path file : files.toList()) {
            Files.delete(file);
          }
        }
        Files.delete(one);
      }
    }
  }

  /** One process's cases. */
  private final class Batch {
    private final Set<String> waiting;
    private final Runnable answered;
    private final Consumer<String> complaints;

    Batch(Collection<String> cases, Runnable answered, Consumer<String> complaints) {
      this.waiting = new LinkedHashSet<>(cases);
      this.answered = answered;
      this.complaints = complaints;
    }

    /** Returns the cases that had no chance and are to be tried again. */
    List<String> run() throws IOException, InterruptedException {
      Path name = Path.of(System.getProperty("java.io.tmpdir")).resolve("simbad-blind-check");
      try (StagedDirectory desk = StagedDirectory.beside(name)) {
        for (String id : waiting) {
          bring(id, desk.path());
        }
        try (ChildProcess process =
            ChildProcess.start(
                program.with(arguments()), desk.path(), Optional.empty(), complaints)) {
          return attend(process, desk.path());
        }
      }
    }

    private List<String> arguments() {
      List<String> arguments = new ArrayList<>(List.of("diagnose"));
      arguments.addAll(waiting);
      arguments.addAll(List.of("--out", ANSWERS));
      if (!withheld.isEmpty()) {
        arguments.addAll(List.of("--withhold", String.join(",", withheld)));
      }
      return arguments;
    }

    private List<String> attend(ChildProcess process, Path desk)
        throws IOException, InterruptedException {
      long quietSinceNs = System.nanoTime();
      boolean ended = false;
      while (!ended) {
        ended = process.await(GLANCE).isPresent();
        if (takeAnswers(desk)) {
          quietSinceNs = System.nanoTime();
        }
        if (!ended && System.nanoTime() - quietSinceNs > limit.toNanos()) {
          return giveUp();
        }
      }
      waiting.forEach(id -> answered.run());
      return List.of();
    }

    /** Whether there was any. */
    private boolean takeAnswers(Path desk) throws IOException, InterruptedException {
      boolean any = false;
      for (String id : List.copyOf(waiting)) {
        Path answer = desk.resolve(ANSWERS).resolve(id);
        if (Files.isRegularFile(answer.resolve("diagnosis.json"))) {
          predict(id, desk);
          waiting.remove(id);
          answered.run();
          any = true;
        }
      }
      return any;
    }

    /** The first of those that wait are in work, one on each core; they are what takes so long. */
    private List<String> giveUp() {
      int cores = Runtime.getRuntime().availableProcessors();
      List<String> left = new ArrayList<>(waiting);
      List<String> slow = left.subList(0, Math.min(cores, left.size()));
      for (String id : slow) {
        complaints.accept(id + ": no diagnosis within " + limit.toSeconds() + " s");
        answered.run();
      }
      return List.copyOf(left.subList(slow.size(), left.size()));
    }

    private void predict(String id, Path desk) throws IOException, InterruptedException {
      Path rows = Files.createDirectories(desk.resolve("rows").resolve(id)).resolve(ROWS);
      Files.copy(world.resolve("rows").resolve(id).resolve(ROWS), rows);
      Path answer = desk.resolve(ANSWERS).resolve(id);
      List<String> arguments =
          List.of(
              "predict",
              desk.relativize(answer).toString(),
              desk.relativize(rows).toString(),
              "--out",
              desk.relativize(answer.resolve(PREDICTIONS)).toString());
      try (ChildProcess process =
          ChildProcess.start(program.with(arguments), desk, Optional.empty(), complaints)) {
        Optional<Integer> status = process.await(limit);
        if (status.isEmpty()) {
          complaints.accept(id + ": no prediction within " + limit.toSeconds() + " s");
        }
        if (status.equals(Optional.of(ExitStatus.DONE))) {
          keep(answer, id);
        }
      }
    }
  }

  private void bring(String id, Path desk) throws IOException {
    Path target = Files.createDirectory(desk.resolve(id));
    for (String file : OPEN) {
      Path source = world.resolve("cases").resolve(id).resolve(file);
      if (Files.isRegularFile(source)) {
        Files.copy(source, target.resolve(file));
      }
    }
  }

  /** An answer appears under its name when all of it is there. */
  private void keep(Path answer, String id) throws IOException {
    Path partial = Files.createDirectory(answers.resolve(id + PARTIAL));
    try (Stream<Path> files = Files.list(answer)) {
      files.forEach(file -> copy(file, partial.resolve(file.getFileName().toString())));
    } catch (UncheckedIOException e) {
      throw new IOException(e.getMessage(), e);
    }
    Files.move(partial, answers.resolve(id), StandardCopyOption.ATOMIC_MOVE);
  }

  private static void copy(Path from, Path to) {
    try {
      Files.copy(from, to);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
