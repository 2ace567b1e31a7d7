package simbad.bench.capture;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.ThesisLine;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OneLine;
import simbad.sonar.format.Provenance;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TextFile;
import simbad.sonar.frame.Point;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/**
 * A capture as the thesis made it: what the display showed last before the echo was lost, a number
 * in steps of 2 cm for each bearing, one on a line, from bearing 0 all round.
 *
 * <p>The number is a time of 118 us to the step, taken in the middle of the step and turned into a
 * distance by the speed of sound of that day; it is the distance to the obstacle's surface, to
 * which that from the surface to the axis is added.
 */
public final class ThesisCapture {
  private ThesisCapture() {}

  /**
   * Reads one.
   *
   * @param file text; empty lines and those that begin with {@code #} are passed over
   * @param name of the obstacle
   * @param outline of the obstacle in its own frame
   * @param temperatureC of the air, if it is known
   * @throws DataFormatException naming file and line of the first fault
   */
  public static TableDocument read(
      Path file, String name, Outline outline, OptionalDouble temperatureC)
      throws DataFormatException {
    return parse(file, TextFile.read(file), new Meaning(name, outline, temperatureC));
  }

  /** What the numbers were measured of. */
  record Meaning(String name, Outline outline, OptionalDouble temperatureC) {
    Ranging ranging() {
      return Ranging.of(temperatureC, FirmwareMode.THESIS);
    }
  }

  static TableDocument parse(Path file, String text, Meaning meaning) throws DataFormatException {
    List<Double> rangesM = new ArrayList<>();
    long number = 0;
    for (String line : text.lines().toList()) {
      number++;
      if (!line.isBlank() && !line.startsWith("#")) {
        rangesM.add(rangeM(file, number, line.strip(), meaning.ranging()));
      }
    }
    if (rangesM.size() < ThresholdTable.LEAST_SIZE) {
      throw DataFormatException.inFile(
          file, rangesM.size() + " numbers, expected one for each bearing, at least 3");
    }
    double[] thresholdsM = new double[rangesM.size()];
    for (int i = 0; i < thresholdsM.length; i++) {
      double bearingRad = 2 * Math.PI * i / thresholdsM.length;
      double wholeM = rangesM.get(i) + frontM(meaning.outline(), bearingRad);
      thresholdsM[i] = Math.rint(wholeM * 1e4) / 1e4;
    }
    return new TableDocument(ThresholdTable.of(thresholdsM), header(file, meaning));
  }

  private static double rangeM(Path file, long number, String line, Ranging ranging)
      throws DataFormatException {
    OptionalInt steps = ThesisLine.steps(line);
    if (steps.isEmpty()) {
      throw DataFormatException.inField(
          file, number, "number", "'" + line + "' is not a number of steps of 2 cm");
    }
    OptionalDouble echoUs = ThesisLine.echoUs(steps.getAsInt());
    if (echoUs.isEmpty()) {
      throw DataFormatException.inField(
          file, number, "number", line + " steps are 36 ms, which means no echo");
    }
    return ranging.rangeM(echoUs.getAsDouble());
  }

  /** From the axis to the foremost point of the obstacle, seen from a bearing. */
  private static double frontM(Outline outline, double bearingRad) {
    double greatest = 0;
    for (Point corner : outline.corners()) {
      greatest =
          Math.max(
              greatest, corner.xM() * Math.sin(bearingRad) + corner.zM() * Math.cos(bearingRad));
    }
    return greatest;
  }

  private static Map<String, String> header(Path file, Meaning meaning) {
    Map<String, String> header = new LinkedHashMap<>();
    header.put("object", meaning.name());
    header.put("sensor", "Devantech SRF04");
    header.put("provenance", Provenance.CAPTURED.word());
    header.put(
        "source",
        "numbers of the thesis's display; " + OneLine.of(file.getFileName() + "").strip());
    header.put("unit", "m");
    header.put("resolution", Double.toString(ThesisLine.STEP_M));
    meaning.ranging().describe(header, meaning.temperatureC().isPresent());
    return header;
  }
}
