package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import simbad.motion.Displacement;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.Way;
import simbad.motion.forecast.Window;
import simbad.motion.forecast.Windows;
import simbad.motion.format.DiagnosedMotion;
import simbad.motion.format.MotionData;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.DataFormatException;

/**
 * Where a robot drove, and how far forecasts over half a second are off before and after its
 * diagnosis: for each window, and which windows each place of the gap has.
 */
final class DriveView {
  /** More dots than that are one blot. */
  private static final int MOST = 20_000;

  /** The places of a diagnosis are of such windows. */
  private static final double HORIZON_S = Windows.horizonsS()[0];

  private static final List<String> COLUMNS =
      List.of(
          "run",
          "t_s",
          "x_m",
          "z_m",
          "heading_rad",
          "along_m",
          "across_m",
          "turn_rad",
          "along_before_m",
          "across_before_m",
          "turn_before_rad",
          "along_after_m",
          "across_after_m",
          "turn_after_rad");

  private final List<MotionRun> runs;
  private final List<Window> windows;
  private final int every;

  private DriveView(List<MotionRun> runs) {
    this.runs = runs;
    windows = Windows.of(runs, HORIZON_S);
    every = 1 + Math.max(0, windows.size() - 1) / MOST;
  }

  /**
   * Adds tracks and windows.
   *
   * @param set folder of the data set
   * @param diagnosis folder of its diagnosis, with robot.json and motion.json
   * @param motion what is said of the motion, with its places
   * @throws DataFormatException naming file, line and field of the first fault
   */
  static void add(Path set, Path diagnosis, JsonNode motion, ObjectNode root)
      throws DataFormatException {
    MotionData data = new MotionFolder(set).read("");
    MotionChain fitted = DiagnosedMotion.forecast(diagnosis).chain();
    // As the diagnosis has it: a command that repeats the one before is none.
    DriveView view = new DriveView(data.runs().stream().map(MotionRun::withoutRepeats).toList());
    view.tracks(root.putArray("tracks"));
    root.put("all_windows", view.windows.size()).put("windows_every", view.every);
    COLUMNS.forEach(root.putArray("window_columns")::add);
    view.windows(data.robot().motion(), fitted, root.putArray("windows"));
    view.places(motion, root.putArray("window_places"));
  }

  private void tracks(ArrayNode tracks) {
    for (MotionRun run : runs) {
      DrivenWay trace = new DrivenWay();
      for (TrackPose pose : run.track()) {
        trace.add(pose.xM(), -pose.yM());
      }
      ObjectNode track = tracks.addObject().put("run", run.name());
      trace.write(DrivenWay.Box.ALL, track.putArray("pieces"));
    }
  }

  private List<Way> ways(MotionChain chain) {
    List<Way> ways = new ArrayList<>();
    runs.forEach(run -> ways.add(Way.of(run, chain)));
    return ways;
  }

  private void windows(MotionChain believed, MotionChain fitted, ArrayNode list) {
    List<Way> before = ways(believed);
    List<Way> after = ways(fitted);
    for (int i = 0; i < windows.size(); i += every) {
      Window window = windows.get(i);
      ArrayNode row = list.addArray().add(runs.get(window.run()).name());
      put(row, window.startS(), window.xM(), -window.yM(), window.headingRad());
      put(row, window.way().alongM(), window.way().acrossM(), window.way().turnRad());
      residual(row, window, before.get(window.run()));
      residual(row, window, after.get(window.run()));
    }
  }

  /** What was seen less what was expected. */
  private static void residual(ArrayNode row, Window window, Way way) {
    Displacement seen = window.way();
    Displacement expected = way.between(window.startS(), window.endS());
    double turn = Math.IEEEremainder(seen.turnRad() - expected.turnRad(), 2 * Math.PI);
    put(row, seen.alongM() - expected.alongM(), seen.acrossM() - expected.acrossM(), turn);
  }

  /** To a hundredth of a millimetre: half a second's way is short. */
  private static void put(ArrayNode row, double... values) {
    for (double value : values) {
      row.add(Math.rint(value * 1e5) / 1e5);
    }
  }

  private void places(JsonNode motion, ArrayNode places) {
    WindowSlices slices = new WindowSlices(runs);
    for (JsonNode place : motion.path("where")) {
      // The last slice of an axis has its upper end, the others have not.
      List<Window> of = slices.of(place.path("slice"), windows, false);
      if (of.size() < place.path("rows").asInt()) {
        of = slices.of(place.path("slice"), windows, true);
      }
      Set<Window> in = new HashSet<>(of);
      ArrayNode list = places.addArray();
      for (int i = 0; i < windows.size(); i += every) {
        if (in.contains(windows.get(i))) {
          list.add(i / every);
        }
      }
    }
  }
}
