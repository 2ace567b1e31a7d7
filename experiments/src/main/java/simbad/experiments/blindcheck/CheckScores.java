package simbad.experiments.blindcheck;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.sonar.check.Checks;
import simbad.sonar.format.DataFormatException;

/**
 * What the scorer says of a check.
 *
 * @param document the scorer's JSON, format "blind-scores/1"
 */
public record CheckScores(ObjectNode document) {
  /** The scorer's name for the answers that are checked. */
  public static final String DIAGNOSIS = "diagnosis";

  /** In the page's columns: what is checked, and the two that it is measured by. */
  public static final List<String> SORTS = List.of(DIAGNOSIS, "baseline", "oracle");

  private static final String FORMAT = "blind-scores/1";

  /** Reads the scorer's file. */
  public static CheckScores read(Path file) throws IOException, DataFormatException {
    try {
      JsonNode document = JsonMapper.builder().build().readTree(Files.readString(file));
      if (document instanceof ObjectNode object
          && FORMAT.equals(object.path("format").asText())
          && object.path("scores").isObject()) {
        return new CheckScores(object);
      }
    } catch (JsonProcessingException e) {
      // Said below, as for JSON that is something else.
    }
    throw DataFormatException.inFile(file, "not the scores of a check, expected " + FORMAT);
  }

  /**
   * The figures of one sort of answers on one part of the cases.
   *
   * @param part the part's name, which states the level of independence
   * @param sort of answers
   * @param figures the scorer's
   */
  public record Figures(String part, String sort, JsonNode figures) {
    /** Returns how many cases these figures are of. */
    public int cases() {
      return figures.path("cases").asInt();
    }

    /** A share with its interval; nothing where no case asks for it. */
    public Optional<Estimate> share(String name) {
      JsonNode share = figures.path("shares").path(name);
      return share.path("of").asInt() == 0
          ? Optional.empty()
          : Optional.of(
              new Estimate(
                  share.path("share").asDouble(),
                  share.path("low95").asDouble(),
                  share.path("high95").asDouble(),
                  share.path("hits").asInt() + " of " + share.path("of").asInt()));
    }

    /** Returns stated probabilities against what was so; no bins where there are no claims. */
    public StatedProbabilities calibration(String name) {
      return StatedProbabilities.of(figures.path(name));
    }

    /** A median with its interval; nothing where nothing was counted. */
    public Optional<Estimate> median(String name) {
      JsonNode spread = figures.path(name);
      return spread.path("n").asInt() == 0
          ? Optional.empty()
          : Optional.of(
              new Estimate(
                  spread.path("median").asDouble(),
                  spread.path("low95").asDouble(),
                  spread.path("high95").asDouble(),
                  "n = " + spread.path("n").asInt()));
    }

    /** Of unknown_probability; nothing where one of the two groups is empty. */
    public Optional<Estimate> auroc() {
      JsonNode unknown = figures.path("unknown");
      int strange = unknown.path("unknown_cases").asInt();
      int known = unknown.path("known_cases").asInt();
      return strange == 0 || known == 0
          ? Optional.empty()
          : Optional.of(
              new Estimate(
                  unknown.path("auroc").asDouble(),
                  unknown.path("auroc_low95").asDouble(),
                  unknown.path("auroc_high95").asDouble(),
                  strange + " against " + known));
    }

    /** The share of right answers of each kind of case, averaged; nothing in older scores. */
    public Optional<Estimate> classMean() {
      return StatedProbabilities.estimate(figures, "class_mean", cases());
    }

    /** The mean probability on what is so; nothing in older scores. */
    public Optional<Estimate> probabilityOfTruth() {
      return StatedProbabilities.estimate(figures, "probability_of_truth", cases());
    }

    /** Of the probabilities of the three verdicts; nothing without an interval. */
    public Optional<Estimate> verdictLogScore() {
      return StatedProbabilities.estimate(figures, "verdict_log_score_better_by", cases());
    }
  }

  /** A figure with its 95 % interval and what it was counted from. */
  public record Estimate(double value, double low, double high, String counted) {
    /** Checks that all are numbers. */
    public Estimate {
      Checks.number("value", value);
      Checks.number("low", low);
      Checks.number("high", high);
    }
  }

  /** All figures, part by part, the whole before its parts. */
  public List<Figures> figures() {
    List<Figures> figures = new ArrayList<>();
    for (var part : document.path("scores").properties()) {
      for (var sort : part.getValue().properties()) {
        figures.add(new Figures(part.getKey(), sort.getKey(), sort.getValue()));
      }
    }
    return figures;
  }

  /** The parts' names, the whole before its parts. */
  public List<String> parts() {
    return figures().stream().map(Figures::part).distinct().toList();
  }

  /** The figures of a sort of answers; nothing when it was not scored. */
  public Optional<Figures> figures(String part, String sort) {
    return figures().stream()
        .filter(figures -> figures.part().equals(part) && figures.sort().equals(sort))
        .findFirst();
  }

  /** Each case by itself. */
  public List<JsonNode> cases() {
    List<JsonNode> cases = new ArrayList<>();
    document.path("cases").forEach(cases::add);
    return cases;
  }

  /** How many cases were verified against their commitments, in the scorer's words. */
  public String commitments() {
    return document.path("commitments").asText();
  }

  /** A line that says so when some answers came without predictions. */
  public Optional<String> missingPredictions() {
    String said = document.path("predictions").asText();
    String[] words = said.split(" ", -1);
    return words.length < 3 || words[0].equals(words[2])
        ? Optional.empty()
        : Optional.of(
            "predictions are missing: "
                + words[0]
                + " of "
                + words[2]
                + " answers have them, and shrinkage is scored of these only");
  }

  /** The hash over all answers that was taken before a truth was opened. */
  public String answersSha256() {
    return document.path("answers_sha256").asText();
  }
}
