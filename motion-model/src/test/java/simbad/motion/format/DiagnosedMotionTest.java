package simbad.motion.format;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.motion.CommandReach;
import simbad.motion.MotionChain;
import simbad.motion.Robot;
import simbad.motion.effect.FittedMotion;
import simbad.motion.effect.MotionForms;
import simbad.motion.forecast.MotionForecast;
import simbad.motion.forecast.PinballLoss;
import simbad.motion.forecast.Spread;
import simbad.sonar.format.DataFormatException;

class DiagnosedMotionTest {
  @TempDir Path folder = Path.of("");

  private static FittedMotion fitted(String form, double... values) {
    return new FittedMotion(MotionForms.find(form).orElseThrow(), values);
  }

  private static List<Spread> spreads() {
    List<Spread> spreads = new ArrayList<>();
    for (int h = 0; h < 3; h++) {
      double[][][] quantiles = new double[2][3][PinballLoss.QUANTILES];
      quantiles[1][2][18] = 0.1 + h;
      spreads.add(new Spread(new double[] {0.25}, quantiles));
    }
    return spreads;
  }

  @BeforeEach
  void write() throws IOException {
    new MotionFolder(folder).write(new MotionData("m", Robot.EXACT_UNICYCLE, List.of(), List.of()));
    write(
        DiagnosedMotion.text(
            List.of(fitted("speed-scale", 0.95), fitted("capture-offset: heading", 0.02)),
            spreads(),
            new CommandReach(0.3, 1.5)));
  }

  private void write(String text) throws IOException {
    Files.writeString(folder.resolve(DiagnosedMotion.MODEL), text);
  }

  @Test
  void forecast_isWhatWasWritten() throws DataFormatException {
    MotionForecast read = DiagnosedMotion.forecast(folder);
    assertEquals(2, read.chain().changes().size());
    assertArrayEquals(new double[] {0.25}, read.spreads().get(0).limits());
    assertEquals(2.1, read.spreads().get(2).at(0.3, 2)[18]);
    assertEquals(0, read.spreads().get(2).at(0.2, 2)[18]);
  }

  /** What a program before this one wrote says nothing of commands. */
  @Test
  void reach_isWhatWasCommanded() throws IOException, DataFormatException {
    assertEquals(new CommandReach(0.3, 1.5), DiagnosedMotion.reach(folder));
    String good = Files.readString(folder.resolve(DiagnosedMotion.MODEL));
    write(good.replaceFirst("  \"commanded\".*\n", ""));
    assertEquals(CommandReach.ANY, DiagnosedMotion.reach(folder));
    assertEquals(2, DiagnosedMotion.forecast(folder).chain().changes().size());
  }

  /** What is about the tracker does not move the robot. */
  @Test
  void robot_movesByWhatMovesIt() throws DataFormatException {
    MotionChain chain = DiagnosedMotion.read(folder);
    assertEquals(List.of(fitted("speed-scale", 0.95).change()), chain.changes());
    Path robot = folder.resolve(MotionFolder.ROBOT);
    assertEquals(MotionChain.EXACT, DiagnosedMotion.believed(robot));
    assertEquals(Robot.EXACT_UNICYCLE, DiagnosedMotion.robot(robot));
  }

  /** As a program before this one wrote it. */
  @Test
  void scatterAmongTheForms_movesNothing() throws IOException, DataFormatException {
    write(
        """
        {"format": "motion-model/1", "forms": [
          {"form": "slip", "parameters": {"share_of_windows": 0.1}},
          {"form": "turn-scale", "parameters": {"turn_factor": 0.9}}]}
        """);
    assertEquals(
        List.of(fitted("turn-scale", 0.9).change()), DiagnosedMotion.read(folder).changes());
  }

  @Test
  void faults_areNamed() throws IOException {
    String good = Files.readString(folder.resolve(DiagnosedMotion.MODEL));
    checkFault(good.replace("speed-scale", "speed-of-light"), "form");
    checkFault(good.replace("0.95", "95.0"), "speed_factor");
    checkFault(good.replace("\"speed_factor\": 0.95", ""), "speed_factor");
    checkFault(good.replace("motion-model/1", "motion-model/9"), "format");
    checkFault(
        good.replace("\"exertion_limits_m\": [0.25]", "\"exertion_limits_m\": []"), "along_m");
    checkFault(good.replaceFirst("\\[0.0, 0.0, ", "[0.0, "), "19 quantiles");
    checkFault(
        DiagnosedMotion.text(List.of(), spreads().subList(0, 2), CommandReach.ANY), "a list of 3");
    Files.delete(folder.resolve(DiagnosedMotion.MODEL));
    DataFormatException none =
        assertThrows(DataFormatException.class, () -> DiagnosedMotion.read(folder));
    assertTrue(none.toString().contains("does not exist"), none.toString());
  }

  private void checkFault(String text, String field) throws IOException {
    write(text);
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> DiagnosedMotion.forecast(folder), field);
    assertTrue(fault.toString().contains(field), fault.toString());
  }
}
