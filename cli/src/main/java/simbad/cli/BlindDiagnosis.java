package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simbad.experiments.workers.Workers;
import simbad.sonar.format.WholeFile;

/**
 * Has cases diagnosed by processes that see their open files and nothing else.
 *
 * <p>Answers are kept one by one, in the order of the cases' names and each as a whole, so that a
 * check that ends early goes on where it was.
 */
final class BlindDiagnosis {
  /** Written last of a diagnosis, and asked for when a case of readings counts as answered. */
  static final String PREDICTIONS = "predictions.csv";

  private static final String DIAGNOSIS = "diagnosis.json";

  private static final String PARTIAL = ".unfinished";

  private final DiagnosisJob.Source program;
  private final List<String> withheld;
  private final Duration limit;
  private final Path world;
  private final Path answers;

  /**
   * A diagnosis of a world's cases.
   *
   * @param program that knows {@code diagnose} and {@code predict}
   * @param withheld effects that it is not told of
   * @param limit after which a case is given up
   * @param world with cases/ and rows/
   * @param answers the folder for the answers, made if need be
   */
  BlindDiagnosis(
      DiagnosisJob.Source program,
      List<String> withheld,
      Duration limit,
      Path world,
      Path answers) {
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
          .filter(id -> !Files.exists(answers.resolve(id).resolve(asked(id))))
          .sorted()
          .toList();
    }
  }

  /** An answer to a robot's drive counts without predictions. */
  private String asked(String id) {
    boolean motion = Files.exists(world.resolve("cases").resolve(id).resolve("track.csv"));
    return motion ? DIAGNOSIS : PREDICTIONS;
  }

  /**
   * Answers what is unanswered; what fails stays so.
   *
   * @param workers do it
   * @param answered called after each case, answered or not
   * @param complaints told each line that was said of a case
   */
  void run(Workers workers, Runnable answered, Consumer<String> complaints)
      throws IOException, InterruptedException {
    Files.createDirectories(answers);
    deletePartial();
    List<OpenCase> cases = new ArrayList<>();
    for (String id : unanswered()) {
      cases.add(OpenCase.read(world, id));
    }
    try (DiagnosisJob job = new DiagnosisJob(program, cases, withheld, limit)) {
      workers.run(
          job,
          0,
          cases.size(),
          answer -> {
            answer.complaints().forEach(complaints);
            keep(answer);
            answered.run();
          });
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

  /** An answer appears under its name when all of it is there. */
  private void keep(CaseAnswer answer) throws IOException {
    if (answer.files().isEmpty()) {
      return;
    }
    Path partial = Files.createDirectory(answers.resolve(answer.id() + PARTIAL));
    for (var file : answer.files().entrySet()) {
      WholeFile.write(partial.resolve(file.getKey()), file.getValue());
    }
    Files.move(partial, answers.resolve(answer.id()), StandardCopyOption.ATOMIC_MOVE);
  }
}
