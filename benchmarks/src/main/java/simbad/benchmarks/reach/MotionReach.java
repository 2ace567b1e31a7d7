package simbad.benchmarks.reach;

import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import simbad.gap.motion.MotionDiagnoser;
import simbad.gap.motion.MotionDiagnosis;
import simbad.gap.motion.MotionFinding;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.Way;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.forecast.Window;
import simbad.motion.forecast.Windows;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;

/**
 * How far diagnoses of motion reach on logs of real robots: one half of a log is fitted, the other
 * one scored, and the other way round, beside a linear filter of the last second of commands.
 */
public final class MotionReach {
  private static final int ALONG = 0;
  private static final int TURN = 2;
  private static final int COMPONENTS = 3;

  private final PrintStream out;

  MotionReach(PrintStream out) {
    this.out = out;
  }

  /**
   * Prints a table.
   *
   * @param folders motion folders, one per robot
   * @throws Exception if one cannot be read
   */
  public static void main(String[] folders) throws Exception {
    MotionReach reach = new MotionReach(new PrintStream(System.out, true, StandardCharsets.UTF_8));
    for (String folder : folders) {
      reach.report(new MotionFolder(Path.of(folder)).read(folder));
    }
  }

  /** Reports both halves of the longest run of a log. */
  void report(MotionData data) {
    MotionRun run = longest(data.runs()).withoutRepeats();
    List<TrackPose> track = run.track();
    double middle = (track.get(0).timeS() + track.get(track.size() - 1).timeS()) / 2;
    MotionRun first = part(run, track.stream().filter(pose -> pose.timeS() < middle).toList());
    MotionRun second = part(run, track.stream().filter(pose -> pose.timeS() >= middle).toList());
    report(data, "first half", first, second);
    report(data, "second half", second, first);
  }

  private static MotionRun longest(List<MotionRun> runs) {
    MotionRun longest = runs.get(0);
    for (MotionRun run : runs) {
      longest = run.track().size() > longest.track().size() ? run : longest;
    }
    return longest;
  }

  private static MotionRun part(MotionRun run, List<TrackPose> track) {
    return new MotionRun(run.name(), run.commands(), track);
  }

  private void report(MotionData data, String what, MotionRun fitted, MotionRun other) {
    MotionDiagnosis diagnosis =
        new MotionDiagnoser(new MotionData(data.name(), data.robot(), List.of(fitted), List.of()))
            .diagnose();
    say("%s, fitted on the %s: %s", data.name(), what, diagnosis.verdict().word());
    for (MotionFinding finding : diagnosis.findings()) {
      say("  %s (%.2f)%s", finding.form(), finding.probability(), values(finding));
    }
    MotionForecast forecast = diagnosis.forecast();
    for (int component : new int[] {ALONG, TURN}) {
      compare(data.robot().motion(), forecast.chain(), fitted, other, component);
    }
    say("  within 90 %% forecasts:%s", coverage(forecast, other));
  }

  private static String values(MotionFinding finding) {
    StringBuilder text = new StringBuilder();
    for (MotionFinding.Parameter one : finding.parameters()) {
      text.append(
          String.format(
              Locale.ROOT,
              " %s %.4g [%.4g, %.4g]",
              one.name(),
              one.value(),
              one.ci95().low(),
              one.ci95().high()));
    }
    return text.toString();
  }

  private void compare(
      MotionChain nominal, MotionChain model, MotionRun fitted, MotionRun other, int component) {
    double horizon = Windows.horizonsS()[0];
    List<Window> windows = Windows.of(List.of(other), horizon);
    LinearFilter filter =
        LinearFilter.fitted(fitted, Windows.of(List.of(fitted), horizon), component);
    double before = 0;
    double after = 0;
    double filtered = 0;
    Way told = Way.of(other, nominal);
    Way found = Way.of(other, model);
    for (Window window : windows) {
      before += Math.abs(off(window, told, component));
      after += Math.abs(off(window, found, component));
      filtered += Math.abs(filter.off(window));
    }
    double byNames = 1 - after / before;
    double byFilter = 1 - filtered / before;
    say(
        "  %s over %.1f s: mean absolute error %.3f %s; taken away by the filter %.1f %%, by the"
            + " names %.1f %% (%.0f %% of the filter's)",
        component == TURN ? "turn" : "along",
        horizon,
        (component == TURN ? Math.toDegrees(before) : 1000 * before) / windows.size(),
        component == TURN ? "degrees" : "mm",
        100 * byFilter,
        100 * byNames,
        100 * byNames / byFilter);
  }

  private static double off(Window window, Way way, int component) {
    double expected = way.between(window.startS(), window.endS()).component(component);
    double off = window.way().component(component) - expected;
    return component == TURN ? Math.IEEEremainder(off, 2 * Math.PI) : off;
  }

  /** The share of windows that lie within, by horizon and component. */
  private static String coverage(MotionForecast forecast, MotionRun run) {
    List<MotionForecast.Row> rows = forecast.of(List.of(run));
    StringBuilder text = new StringBuilder();
    for (double horizon : Windows.horizonsS()) {
      Map<Double, double[][]> foretold = new HashMap<>();
      rows.stream()
          .filter(row -> row.horizonS() == horizon)
          .forEach(row -> foretold.put(row.startS(), row.quantiles()));
      List<Window> windows = Windows.of(List.of(run), horizon);
      for (int c = 0; c < COMPONENTS; c++) {
        int component = c;
        long inside =
            windows.stream()
                .filter(one -> isInside(one, at(foretold, one)[component], component))
                .count();
        text.append(
            String.format(Locale.ROOT, " %.0f", 100.0 * inside / Math.max(1, windows.size())));
      }
      text.append(';');
    }
    return text.toString();
  }

  private static double[][] at(Map<Double, double[][]> foretold, Window window) {
    return Objects.requireNonNull(foretold.get(window.startS()), "no forecast of a window");
  }

  private static boolean isInside(Window window, double[] quantiles, int component) {
    double low = quantiles[0];
    double high = quantiles[quantiles.length - 1];
    double off = window.way().component(component) - (low + high) / 2;
    off = component == TURN ? Math.IEEEremainder(off, 2 * Math.PI) : off;
    return Math.abs(off) <= (high - low) / 2;
  }

  private void say(String format, Object... values) {
    out.println(String.format(Locale.ROOT, format, values));
  }
}
