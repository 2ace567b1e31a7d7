package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.file.Output;
import simbad.blindworld.score.Answer;
import simbad.blindworld.score.Answers;
import simbad.blindworld.score.NextScores;
import simbad.blindworld.score.Proposal;
import simbad.blindworld.score.Truth;
import simbad.blindworld.score.Truths;

/** {@code next --truth DIR --answers DIR --again DIR ...}: scores what answers propose. */
final class NextCommand {

  private static final List<String> OPTIONS =
      List.of("--truth", "--answers", "--again", "--manifest", "--withheld", "--known", "--out");

  private NextCommand() {}

  static void run(String[] arguments, PrintStream out) throws FormatException, IOException {
    Options options = new Options(arguments, OPTIONS);
    Path first = Path.of(options.required("--answers"));
    Answers before = new Answers(first);
    Answers after = new Answers(Path.of(options.required("--again")));
    // Answers are hashed before any truth is opened.
    String hashes = before.hash() + ", then " + after.hash();
    Path manifest = Path.of(options.required("--manifest"));
    Truths folder = ScoreCommand.truths(options);
    int verified = folder.verify(manifest);
    List<Truth> truths = folder.read();
    Map<String, Proposal> proposals = Proposal.read(first, truths);
    Map<String, Answer> answers = before.read(truths);
    boolean waves = JsonObject.read(manifest).fields().getOrDefault("worlds", "").equals("wave");
    NextScores scores = new NextScores(truths, waves, proposals, answers, after.read(truths));
    out.println("commitments: " + verified + " verified; answers sealed as " + hashes);
    out.print(scores.text());
    Output.write(Path.of(options.required("--out")), scores.csv());
  }
}
