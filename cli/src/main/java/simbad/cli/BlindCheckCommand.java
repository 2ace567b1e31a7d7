package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.experiments.blindcheck.CheckOrder;
import simbad.experiments.blindcheck.CheckOrder.Benchmark;
import simbad.experiments.blindcheck.CheckOrder.Drawn;
import simbad.experiments.blindcheck.CheckOrder.Foreign;
import simbad.experiments.blindcheck.CheckScores;
import simbad.sonar.effect.Definitions;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OneLine;

/** {@code simbad blind-check}: the withheld check of the diagnosis. */
@Command(
    name = "blind-check",
    description = {
      "Check the diagnosis on data sets whose truth it never sees.",
      "One program draws truths, seals them with salted SHA-256 and writes data sets. "
          + "A second one diagnoses these in a folder that holds nothing else. A third one "
          + "verifies the seals and scores the answers.",
      "The same command continues where the last call ended."
    },
    footer = {
      "",
      "Exit status: 0 all cases were answered, right or wrong; 1 some were not, or "
          + "the work failed; 2 bad usage or input, such as a truth that was changed after "
          + "it was sealed.",
      "",
      "Example: simbad blind-check --out check",
      "Example: simbad blind-check --cases 1000 --seed 7 --off --out check-off",
      "Example: simbad blind-check --level wave --cases 200 --seed 7 --out check-wave",
      "Example: simbad blind-check --motion --cases 100 --seed 7 --out check-motion",
      "Example: simbad blind-check --withhold latency --out check-latency",
      "Example: simbad blind-check --cases 1000 --seed 7 --spark spark://host:7077 --out"
          + " check-spark",
      "Example: simbad blind-check --cases 8 --audit-only --out check-audit",
      "Example: simbad blind-check --cases 150 --seed 7 --next --out check-next",
      "Example: simbad blind-check --benchmark L2w --first 50 --out check-benchmark",
      "Example: simbad blind-check --foreign their-data --level 'L3, a bench' --out check-theirs"
    })
final class BlindCheckCommand extends Subcommand {
  private static final int MOST_CASES = 100_000;
  private static final int DEFAULT_CASES = 40;
  private static final double DEFAULT_REFERENCES = 0.3;
  private static final double MOST_LIMIT_S = 1e6;
  private static final String WAVE = "wave";

  private static final String MOTION = "motion";

  /** Of the benchmark SRB-1, as blind-world calls them. */
  private static final List<String> PARTS = List.of("L1", "L2", "L2w", MOTION);

  @Option(
      names = "--out",
      paramLabel = "DIR",
      required = true,
      description = "A folder for everything: a new one, or the folder of a check that was begun.")
  private Path out = Path.of("");

  @Option(
      names = "--cases",
      paramLabel = "N",
      description = "Number of cases to draw. Default: 40.")
  private @Nullable Integer cases;

  @Option(
      names = "--seed",
      paramLabel = "N",
      description =
          "Seed of all random numbers. A check whose truths were opened is no longer"
              + " blind. Default: 1.")
  private @Nullable Long seed;

  @Option(
      names = "--reference",
      paramLabel = "SHARE",
      description =
          "Share of cases with a set-up that is itself a little off, and with a "
              + "reference (level L2). Default: 0.3.")
  private @Nullable Double reference;

  @Option(
      names = "--off",
      description =
          "Every case has a set-up that is a little off, and a reference; the same as "
              + "--reference 1.")
  private boolean off;

  @Option(
      names = "--withhold",
      paramLabel = "EFFECT",
      completionCandidates = EffectWords.class,
      split = ",",
      description =
          "Leave-one-out: the diagnosis does not know these effects and must call their "
              + "data unexplained. Two of five cases hold one.")
  private List<String> withhold = List.of();

  @Option(
      names = "--mix",
      paramLabel = "KIND:WEIGHT",
      split = ",",
      description = "Weights of the kinds none, single, pair, unknown and withheld.")
  private List<String> mix = List.of();

  @Option(
      names = "--effects",
      paramLabel = "EFFECT",
      split = ",",
      description = "Draw only these effects, known to the diagnosis or not.")
  private List<String> effects = List.of();

  @Option(
      names = "--rows",
      paramLabel = "MIN-MAX",
      description = "Number of rows of a data set. Default: 2000-4500; with --level wave 700-2500.")
  private @Nullable String rows;

  @Option(
      names = "--sizes",
      paramLabel = "MIN-MAX",
      description =
          "Sizes of the effects that are put in; 1 is a practical size. With this option "
              + "a case is kept even if its effect does not show. Default: 0.5-2, and the "
              + "effect shows.")
  private @Nullable String sizes;

  @Option(
      names = "--benchmark",
      paramLabel = "PART",
      description =
          "Draw a part of the benchmark SRB-1: L1, L2, L2w or motion. Its cases are "
              + "fixed to the byte.")
  private @Nullable String benchmark;

  @Option(
      names = "--first",
      paramLabel = "N",
      description =
          "With --benchmark: only the first N cases of the part. They are a random "
              + "sample of it.")
  private @Nullable Integer first;

  @Option(
      names = "--practice",
      paramLabel = "SEED",
      description =
          "With --benchmark and --first: cases of the same kind, drawn by this seed, that "
              + "are none of the benchmark. To tune a program on.")
  private @Nullable Integer practice;

  @Option(
      names = "--foreign",
      paramLabel = "DIR",
      description =
          "Draw nothing. Take the data sets in this folder, each with truth.json and "
              + "sealed.csv.")
  private @Nullable Path foreign;

  @Option(
      names = "--level",
      paramLabel = "TEXT",
      description =
          "Without --foreign: wave, for worlds of waves (level L2w), each with a "
              + "reference. With --foreign: the level of independence, which is printed beside "
              + "every figure.")
  private @Nullable String level;

  @Option(
      names = "--motion",
      description =
          "Draw drives of robots that a tracker sees, not sonars: level M1, or M2 with a "
              + "reference.")
  private boolean motion;

  @Option(
      names = "--seconds",
      paramLabel = "MIN-MAX",
      description = "With --motion: how long each robot drives. Default: 120-600.")
  private @Nullable String seconds;

  @Option(
      names = "--limit",
      paramLabel = "S",
      description = "Give up a case after this many seconds without an answer. Default: 600.")
  private double limitS = 600;

  @Option(
      names = "--all-pages",
      description = "Keep every case's report.html. Default: only those of wrong answers.")
  private boolean allPages;

  @Option(
      names = "--audit-only",
      description =
          "Diagnose nothing. Count the false warnings of the audit, and the faults it "
              + "finds among those put into clean cases.")
  private boolean auditOnly;

  @Option(
      names = "--next",
      description =
          "After the check: where an answer proposes what to measure next, measure it in the "
              + "sealed world, diagnose again, and say how often the tied effects were told apart.")
  private boolean next;

  @ArgGroup private WorkersOption who = new WorkersOption();

  @Override
  protected void run() throws Exception {
    if (!(limitS > 0 && limitS <= MOST_LIMIT_S)) {
      throw wrongUsage("--limit: " + limitS + " is not in (0, " + MOST_LIMIT_S + "] s");
    }
    checkNext();
    CheckOrder order = order();
    if (who.isDoneElsewhere(this)) {
      return;
    }
    if (Files.exists(out) && !BlindCheck.mayStandIn(out)) {
      throw wrongUsage("--out: " + out + " is neither empty nor the folder of a check");
    }
    BlindCheck check = new BlindCheck(out, order, out(), err());
    check.begin();
    check.seal();
    if (auditOnly) {
      check.audit();
      return;
    }
    Duration limit = Duration.ofMillis((long) (1000 * limitS));
    List<String> unanswered = new ArrayList<>(check.diagnose(who, limit));
    CheckScores scores = check.score(allPages);
    if (next) {
      check.next(who, limit, scores).forEach(id -> unanswered.add(id + " (with what it proposed)"));
    }
    if (!unanswered.isEmpty()) {
      throw new IOException(
          unanswered.size()
              + " without an answer, which counts as wrong: "
              + String.join(" ", unanswered));
    }
  }

  private CheckOrder order() throws IOException, DataFormatException {
    for (String word : withhold) {
      if (Definitions.find(word).isEmpty()) {
        throw wrongUsage("--withhold: " + EffectWords.unknown(word));
      }
    }
    if (benchmark != null) {
      return new CheckOrder(BuildVersion.text(), benchmark(benchmark), List.of());
    }
    if (first != null || practice != null) {
      throw wrongUsage(
          (first != null ? "--first" : "--practice") + ": expected --benchmark with it");
    }
    if (foreign == null) {
      return new CheckOrder(BuildVersion.text(), drawn(), withhold);
    }
    boolean drawing =
        Stream.of(cases, seed, reference, rows, seconds, sizes).anyMatch(option -> option != null)
            || off
            || motion
            || !mix.isEmpty()
            || !effects.isEmpty();
    if (drawing) {
      throw wrongUsage(
          "--foreign: nothing is drawn, so options that say what to draw do not go with it");
    }
    if (level != null && !OneLine.isName(level)) {
      throw wrongUsage(
          "--level: '"
              + level
              + "' is not a text of at most "
              + OneLine.LONGEST_NAME
              + " characters on one line");
    }
    if (!Files.isDirectory(foreign)) {
      throw DataFormatException.inFile(foreign, "no such folder");
    }
    return new CheckOrder(
        BuildVersion.text(), new Foreign(foreign.toString(), Optional.ofNullable(level)), withhold);
  }

  private void checkNext() {
    if (next && (motion || foreign != null || MOTION.equalsIgnoreCase(benchmark))) {
      throw wrongUsage("--next: only worlds with sonars that were drawn here are measured again");
    }
    if (next && auditOnly) {
      throw wrongUsage("--audit-only: nothing is diagnosed, expected no --next");
    }
  }

  private Benchmark benchmark(String part) {
    boolean drawing =
        Stream.of(cases, reference, rows, seconds, sizes, level, foreign)
                .anyMatch(option -> option != null)
            || off
            || motion
            || !mix.isEmpty()
            || !effects.isEmpty()
            || !withhold.isEmpty();
    if (drawing) {
      throw wrongUsage(
          "--benchmark: its cases are fixed, expected no option that says what to draw");
    }
    String known =
        PARTS.stream()
            .filter(part::equalsIgnoreCase)
            .findFirst()
            .orElseThrow(
                () ->
                    wrongUsage(
                        "--benchmark: '" + part + "', expected " + String.join(", ", PARTS)));
    if (auditOnly && known.equals(MOTION)) {
      throw wrongUsage("--audit-only: the audit that is counted is of readings, not of motion");
    }
    if (practice != null && (first == null || seed != null)) {
      throw wrongUsage("--practice: expected --first with it, and no --seed");
    }
    return new Benchmark(
        known,
        Optional.ofNullable(first),
        Optional.ofNullable(seed),
        Optional.ofNullable(practice));
  }

  private Drawn drawn() {
    checkMotion();
    if (level != null && !level.equals(WAVE)) {
      throw wrongUsage(
          "--level: '" + level + "' is not " + WAVE + "; another level goes with --foreign");
    }
    if (level != null && (off || reference != null)) {
      throw wrongUsage(
          "--level wave: every case has a reference, expected no --reference or --off");
    }
    if (off && reference != null) {
      throw wrongUsage("--off and --reference exclude each other");
    }
    int count = cases == null ? DEFAULT_CASES : cases;
    if (!(count >= 1 && count <= MOST_CASES)) {
      throw wrongUsage("--cases: " + count + " is not in [1, " + MOST_CASES + "]");
    }
    double share = off ? 1 : reference == null ? DEFAULT_REFERENCES : reference;
    if (!(share >= 0 && share <= 1)) {
      throw wrongUsage("--reference: " + share + " is not in [0, 1]");
    }
    return new Drawn(count, seed == null ? 1 : seed, share, passedOn());
  }

  private void checkMotion() {
    if (motion && (level != null || auditOnly || !withhold.isEmpty() || rows != null)) {
      throw wrongUsage(
          "--motion: --level, --rows, --withhold and --audit-only are for sonars, "
              + "expected none of them");
    }
    if (!motion && seconds != null) {
      throw wrongUsage("--seconds: expected --motion with it");
    }
  }

  /** What only the worlds' own program understands. */
  private List<String> passedOn() {
    List<String> options = new ArrayList<>();
    if (motion) {
      options.addAll(List.of("--level", MOTION));
    }
    if (seconds != null) {
      options.addAll(List.of("--seconds", seconds));
    }
    if (level != null) {
      options.addAll(List.of("--level", level));
    }
    if (sizes != null) {
      options.addAll(List.of("--sizes", sizes));
    }
    if (!mix.isEmpty()) {
      options.addAll(List.of("--mix", String.join(",", mix)));
    }
    if (!effects.isEmpty()) {
      options.addAll(List.of("--effects", String.join(",", effects)));
    }
    if (rows != null) {
      options.addAll(List.of("--rows", rows));
    }
    return options;
  }
}
