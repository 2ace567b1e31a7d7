package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.Json;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Output;
import simbad.blindworld.score.Answers;
import simbad.blindworld.score.CaseParticulars;
import simbad.blindworld.score.Names;
import simbad.blindworld.score.Proportion;
import simbad.blindworld.score.Scoring;
import simbad.blindworld.score.Truth;
import simbad.blindworld.score.Truths;

/** {@code score --truth DIR --answers DIR ...}. */
final class ScoreCommand {

  private static final List<String> OPTIONS =
      List.of("--truth", "--answers", "--manifest", "--withheld", "--known", "--baseline", "--out");

  private ScoreCommand() {}

  static void run(String[] arguments, PrintStream out) throws FormatException, IOException {
    Options options = new Options(arguments, OPTIONS);
    Answers answers = new Answers(Path.of(options.required("--answers")));
    // Answers are hashed before any truth is opened.
    String answersHash = answers.hash();
    Truths folder = truths(options);
    Optional<String> manifest = options.text("--manifest");
    String seal = manifest.isPresent() ? sealed(folder, Path.of(manifest.get())) : "not checked";
    List<Truth> truths = folder.read();
    Optional<Scoring.Origin> origin =
        manifest.isPresent() ? origin(Path.of(manifest.get())) : Optional.empty();
    Scoring scoring = new Scoring(truths, origin);
    scoring.add("diagnosis", answers.read(truths));
    Optional<String> baseline = options.text("--baseline");
    if (baseline.isPresent()) {
      scoring.add("baseline", new Answers(Path.of(baseline.get())).read(truths));
    }
    scoring.add("oracle", folder.oracle(truths));
    scoring.addParticulars("diagnosis", particulars(options).read(truths));
    out.println("commitments: " + seal + "; answers sealed as " + answersHash);
    Proportion predicted = scoring.predictions("diagnosis");
    sayMissing(predicted, out);
    out.print(scoring.text());
    if (options.text("--out").isPresent()) {
      Map<String, Object> json = new LinkedHashMap<>();
      json.put("format", "blind-scores/1");
      json.put("commitments", seal);
      json.put("answers_sha256", answersHash);
      json.put("predictions", predicted.hits() + " of " + predicted.of() + " answers");
      json.put("withheld", options.text("--withheld").orElse(""));
      json.put("scores", scoring.json());
      json.put("cases", scoring.casesJson("diagnosis"));
      Output.write(Path.of(options.required("--out")), Json.write(json));
    }
  }

  /** The truths that options tell of, with what the diagnosis knows and what it was not told. */
  static Truths truths(Options options) throws FormatException {
    Set<String> known = names(options.text("--known"));
    Set<String> withheld = withheld(options.text("--withheld"), known);
    return new Truths(Path.of(options.required("--truth")), withheld, known);
  }

  private static CaseParticulars particulars(Options options) throws FormatException {
    return new CaseParticulars(
        Path.of(options.required("--truth")),
        Path.of(options.required("--answers")),
        options.text("--baseline").map(Path::of),
        options.text("--manifest").map(m -> Path.of(m).toAbsolutePath().resolveSibling("cases")));
  }

  private static void sayMissing(Proportion predicted, PrintStream out) {
    if (predicted.hits() < predicted.of()) {
      out.println(
          "predictions are missing: "
              + predicted.hits()
              + " of "
              + predicted.of()
              + " answers have them, and shrinkage is scored of these only");
    }
  }

  private static Optional<Scoring.Origin> origin(Path manifest)
      throws FormatException, IOException {
    JsonObject json = JsonObject.read(manifest);
    if (json.has("worlds")) {
      return Optional.of(
          json.text("worlds").equals("motion") ? Scoring.Origin.MOTION : Scoring.Origin.WAVE);
    }
    return json.has("level")
        ? Optional.of(Scoring.Origin.foreign(json.text("level")))
        : Optional.empty();
  }

  private static String sealed(Truths folder, Path manifest) throws IOException, FormatException {
    return folder.verify(manifest) + " verified against " + manifest.getFileName();
  }

  private static Set<String> names(Optional<String> text) {
    return text.map(t -> Set.of(t.split(",", -1))).orElse(Set.of());
  }

  private static Set<String> withheld(Optional<String> text, Set<String> known)
      throws FormatException {
    Set<String> names = names(text);
    for (String name : names) {
      if (!Names.contains(name) && !known.contains(name)) {
        throw new FormatException("--withheld: no such effect: " + name);
      }
    }
    return names;
  }
}
