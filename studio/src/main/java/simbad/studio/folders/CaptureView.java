package simbad.studio.folders;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simbad.bench.capture.CapturedReadings;
import simbad.bench.capture.Level;
import simbad.bench.capture.SweepPlan;
import simbad.bench.capture.ThresholdFit;
import simbad.experiments.bench.CaptureFolder;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.shape.ThresholdTable;

/** A capture's folder: what was tried at each bearing, and what came of it until now. */
final class CaptureView {
  private CaptureView() {}

  /**
   * Adds what a capture has recorded. Beside its thresholds stand those of the catalogue, if the
   * obstacle is in it.
   *
   * @throws DataFormatException if its journal is damaged
   */
  static void add(Path folder, ObjectNode root) throws DataFormatException {
    Shelf.file(folder, "journal.txt");
    CapturedReadings readings = new CaptureFolder(folder).read();
    SweepPlan plan = readings.settings().plan();
    String obstacle = readings.settings().of("obstacle");
    Optional<ThresholdTable> table =
        Catalogue.findAny(obstacle).map(ObstacleType::thresholds).map(known -> known.table());
    root.put("obstacle", obstacle).put("pings_each", plan.pings());
    root.put("done", readings.state().doneCount()).put("pings", readings.state().pings());
    ArrayNode edge = root.putArray("edge");
    table.stream()
        .flatMap(known -> known.points().stream())
        .forEach(point -> edge.addArray().add(point.xM()).add(point.zM()));
    ArrayNode list = root.putArray("bearings");
    for (int i = 0; i < plan.bearings(); i++) {
      ObjectNode node = list.addObject().put("bearing_deg", plan.bearingDeg(i));
      double bearingRad = Math.toRadians(plan.bearingDeg(i));
      table.ifPresent(known -> node.put("table_m", known.thresholdM(bearingRad)));
      List<Level> levels = readings.state().levels(i);
      if (readings.state().isDone(i) && !levels.isEmpty()) {
        ThresholdFit fit = ThresholdFit.of(levels, plan);
        node.put("threshold_m", fit.thresholdM());
        node.put("low_m", fit.lowM()).put("high_m", fit.highM());
      }
      add(levels, plan, node);
    }
  }

  /** Distance, pings, how many were heard, whether the echo counts as lost there. */
  private static void add(List<Level> levels, SweepPlan plan, ObjectNode node) {
    node.put("pings", levels.stream().mapToInt(Level::pings).sum());
    node.put("heard", levels.stream().mapToInt(Level::heard).sum());
    ArrayNode list = node.putArray("levels");
    for (Level level : levels) {
      boolean lost = level.pings() - level.heard() >= plan.misses();
      list.addArray().add(level.distanceM()).add(level.pings()).add(level.heard()).add(lost);
    }
  }
}
