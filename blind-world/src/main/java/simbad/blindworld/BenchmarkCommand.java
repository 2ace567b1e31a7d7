package simbad.blindworld;

import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import simbad.blindworld.benchmark.Part;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.Seal;
import simbad.blindworld.generate.Generator;
import simbad.blindworld.generate.Order;

/** {@code benchmark --part L1 --out DIR ...}: draws a part of the benchmark SRB-1. */
final class BenchmarkCommand {

  private static final List<String> OPTIONS =
      List.of(
          "--part",
          "--out",
          "--first",
          "--seed",
          "--practice",
          ReadAgain.AT,
          ReadAgain.WORLD,
          Finished.OPTION);
  private static final String FIRST = "first half";
  private static final int MOST_PRACTICE_CASES = 100_000;

  private BenchmarkCommand() {}

  static void run(String[] arguments, PrintStream out, PrintStream err)
      throws FormatException, IOException {
    Options options = new Options(arguments, OPTIONS);
    String name = options.required("--part");
    Part part =
        Part.find(name)
            .orElseThrow(
                () ->
                    new FormatException("--part: '" + name + "', expected L1, L2, L2w or motion"));
    Drawn drawn = drawn(options, part);
    if (ReadAgain.isAsked(options)) {
      ReadAgain.run(options, drawn.order(), err);
      return;
    }
    int first = drawn.first();
    Map<String, Object> said = new LinkedHashMap<>();
    said.put("benchmark", Part.VERSION);
    said.put("part", part.word());
    said.put("drawn", drawn.what());
    said.put("first", first);
    said.put("licence", "CC-BY-4.0");
    String root =
        Generator.make(
            drawn.order(),
            Path.of(options.required("--out")),
            first,
            said,
            new Finished(options, first, err));
    out.println(part + ", " + drawn.what() + ", root " + root);
    if (drawn.isWhole(part) && !part.root().equals(root)) {
      throw new IOException(
          "the root of "
              + part
              + " is "
              + part.root()
              + ": other bytes; this program is not that of the benchmark");
    }
  }

  /**
   * What is drawn.
   *
   * @param order of all cases
   * @param first how many of them are made
   * @param what a word for it
   */
  private record Drawn(Order order, int first, String what) {
    /** True for all of the first half, whose root is known. */
    boolean isWhole(Part part) {
      return what.equals(FIRST) && first == part.cases();
    }
  }

  private static Drawn drawn(Options options, Part part) throws FormatException {
    if (options.text("--practice").isPresent()) {
      if (options.text("--seed").isPresent()) {
        throw new FormatException("--practice: has a seed of its own, expected no --seed");
      }
      int seed = (int) options.number("--practice", 0, 0, Part.MOST_PRACTICE);
      int count = (int) options.number("--first", part.cases(), 1, MOST_PRACTICE_CASES);
      return new Drawn(part.practice(seed, count), count, "practice " + seed);
    }
    int first = (int) options.number("--first", part.cases(), 1, part.cases());
    return options.text("--seed").isPresent()
        ? new Drawn(part.half(secondHalf(options)), first, "second half")
        : new Drawn(part.half(Part.FIRST_HALF), first, FIRST);
  }

  /** The seed of the second half is known by its hash until it is used. */
  private static long secondHalf(Options options) throws FormatException {
    long seed = options.whole("--seed", 0);
    String hash = Seal.sha256(Long.toString(seed).getBytes(StandardCharsets.UTF_8));
    if (!hash.equals(Part.SECOND_HALF_SHA256)) {
      throw new FormatException(
          "--seed: not that of the second half of "
              + Part.VERSION
              + ", expected one whose SHA-256 is "
              + Part.SECOND_HALF_SHA256);
    }
    return seed;
  }
}
