package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import simbad.gap.constants.FittedConstants;
import simbad.gap.unexplained.Constants;
import simbad.gap.unexplained.LawConstants;
import simbad.gap.unexplained.ThresholdConstants;
import simbad.sonar.scene.SensorLaw;

/**
 * Fits the constants that decide to finished checks, and writes them with where they come from. A
 * law of which there are few cases keeps its own. {@code benchmarks/fit-constants} draws the
 * worlds, has them diagnosed and calls it.
 */
public final class FitConstants {
  private static final int FOLDS = 5;

  /** Of fewer cases nothing is learnt. */
  private static final int LEAST_CASES = 50;

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
    List<String> checks = Arrays.asList(arguments).subList(2, arguments.length);
    ConstantsFile file = new ConstantsFile("simbad-constants/2");
    JsonNode known = FittedConstants.of(Constants.class);
    for (SensorLaw.Model law : SensorLaw.Model.values()) {
      List<CheckedCase> cases = new ArrayList<>();
      ConstantsFile.Origin origin =
          new ConstantsFile.Origin("benchmarks/fit-constants", arguments[1]);
      for (String check : checks) {
        List<CheckedCase> own =
            CheckedCase.read(Path.of(check)).stream().filter(c -> isUnder(law, c)).toList();
        cases.addAll(own);
        origin.add(Path.of(check), own.size());
      }
      if (cases.size() < LEAST_CASES) {
        System.out.printf(
            Locale.ROOT,
            "%s: %d cases, too few: it keeps its constants%n",
            law.word(),
            cases.size());
        file.root().set(law.word(), known.path(law.word()));
        continue;
      }
      cases.sort(Comparator.comparing(CheckedCase::name));
      fit(file.root().putObject(law.word()), origin, cases, law);
    }
    file.write(Path.of(arguments[0]));
  }

  private static boolean isUnder(SensorLaw.Model law, CheckedCase one) {
    return one.isLevel() == (law == SensorLaw.Model.LEVEL);
  }

  private static void fit(
      ObjectNode node, ConstantsFile.Origin origin, List<CheckedCase> cases, SensorLaw.Model law) {
    ConstantsFit fit = new ConstantsFit(Constants.own());
    figures(origin.node().putObject("unknown_held_out"), cases, fit, law);
    node.set("origin", origin.node());
    LawConstants fitted = fit.of(cases).under(law);
    ObjectNode unknown = node.putObject("unknown");
    if (fitted instanceof ThresholdConstants bounded) {
      unknown.put("least", bounded.least());
      unknown.put("most", ConstantsFile.rounded(bounded.most()));
    }
    ConstantsFile.put(unknown, fitted.weights());
    node.put("temperature", ConstantsFile.rounded(fitted.temperature()));
    node.put("named_rightly", ConstantsFile.rounded(fitted.namedRightly()));
  }

  /** How well it does on cases that it was not fitted on, beside the former constants. */
  private static void figures(
      ObjectNode node, List<CheckedCase> all, ConstantsFit fit, SensorLaw.Model law) {
    LawConstants former = Constants.own().under(law);
    double[] before = new double[all.size()];
    double[] after = new double[all.size()];
    for (int fold = 0; fold < FOLDS; fold++) {
      List<CheckedCase> rest = new ArrayList<>();
      for (int i = 0; i < all.size(); i++) {
        if (i % FOLDS != fold) {
          rest.add(all.get(i));
        }
      }
      LawConstants fitted = fit.of(rest).under(law);
      for (int i = fold; i < all.size(); i += FOLDS) {
        before[i] = former.unknown(all.get(i).signs());
        after[i] = fitted.unknown(all.get(i).signs());
      }
    }
    score(node.putObject("former"), all, before);
    score(node.putObject("fitted"), all, after);
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
    System.out.printf(Locale.ROOT, "%s%n", node);
  }
}
