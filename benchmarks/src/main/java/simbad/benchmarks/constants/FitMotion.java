package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.math.BigDecimal;
import java.math.MathContext;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionConstants;
import simbad.sonar.format.WholeFile;

/**
 * Fits the constants that say how sure a diagnosis of motion is to finished checks, and writes them
 * with where they come from. {@code benchmarks/fit-motion} draws the worlds, has them diagnosed and
 * calls it.
 */
public final class FitMotion {
  private static final int FOLDS = 5;
  private static final MathContext DIGITS = new MathContext(4);
  private static final ObjectMapper MAPPER = new ObjectMapper();

  private FitMotion() {}

  /**
   * Fits and writes.
   *
   * @param arguments the file to write, the date that it shall say, and folders of checks
   * @throws IOException if a file cannot be read or written
   */
  public static void main(String[] arguments) throws IOException {
    if (arguments.length < 3) {
      throw new IllegalArgumentException("give OUT.json DATE CHECK...");
    }
    List<CheckedDrive> all = new ArrayList<>();
    ObjectNode root = MAPPER.createObjectNode();
    root.put("format", "simbad-motion-constants/1");
    ObjectNode origin = root.putObject("origin");
    origin.put("how", "benchmarks/fit-motion");
    origin.put("date", arguments[1]);
    ArrayNode checks = origin.putArray("checks");
    for (String check : Arrays.asList(arguments).subList(2, arguments.length)) {
      List<CheckedDrive> cases = CheckedDrive.read(Path.of(check));
      all.addAll(cases);
      ObjectNode node = checks.addObject();
      node.set("order", MAPPER.readTree(Files.readString(Path.of(check, "order.json"))));
      node.put("cases", cases.size());
    }
    // Names of cases are drawn, so their order has nothing to do with what they are.
    all.sort(Comparator.comparing(CheckedDrive::name));
    ObjectNode heldOut = origin.putObject("held_out");
    figures(
        heldOut.putObject("former"), all, Collections.nCopies(all.size(), MotionConstants.own()));
    figures(heldOut.putObject("fitted"), all, MotionFit.heldOut(all, FOLDS));
    System.out.println(heldOut.toPrettyString());
    write(root, MotionFit.of(all));
    String text = MAPPER.writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
    WholeFile.write(Path.of(arguments[0]), text.getBytes(StandardCharsets.UTF_8));
  }

  /** How well constants do, each case by its own. */
  private static void figures(
      ObjectNode node, List<CheckedDrive> all, List<MotionConstants> constants) {
    double log = 0;
    double names = 0;
    int named = 0;
    int held = 0;
    int drives = 0;
    double[] said = new double[all.size()];
    boolean[] right = new boolean[all.size()];
    for (int i = 0; i < all.size(); i++) {
      CheckedDrive one = all.get(i);
      MotionConstants own = constants.get(i);
      log += MotionFit.verdictScore(own, List.of(one));
      names += MotionFit.nameScore(own, List.of(one));
      named += one.names().size();
      said[i] = own.verdict(one.verdict(), one.signs());
      right[i] =
          one.truth() == (one.verdict() == Verdict.PARTLY ? Verdict.UNEXPLAINED : one.verdict());
      if (one.verdict() == Verdict.EXPLAINED && one.otherDrive().isPresent()) {
        drives++;
        held += one.otherDrive().getAsDouble() <= own.otherDrive() ? 1 : 0;
      }
    }
    node.put("cases", all.size());
    node.put("verdict_mean_log_score", rounded(log / all.size()));
    node.put("verdict_calibration_error", rounded(CalibrationError.of(said, right)));
    node.put("names", named);
    node.put("name_mean_log_score", rounded(names / named));
    node.put("other_drives", drives);
    node.put("other_drives_held", held);
  }

  private static void write(ObjectNode root, MotionConstants fitted) {
    weights(root.putObject("none"), fitted.none());
    weights(root.putObject("unexplained"), fitted.unexplained());
    weights(root.putObject("named_rightly"), fitted.namedRightly());
    root.put("other_drive", rounded(fitted.otherDrive()));
  }

  private static void weights(ObjectNode node, Map<String, Double> weights) {
    weights.forEach((name, weight) -> node.put(name, rounded(weight)));
  }

  private static double rounded(double value) {
    return new BigDecimal(value).round(DIGITS).doubleValue();
  }
}
