package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import simbad.gap.unexplained.Constants;

/**
 * Fits the constants that decide to finished checks, and writes them with where they come from.
 * {@code benchmarks/fit-constants} draws the worlds, has them diagnosed and calls it.
 */
public final class FitConstants {
  private static final int FOLDS = 5;

  private FitConstants() {}

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
    List<CheckedCase> all = new ArrayList<>();
    ConstantsFile file =
        new ConstantsFile("simbad-constants/1", "benchmarks/fit-constants", arguments[1]);
    for (String check : Arrays.asList(arguments).subList(2, arguments.length)) {
      List<CheckedCase> cases = CheckedCase.read(Path.of(check));
      all.addAll(cases);
      file.add(Path.of(check), cases.size());
    }
    all.sort(Comparator.comparing(CheckedCase::name));
    ConstantsFit fit = new ConstantsFit(Constants.own());
    figures(file.origin(), all, fit);
    constants(file.root(), fit.of(all));
    file.write(Path.of(arguments[0]));
  }

  /** How well it does on cases that it was not fitted on, beside the former constants. */
  private static void figures(ObjectNode origin, List<CheckedCase> all, ConstantsFit fit) {
    double[] before = new double[all.size()];
    double[] after = new double[all.size()];
    for (int fold = 0; fold < FOLDS; fold++) {
      List<CheckedCase> rest = new ArrayList<>();
      for (int i = 0; i < all.size(); i++) {
        if (i % FOLDS != fold) {
          rest.add(all.get(i));
        }
      }
      Constants fitted = fit.of(rest);
      for (int i = fold; i < all.size(); i += FOLDS) {
        before[i] = ConstantsFit.unknown(Constants.own(), all.get(i));
        after[i] = ConstantsFit.unknown(fitted, all.get(i));
      }
    }
    ObjectNode node = origin.putObject("unknown_held_out");
    scores(node.putObject("former"), all, before);
    scores(node.putObject("fitted"), all, after);
  }

  /** Of all cases, and of those that were taken to hear by either law. */
  private static void scores(ObjectNode node, List<CheckedCase> all, double[] probability) {
    score(node, all, probability);
    for (boolean level : new boolean[] {false, true}) {
      int[] own =
          IntStream.range(0, all.size()).filter(i -> all.get(i).isLevel() == level).toArray();
      if (own.length > 0) {
        score(
            node.putObject(level ? "level" : "threshold"),
            IntStream.of(own).mapToObj(all::get).toList(),
            IntStream.of(own).mapToDouble(i -> probability[i]).toArray());
      }
    }
    System.out.printf(Locale.ROOT, "%s%n", node);
  }

  private static void score(ObjectNode node, List<CheckedCase> all, double[] probability) {
    double log = 0;
    boolean[] unknown = new boolean[probability.length];
    for (int i = 0; i < probability.length; i++) {
      unknown[i] = ConstantsFit.isUnknown(all.get(i));
      log += Math.log(unknown[i] ? probability[i] : 1 - probability[i]);
    }
    node.put("mean_log_score", ConstantsFile.rounded(log / probability.length));
    node.put("calibration_error", ConstantsFile.rounded(CalibrationError.of(probability, unknown)));
    node.put("cases", probability.length);
  }

  private static void constants(ObjectNode root, Constants fitted) {
    ObjectNode unknown = root.putObject("unknown");
    unknown.put("least", fitted.least());
    unknown.put("most", ConstantsFile.rounded(fitted.most()));
    unknown.put("base", ConstantsFile.rounded(fitted.base()));
    ConstantsFile.put(unknown, fitted.weights());
    ObjectNode temperature = root.putObject("temperature");
    temperature.put("threshold", ConstantsFile.rounded(fitted.thresholdTemperature()));
    temperature.put("level", ConstantsFile.rounded(fitted.levelTemperature()));
    root.put("named_rightly", ConstantsFile.rounded(fitted.namedRightly()));
  }
}
