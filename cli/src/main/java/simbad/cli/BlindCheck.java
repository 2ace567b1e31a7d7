package simbad.cli;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.definition.Effect;
import simbad.experiments.blindcheck.CheckJson;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckOrder.Benchmark;
import simbad.experiments.blindcheck.CheckOrder.Drawn;
import simbad.experiments.blindcheck.CheckOrder.Foreign;
import simbad.experiments.blindcheck.CheckScores;
import simbad.experiments.blindcheck.CheckSummary;
import simbad.experiments.blindcheck.ToldApart;
import simbad.experiments.workers.Workers;
import simbad.figures.blindcheck.CheckReport;
import simbad.figures.diagnosis.DiagnosisReport;
import simbad.sonar.effect.Definitions;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.format.TextFile;
import simbad.sonar.format.WholeFile;

/** The steps of a withheld check, in a folder that keeps what each of them leaves. */
final class BlindCheck {
  private static final String ORDER = "order.json";
  private static final String MANIFEST = "manifest.json";

  /** About as many cases as a half of a part of the benchmark has, for the progress bar. */
  private static final int BENCHMARK = 350;

  private final Path folder;
  private final CheckOrder order;
  private final PrintWriter out;
  private final PrintWriter err;
  private final Path world;
  private final Path answers;
  private final BlindWorld blindWorld;

  BlindCheck(Path folder, CheckOrder order, PrintWriter out, PrintWriter err) throws IOException {
    this.folder = folder;
    this.order = order;
    this.out = out;
    this.err = err;
    this.world = folder.resolve("world");
    this.answers = folder.resolve("answers");
    this.blindWorld = new BlindWorld(JavaProgram.blindWorld());
  }

  /** True for the folder of a check, and for an empty one. */
  static boolean mayStandIn(Path folder) throws IOException {
    if (Files.isRegularFile(folder.resolve(ORDER))) {
      return true;
    }
    if (!Files.isDirectory(folder)) {
      return false;
    }
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.findAny().isEmpty();
    }
  }

  /**
   * Notes the order down before anything is done.
   *
   * @throws DataFormatException when the folder is that of another order
   */
  void begin() throws IOException, DataFormatException {
    Path file = folder.resolve(ORDER);
    String text = CheckJson.text(order.json());
    // Before anything is drawn an order may still be mended, such as one that was refused.
    if (!Files.isRegularFile(file) || !Files.exists(world)) {
      Files.createDirectories(folder);
      TextFile.write(file, text);
    } else if (!Files.readString(file).equals(text)) {
      throw DataFormatException.inFile(
          file,
          "was begun with other options or another program; use the same ones, or "
              + "another --out");
    }
    log("begun, " + order.version() + ", java " + Runtime.version());
  }

  /** Has the cases drawn or taken over and their truths committed to, unless they are already. */
  void seal() throws IOException, DataFormatException, InterruptedException {
    if (!Files.exists(world)) {
      try (StagedDirectory staged = StagedDirectory.beside(world)) {
        if (order.source() instanceof Drawn drawn) {
          draw(drawn, staged.path());
        } else if (order.source() instanceof Benchmark benchmark) {
          draw(benchmark, staged.path());
        } else if (order.source() instanceof Foreign foreign) {
          takeOver(foreign, staged.path());
        }
        staged.publish();
      }
    }
    String line = "truths sealed, root " + root(world.resolve(MANIFEST));
    out.println(line);
    out.flush();
    log(line);
  }

  /** What blind-world is told to draw the worlds, less where to. */
  private List<String> drawing(Drawn drawn) {
    List<String> arguments = new ArrayList<>(List.of("generate"));
    arguments.addAll(List.of("--cases", "" + drawn.cases(), "--seed", "" + drawn.seed()));
    arguments.addAll(List.of("--progress", "1"));
    if (!drawn.isWave()) {
      arguments.addAll(List.of("--reference", "" + drawn.referenceShare()));
    }
    arguments.addAll(drawn.options());
    addWithheld(arguments);
    return arguments;
  }

  private static List<String> drawing(Benchmark benchmark) {
    List<String> arguments = new ArrayList<>(List.of("benchmark", "--progress", "1"));
    arguments.addAll(benchmark.options());
    return arguments;
  }

  private void draw(Drawn drawn, Path target)
      throws IOException, DataFormatException, InterruptedException {
    List<String> arguments = drawing(drawn);
    arguments.addAll(List.of("--out", target.toString()));
    try (Progress progress = Progress.of("drawing worlds", drawn.cases())) {
      blindWorld.run(arguments, Optional.empty(), line -> progress.step());
    }
  }

  private void draw(Benchmark benchmark, Path target)
      throws IOException, DataFormatException, InterruptedException {
    List<String> arguments = drawing(benchmark);
    arguments.addAll(List.of("--out", target.toString()));
    try (Progress progress = Progress.of("drawing worlds", benchmark.first().orElse(BENCHMARK))) {
      blindWorld.run(arguments, Optional.empty(), line -> progress.step());
    }
  }

  private void takeOver(Foreign foreign, Path target)
      throws IOException, DataFormatException, InterruptedException {
    List<String> arguments =
        new ArrayList<>(List.of("seal", "--sets", foreign.folder(), "--out", target.toString()));
    foreign.level().ifPresent(level -> arguments.addAll(List.of("--level", level)));
    blindWorld.run(arguments, Optional.empty(), line -> {});
  }

  private static List<String> effects() {
    return Definitions.effects().stream().map(Effect::word).toList();
  }

  private void addWithheld(List<String> arguments) {
    if (!order.withheld().isEmpty()) {
      arguments.addAll(List.of("--withheld", String.join(",", order.withheld())));
    }
  }

  private static String root(Path manifest) throws IOException, DataFormatException {
    try {
      return JsonMapper.builder()
          .build()
          .readTree(Files.readString(manifest))
          .path("root")
          .asText();
    } catch (JsonProcessingException e) {
      throw DataFormatException.inFile(manifest, "not JSON, expected the commitments");
    }
  }

  /**
   * Has all cases diagnosed that are not yet.
   *
   * @param who does it
   * @param limit after which a case is given up
   * @return the cases that still have no answer
   */
  List<String> diagnose(WorkersOption who, Duration limit)
      throws IOException, InterruptedException {
    return diagnose(who, limit, world, answers);
  }

  private List<String> diagnose(WorkersOption who, Duration limit, Path world, Path answers)
      throws IOException, InterruptedException {
    BlindDiagnosis diagnosis =
        new BlindDiagnosis(JavaProgram::standing, order.withheld(), limit, world, answers);
    int left = diagnosis.unanswered().size();
    if (left == 0) {
      return List.of();
    }
    List<String> complaints = new ArrayList<>();
    Instant begun = Instant.now();
    try (Workers workers = who.open();
        Progress progress = Progress.of("diagnosing", left)) {
      diagnosis.run(
          workers,
          progress::step,
          line -> {
            progress.clearLine();
            err.println(line);
            err.flush();
            complaints.add(line);
          });
    }
    for (String complaint : complaints) {
      log(complaint);
    }
    log("diagnosed " + left + " in " + Duration.between(begun, Instant.now()).toSeconds() + " s");
    return diagnosis.unanswered();
  }

  /** Audits all cases, as they are and with faults put in, and says how often it was right. */
  void audit() throws IOException, DataFormatException {
    new BlindAudit(world, folder).run(out);
    log("audited");
  }

  /**
   * Has the answers scored and writes the results.
   *
   * @param allPages whether each case keeps its page, or only those that were answered wrongly
   * @return the scores
   * @throws DataFormatException when a truth or a data set is not the one that was committed to
   */
  CheckScores score(boolean allPages)
      throws IOException, DataFormatException, InterruptedException {
    Path baseline = folder.resolve("baseline");
    answerByRule(baseline);
    CheckScores scores;
    try (TemporaryFolder temporary = TemporaryFolder.create("simbad-scores")) {
      Path file = temporary.path().resolve("scores.json");
      Path text = temporary.path().resolve("scores.txt");
      List<String> arguments =
          new ArrayList<>(List.of("score", "--truth", world.resolve("truth").toString()));
      arguments.addAll(List.of("--answers", answers.toString(), "--baseline", baseline.toString()));
      arguments.addAll(List.of("--manifest", world.resolve(MANIFEST).toString()));
      arguments.addAll(List.of("--out", file.toString()));
      arguments.addAll(names());
      blindWorld.run(arguments, Optional.of(text), line -> {});
      TextFile.write(folder.resolve("scores.txt"), Files.readString(text));
      scores = CheckScores.read(file);
      CheckReport.write(folder, order, scores);
      if (!allPages) {
        dropPages(scores);
      }
      CheckSummary.lines(scores).forEach(out::println);
      scores.missingPredictions().ifPresent(out::println);
    }
    log("scored");
    out.println();
    out.println("written to " + folder + " (open " + folder.resolve(CheckReport.PAGE) + ")");
    return scores;
  }

  /**
   * Has what the answers propose measured in the sealed worlds, diagnosed again, and scored.
   *
   * @param who does it
   * @param limit after which a case is given up
   * @param scores of the answers that propose it
   * @return the cases that have no answer with the readings that were proposed
   * @throws DataFormatException when a truth or a data set is not the one that was committed to
   */
  List<String> next(WorkersOption who, Duration limit, CheckScores scores)
      throws IOException, DataFormatException, InterruptedException {
    BlindNext next = new BlindNext(folder, blindWorld);
    if (order.source() instanceof Drawn drawn) {
      next.measure(drawing(drawn));
    } else if (order.source() instanceof Benchmark benchmark) {
      next.measure(drawing(benchmark));
    }
    List<String> unanswered = diagnose(who, limit, next.world(), next.answers());
    next.score(names(), out);
    CheckReport.write(folder, order, scores, ToldApart.read(next.table()));
    log("scored next experiments");
    return unanswered;
  }

  /** Which names the scorer takes for known: jars may have brought some it has not heard of. */
  private List<String> names() {
    List<String> arguments = new ArrayList<>(List.of("--known", String.join(",", effects())));
    addWithheld(arguments);
    return arguments;
  }

  /** Of a right answer the scores say all; thousands of pages would fill a disk unread. */
  private void dropPages(CheckScores scores) throws IOException {
    for (JsonNode one : scores.cases()) {
      if (one.path("right").asBoolean()) {
        Path answer = answers.resolve(one.path("case").asText());
        Files.deleteIfExists(answer.resolve(DiagnosisReport.PAGE));
      }
    }
  }

  /** Has the baseline's answers given, unless they are already. */
  private void answerByRule(Path baseline)
      throws IOException, DataFormatException, InterruptedException {
    if (Files.exists(baseline)) {
      return;
    }
    try (StagedDirectory staged = StagedDirectory.beside(baseline)) {
      blindWorld.run(
          List.of(
              "baseline",
              "--cases",
              world.resolve("cases").toString(),
              "--rows",
              world.resolve("rows").toString(),
              "--out",
              staged.path().toString()),
          Optional.empty(),
          line -> {});
      staged.publish();
    }
  }

  /** Times stand in this file only, so that all others are the same each time. */
  private void log(String line) throws IOException {
    Path log = folder.resolve("run.log");
    try {
      Files.writeString(
          log,
          Instant.now() + " " + line + "\n",
          StandardOpenOption.CREATE,
          StandardOpenOption.APPEND);
    } catch (IOException e) {
      throw WholeFile.naming(log, e);
    }
  }
}
