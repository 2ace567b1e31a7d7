package simbad.studio.folders;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import simbad.figures.diagnosis.RowFinding;
import simbad.figures.diagnosis.RowSurvey;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.Interval;
import simbad.gap.diagnosis.Place;
import simbad.gap.locate.PlaceRows;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.predict.FittedModel;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** The rows of a data set before and after its diagnosis, and which of them each place has. */
final class RowsView {
  /** More dots than that are one blot; of more every second one is shown, or every third. */
  private static final int MOST = 20_000;

  private static final List<String> COLUMNS =
      List.of(
          "row",
          "x_m",
          "z_m",
          "heading_rad",
          "range_m",
          "bearing_deg",
          "distance_m",
          "off_axis_deg",
          "t_s",
          "gap_before_cm",
          "gap_after_cm",
          "residual_before_cm",
          "residual_after_cm");

  private final DataSet data;
  private final FittedModel model;
  private final PingLog log;

  RowsView(DataSet data, FittedModel model) {
    this.data = data;
    this.model = model;
    log = new PingLog(data.readings());
  }

  /** Adds rows and places to a diagnosis' JSON. */
  void add(JsonNode diagnosis, ObjectNode root) {
    int every = 1 + (log.size() - 1) / MOST;
    root.put("all_rows", log.size());
    root.put("every", every);
    COLUMNS.forEach(root.putArray("columns")::add);
    // What a tie of ranks is broken by is not shown.
    List<RowFinding> findings = RowSurvey.of(data, model.changes(), new SplittableRandom(0));
    ArrayNode rows = root.putArray("rows");
    for (int ping = 0; ping < log.size(); ping += every) {
      add(rows.addArray(), data.readings().get(log.row(ping)), log.row(ping), findings.get(ping));
    }
    places(diagnosis, every, root.putArray("places"));
  }

  private static void add(ArrayNode list, ReadingRow row, int index, RowFinding finding) {
    // As counted below the header.
    list.add(index + 1);
    put(list, row.pose().position().xM());
    put(list, row.pose().position().zM());
    put(list, row.pose().heading().radians());
    put(
        list,
        row.reading() instanceof Echo echo
            ? OptionalDouble.of(echo.rangeM())
            : OptionalDouble.empty());
    put(list, finding.bearingDeg());
    put(list, finding.distanceM());
    put(list, finding.offAxisDeg());
    put(list, row.timeS());
    put(list, finding.before().gapCm());
    put(list, finding.after().gapCm());
    put(list, finding.before().residualCm());
    put(list, finding.after().residualCm());
  }

  private static void put(ArrayNode list, OptionalDouble value) {
    if (value.isPresent()) {
      put(list, value.getAsDouble());
    } else {
      list.addNull();
    }
  }

  private static void put(ArrayNode list, double value) {
    list.add(Math.rint(value * 1e4) / 1e4);
  }

  private void places(JsonNode diagnosis, int every, ArrayNode places) {
    var geometry = new ChangedModel(data.setup(), List.of()).geometry(log);
    for (JsonNode place : diagnosis.path("where")) {
      ArrayNode list = places.addArray();
      for (int ping : PlaceRows.of(geometry, conditions(place.path("slice")))) {
        if (ping % every == 0) {
          list.add(ping / every);
        }
      }
    }
  }

  private static List<Place.Condition> conditions(JsonNode slice) {
    List<Place.Condition> conditions = new ArrayList<>();
    for (Map.Entry<String, JsonNode> entry : slice.properties()) {
      JsonNode value = entry.getValue();
      boolean named = value.isTextual();
      conditions.add(
          new Place.Condition(
              entry.getKey(),
              named ? Optional.empty() : Optional.of(interval(value)),
              named ? Optional.of(value.textValue()) : Optional.empty()));
    }
    return conditions;
  }

  /** An end that is null is none. */
  private static Interval interval(JsonNode ends) {
    return new Interval(
        ends.path(0).isNumber() ? ends.path(0).doubleValue() : Double.NEGATIVE_INFINITY,
        ends.path(1).isNumber() ? ends.path(1).doubleValue() : Double.POSITIVE_INFINITY);
  }
}
