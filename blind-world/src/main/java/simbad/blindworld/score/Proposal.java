package simbad.blindworld.score;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import simbad.blindworld.check.Checks;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;

/**
 * What an answer says should be measured next.
 *
 * @param separates the effects that shall come apart, two or more
 * @param expectedLogOdds nats that it is said to bring; may be infinite
 */
public record Proposal(List<String> separates, double expectedLogOdds) {

  private static final String NEXT = "next_experiment";
  private static final String ODDS = "expected_log_odds";

  /** Copies the list and refuses what is no such thing. */
  public Proposal {
    Checks.number("expected log odds", expectedLogOdds);
    separates = List.copyOf(separates);
  }

  /**
   * The proposals of answers, by case; cases whose answer proposes nothing are left out.
   *
   * @param answers a folder for each case with diagnosis.json
   * @param truths the cases
   * @throws FormatException for a proposal that does not keep to its format
   */
  public static Map<String, Proposal> read(Path answers, List<Truth> truths)
      throws IOException, FormatException {
    Map<String, Proposal> proposals = new HashMap<>();
    for (Truth truth : truths) {
      Path file = answers.resolve(truth.id()).resolve("diagnosis.json");
      if (Files.isRegularFile(file)) {
        JsonObject json = JsonObject.read(file);
        if (json.has(NEXT)) {
          proposals.put(truth.id(), read(json.object(NEXT)));
        }
      }
    }
    return proposals;
  }

  private static Proposal read(JsonObject json) throws FormatException {
    // What is greater than every number has no JSON.
    double odds = json.has(ODDS) ? json.number(ODDS) : Double.POSITIVE_INFINITY;
    List<String> separates = json.texts("separates");
    if (separates.size() < 2) {
      throw new FormatException(json.where() + ", separates: expected two effects or more");
    }
    return new Proposal(separates, odds);
  }
}
