package simbad.experiments.batch;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.TreeMap;
import org.knowm.xchart.BitmapEncoder;
import org.knowm.xchart.BitmapEncoder.BitmapFormat;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.XYChartBuilder;
import simbad.sonar.format.CsvTable;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/**
 * The picture of docs/guide/batch.md: {@code TuningPicture RESULTS.csv OUT.png} draws the mean
 * error over the obstacles against the crossing angle, a curve for each sensor and curl.
 */
final class TuningPicture {
  private static final List<String> CURLS = List.of("0.001", "0.003", "0.01", "0.03");

  private TuningPicture() {}

  public static void main(String[] arguments) throws IOException, DataFormatException {
    Path results = Path.of(arguments[0]);
    CsvTable rows = CsvTable.parse(results, TextFile.read(results));
    XYChart chart =
        new XYChartBuilder()
            .width(900)
            .height(480)
            .title("Error of the robot's way against the table, by the edge follower's parameters")
            .xAxisTitle("crossing angle (degrees)")
            .yAxisTitle("mean |r - T| over three obstacles (cm)")
            .build();
    chart.getStyler().setYAxisLogarithmic(true).setYAxisMin(0.1).setYAxisMax(1000.0);
    add(chart, rows, "original", "0.01");
    for (String curl : CURLS) {
      add(chart, rows, "shadow", curl);
    }
    BitmapEncoder.saveBitmap(chart, arguments[1], BitmapFormat.PNG);
  }

  private static void add(XYChart chart, CsvTable rows, String sensor, String curl) {
    TreeMap<Double, Double> errors = new TreeMap<>();
    for (int row = 0; row < rows.size(); row++) {
      if (rows.text(row, "sensor").equals(sensor)
          && rows.text(row, "controller.curl_rad_per_step").equals(curl)) {
        double angleDeg = Double.parseDouble(rows.text(row, "controller.crossing_angle_deg"));
        double errorCm = Double.parseDouble(rows.text(row, "mean_abs_cm"));
        errors.merge(angleDeg, errorCm / 3, Double::sum);
      }
    }
    chart.addSeries(
        sensor + ", curl " + curl, List.copyOf(errors.keySet()), List.copyOf(errors.values()));
  }
}
