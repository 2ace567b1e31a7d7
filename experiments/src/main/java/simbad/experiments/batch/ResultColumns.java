package simbad.experiments.batch;

import de.siegmar.fastcsv.writer.CsvWriter;
import de.siegmar.fastcsv.writer.LineDelimiter;
import java.io.StringWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import simbad.experiments.control.ControllerParameter;
import simbad.experiments.report.RunFiles;
import simbad.experiments.run.Circuit;
import simbad.experiments.run.EdgeKept;
import simbad.experiments.run.Trace;
import simbad.experiments.run.TraceErrors;

/**
 * The columns of results.csv: which run it is, then what came of it. Centimetres, seconds; empty
 * where there is none. The figures mean what they mean in a run's errors.csv.
 */
final class ResultColumns {
  static final String NUMBER = "run";
  static final String STATUS = "status";
  static final String DONE = "done";
  static final String FAILED = "failed";
  static final String PARAMETER = "controller.";
  private static final int DECIMALS = 4;

  private static final List<String> OF_A_RUN =
      List.of(NUMBER, "scene", "obstacle", "sensor", "sensor_file", "effects", "controller");
  private static final List<String> OF_A_RESULT =
      List.of(
          "speed_m_per_s",
          "seed",
          STATUS,
          "error",
          "closed",
          "steps",
          "simulated_s",
          "way_m",
          "mean_abs_cm",
          "rms_cm",
          "max_abs_cm",
          "median_abs_cm",
          "lateral_mean_cm",
          "lateral_p95_cm",
          "lateral_max_cm",
          "edge_kept",
          "edge_to_trace_mean_cm",
          "edge_to_trace_max_cm",
          "bearings",
          "unreached_bearings");

  private final List<String> columns;

  /** The columns of a batch: one for each parameter of each of its kinds of controllers. */
  ResultColumns(BatchPlan plan) {
    List<String> all = new ArrayList<>(OF_A_RUN);
    plan.spec().makers().stream()
        .flatMap(maker -> maker.parameters().stream())
        .map(ControllerParameter::name)
        .distinct()
        .forEach(name -> all.add(PARAMETER + name));
    all.addAll(OF_A_RESULT);
    columns = List.copyOf(all);
  }

  List<String> names() {
    return columns;
  }

  String header() {
    return line(columns);
  }

  /** The row of a run that was driven. */
  String row(BatchRun run, Trace trace) {
    Map<String, String> fields = fields(run);
    Circuit circuit = run.circuit();
    fields.put(STATUS, DONE);
    fields.put("closed", Boolean.toString(trace.isClosed()));
    fields.put("steps", Integer.toString(trace.size()));
    fields.put("simulated_s", RunFiles.fixed(trace.size() * Circuit.STEP_S, 2));
    fields.put("way_m", RunFiles.fixed(trace.wayM(), DECIMALS));
    TraceErrors errors = circuit.errors(trace);
    boolean onEdge =
        trace.firstOnEdge() < trace.size() && circuit.type().thresholds().table().greatestM() > 0;
    fields.put("mean_abs_cm", centimetres(errors.meanM()));
    fields.put("rms_cm", centimetres(errors.rmsM()));
    fields.put("max_abs_cm", centimetres(errors.maxM()));
    fields.put("median_abs_cm", centimetres(errors.medianM()));
    if (onEdge) {
      fields.put("lateral_mean_cm", centimetres(OptionalDouble.of(errors.lateralMeanM())));
      fields.put("lateral_p95_cm", centimetres(OptionalDouble.of(errors.lateralP95M())));
      fields.put("lateral_max_cm", centimetres(OptionalDouble.of(errors.lateralMaxM())));
    }
    addEdge(fields, errors.edge());
    fields.put("bearings", Integer.toString(errors.radialM().size()));
    fields.put("unreached_bearings", Integer.toString(errors.unreachedBearings()));
    return line(fields);
  }

  private static void addEdge(Map<String, String> fields, EdgeKept edge) {
    edge.share().ifPresent(share -> fields.put("edge_kept", RunFiles.fixed(share, DECIMALS)));
    fields.put("edge_to_trace_mean_cm", centimetres(edge.meanM()));
    fields.put("edge_to_trace_max_cm", centimetres(edge.maxM()));
  }

  /** The row of a run that failed. */
  String row(BatchRun run, Throwable error) {
    Map<String, String> fields = fields(run);
    fields.put(STATUS, FAILED);
    // A row is one line, so that a torn one can be told from a whole one.
    fields.put("error", error.toString().replaceAll("[\\p{Cc}\\u2028\\u2029]+", " "));
    return line(fields);
  }

  private static Map<String, String> fields(BatchRun run) {
    Map<String, String> fields = new LinkedHashMap<>();
    fields.put(NUMBER, Long.toString(run.number()));
    fields.put("scene", run.scene().name());
    fields.put("obstacle", run.scene().circled().name());
    fields.put("sensor", run.circuit().sensor().word());
    fields.put("sensor_file", run.sensorFile());
    fields.put("effects", run.effects());
    fields.put("controller", run.controller().maker().name());
    run.controller()
        .values()
        .forEach((name, value) -> fields.put(PARAMETER + name, value.toString()));
    fields.put("speed_m_per_s", Double.toString(run.circuit().speedMPerS()));
    fields.put("seed", Long.toString(run.circuit().seed()));
    return fields;
  }

  private String line(Map<String, String> fields) {
    return line(columns.stream().map(column -> fields.getOrDefault(column, "")).toList());
  }

  private static String line(List<String> fields) {
    StringWriter text = new StringWriter();
    CsvWriter.builder()
        .bufferSize(0)
        .lineDelimiter(LineDelimiter.LF)
        .build(text)
        .writeRecord(fields);
    return text.toString();
  }

  private static String centimetres(OptionalDouble metres) {
    return metres.isPresent() ? RunFiles.fixed(100 * metres.getAsDouble(), DECIMALS) : "";
  }
}
