package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import simbad.gap.constants.FittedConstants;
import simbad.gap.score.IntervalWidths;

/**
 * Fits how much wider intervals of values have to be than a likelihood says to finished checks, and
 * writes it with where it comes from. {@code benchmarks/fit-intervals} draws the worlds, has them
 * diagnosed and calls it.
 */
public final class FitIntervals {
  /** Half widths of an interval of 90 %, where 1 is one of 95 %. */
  private static final double OF_90 = 1.6449 / 1.96;

  private static final double HELD = 0.9;

  /** Of fewer values nothing is learnt. */
  private static final int LEAST_VALUES = 40;

  private FitIntervals() {}

  /**
   * Fits and writes. The checks must be of a program with today's widths. What is not given keeps
   * its width and its origin.
   *
   * @param arguments the file to write, the date that it shall say, and for some of threshold,
   *     level and motion a word and folders of checks: {@code threshold=L1 level=L2,L2w motion=M}
   * @throws IOException if a file cannot be read or written
   */
  public static void main(String[] arguments) throws IOException {
    if (arguments.length < 3) {
      throw new IllegalArgumentException("give OUT.json DATE NAME=CHECK[,CHECK...]...");
    }
    ConstantsFile file = new ConstantsFile(IntervalWidths.FORMAT);
    ConstantsFile.Origin origin =
        new ConstantsFile.Origin("benchmarks/fit-intervals", arguments[1]);
    file.root().set("origin", origin.node());
    IntervalWidths own = IntervalWidths.own();
    file.root().put("threshold", own.threshold());
    file.root().put("level", own.level());
    file.root().put("motion", own.motion());
    ObjectNode figures = origin.node().putObject("narrowed_to_90_percent");
    keep(FittedConstants.of(IntervalWidths.class).path("origin"), origin, figures, arguments);
    for (String group : Arrays.asList(arguments).subList(2, arguments.length)) {
      String[] parts = group.split("=", 2);
      if (parts.length != 2 || !file.root().has(parts[0])) {
        throw new IllegalArgumentException(
            group + ": expected threshold=, level= or motion= and folders");
      }
      List<Double> off = new ArrayList<>();
      for (String check : parts[1].split(",", -1)) {
        List<Double> more = halfWidths(Path.of(check));
        off.addAll(more);
        origin.add(Path.of(check), more.size()).put("of", parts[0]);
      }
      fit(file.root(), figures.putObject(parts[0]), parts[0], off);
    }
    file.write(Path.of(arguments[0]));
  }

  /** Keeps the origin of widths that are not fitted now. */
  private static void keep(
      JsonNode before, ConstantsFile.Origin origin, ObjectNode figures, String... arguments) {
    for (String name : List.of("threshold", "level", "motion")) {
      if (Arrays.stream(arguments).noneMatch(one -> one.startsWith(name + "="))) {
        figures.set(name, before.path("narrowed_to_90_percent").path(name));
        before.path("checks").forEach(check -> keep(check, name, origin));
      }
    }
  }

  private static void keep(JsonNode check, String name, ConstantsFile.Origin origin) {
    if (name.equals(check.path("of").asText())) {
      origin.keep(check);
    }
  }

  private static void fit(ObjectNode root, ObjectNode figures, String name, List<Double> off) {
    double before = root.path(name).asDouble();
    figures.put("values", off.size());
    figures.put("held_before", ConstantsFile.rounded(held(off, 1)));
    if (off.size() >= LEAST_VALUES) {
      double wider = wider(off);
      root.put(name, ConstantsFile.rounded(before * wider));
      figures.put("held_after", ConstantsFile.rounded(held(off, wider)));
    }
    System.out.printf(Locale.ROOT, "%s: %s, %s%n", name, root.path(name), figures);
  }

  /** Returns by what intervals have to be wider for nine in ten of 90 % to hold the true value. */
  static double wider(List<Double> off) {
    List<Double> sorted = new ArrayList<>(off);
    Collections.sort(sorted);
    return sorted.get((int) Math.ceil(HELD * sorted.size()) - 1) / OF_90;
  }

  private static double held(List<Double> off, double wider) {
    long in = off.stream().filter(one -> one <= OF_90 * wider * (1 + 1e-12)).count();
    return off.isEmpty() ? 0 : (double) in / off.size();
  }

  /** Reads how far true values of a check are off: of all its cases, which stand first. */
  static List<Double> halfWidths(Path check) throws IOException {
    Path file = check.resolve("check.json");
    JsonNode parts = new ObjectMapper().readTree(Files.readString(file)).path("scores");
    JsonNode first = parts.isEmpty() ? parts : parts.iterator().next();
    JsonNode widths = first.path("diagnosis").path("parameter_half_widths");
    if (!widths.isArray()) {
      throw new IOException(
          file + ": parameter_half_widths: not there; a check of an older program");
    }
    List<Double> off = new ArrayList<>();
    widths.forEach(one -> off.add(one.asDouble()));
    return off;
  }
}
