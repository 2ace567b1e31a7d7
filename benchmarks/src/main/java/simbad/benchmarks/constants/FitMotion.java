package simbad.benchmarks.constants;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import simbad.gap.diagnosis.Verdict;
import simbad.gap.motion.MotionConstants;

/**
 * Fits the constants that say how sure a diagnosis of motion is to finished checks, and writes them
 * with where they come from. {@code benchmarks/fit-motion} draws the worlds, has them diagnosed and
 * calls it.
 */
public final class FitMotion {
  private static final int FOLDS = 5;

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
    ConstantsFile file = new ConstantsFile("simbad-motion-constants/1");
    ConstantsFile.Origin origin = new ConstantsFile.Origin("benchmarks/fit-motion", arguments[1]);
    file.root().set("origin", origin.node());
    for (String check : Arrays.asList(arguments).subList(2, arguments.length)) {
      List<CheckedDrive> cases = CheckedDrive.read(Path.of(check));
      all.addAll(cases);
      origin.add(Path.of(check), cases.size());
    }
    // Names of cases are drawn, so their order has nothing to do with what they are.
    all.sort(Comparator.comparing(CheckedDrive::name));
    ObjectNode heldOut = origin.node().putObject("held_out");
    figures(heldOut, all, MotionFit.heldOut(all, FOLDS));
    System.out.println(heldOut.toPrettyString());
    MotionConstants fitted = MotionFit.of(all);
    ConstantsFile.put(file.root().putObject("none"), fitted.none());
    ConstantsFile.put(file.root().putObject("unexplained"), fitted.unexplained());
    ConstantsFile.put(file.root().putObject("named_rightly"), fitted.namedRightly());
    ConstantsFile.put(file.root(), Map.of("other_drive", fitted.otherDrive()));
    file.write(Path.of(arguments[0]));
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
    node.put("verdict_mean_log_score", ConstantsFile.rounded(log / all.size()));
    node.put("verdict_calibration_error", ConstantsFile.rounded(CalibrationError.of(said, right)));
    node.put("names", named);
    node.put("name_mean_log_score", ConstantsFile.rounded(names / named));
    node.put("other_drives", drives);
    node.put("other_drives_held", held);
  }
}
