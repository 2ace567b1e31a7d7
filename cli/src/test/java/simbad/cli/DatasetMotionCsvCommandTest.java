package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.motion.MotionRun;
import simbad.motion.format.MotionFolder;
import simbad.sonar.format.DataFormatException;

/**
 * One drive, written down as several people would: a circle of 0.5 m at 0.25 m/s, 0.5 rad/s to the
 * left, ten times a second.
 */
class DatasetMotionCsvCommandTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private interface Row {
    String of(double timeS, double xM, double yM, double headingRad);
  }

  private String file(String name, String head, Row row) throws IOException {
    StringBuilder text = new StringBuilder(head).append('\n');
    for (int i = 0; i <= 60; i++) {
      double t = i / 10.0;
      double angle = 0.5 * t;
      text.append(row.of(t, 0.5 * Math.sin(angle), 0.5 * (1 - Math.cos(angle)), angle))
          .append('\n');
    }
    Path file = folder.resolve(name);
    Files.writeString(file, text);
    return file.toString();
  }

  private static String line(Object... cells) {
    List<String> words = new ArrayList<>();
    for (Object cell : cells) {
      words.add(cell instanceof Double d ? String.format(Locale.ROOT, "%.7f", d) : cell.toString());
    }
    return String.join(",", words);
  }

  private Shell csv(String out, List<String> files, String... words) {
    List<String> all = new ArrayList<>(List.of("dataset", "motion", "csv"));
    all.addAll(files);
    all.addAll(List.of(words));
    all.addAll(List.of("--out", folder.resolve(out).toString()));
    return Shell.simbad(all.toArray(String[]::new));
  }

  private void checkCircle(Shell shell, String out) throws DataFormatException {
    assertEquals(0, shell.status(), shell.err());
    MotionRun run = new MotionFolder(folder.resolve(out)).read("log").runs().get(0);
    assertEquals(61, run.commands().size());
    assertEquals(0, run.commands().get(0).timeS());
    assertEquals(0.25, run.commands().get(7).speedMPerS(), 1e-5);
    assertEquals(0.5, run.commands().get(7).turnRadPerS(), 1e-5);
    double angle = 0.5 * 4;
    assertEquals(4, run.track().get(40).timeS(), 1e-4);
    assertEquals(0.5 * Math.sin(angle), run.track().get(40).xM(), 1e-5);
    assertEquals(0.5 * (1 - Math.cos(angle)), run.track().get(40).yM(), 1e-5);
    assertEquals(
        0, Math.IEEEremainder(run.track().get(40).headingRad() - angle, 2 * Math.PI), 1e-5);
  }

  @Test
  void ownNames_needNoOption() throws Exception {
    String commands = file("commands.csv", "t_s,v_m_s,w_rad_s", (t, x, y, h) -> line(t, 0.25, 0.5));
    String track =
        file(
            "track.csv",
            "t_s,x_m,z_m,heading_deg",
            (t, x, y, h) -> line(t, x, -y, Math.toDegrees(h)));
    Shell shell = csv("plain", List.of(commands, track));
    checkCircle(shell, "plain");
    assertTrue(shell.out().contains("read 61 commands and 61 poses in 1 run"), shell.out());
    assertTrue(shell.out().contains("again: ./simbad dataset motion csv "), shell.out());
  }

  /** Milliseconds since some day, centimetres, a compass, y up the page, one file. */
  @Test
  void otherUnitsAndAxes_areSaid() throws Exception {
    String both =
        file(
            "both.csv",
            "stamp_ms;speed_cm_s;rate_deg_s;east_cm;north_cm;compass".replace(';', ','),
            (t, x, y, h) ->
                line(
                    1e6 + 1e3 * t,
                    25.0,
                    Math.toDegrees(0.5),
                    100 * x,
                    100 * y,
                    90 - Math.toDegrees(h)));
    String[] words =
        ("--time stamp_ms --speed speed_cm_s --turn rate_deg_s --x east_cm --y north_cm"
                + " --heading compass --angle-zero up --angle-positive cw")
            .split(" ", -1);
    checkCircle(csv("other", List.of(both), words), "other");
  }

  /** v = (l + r) / 2 and w = (r - l) / base: 0.2 and 0.3 m/s at 20 cm. */
  @Test
  void wheels_areSpeedAndTurn() throws Exception {
    String both =
        file("wheels.csv", "time,l,r,x,y,yaw", (t, x, y, h) -> line(t, 200.0, 300.0, x, y, h));
    String[] words =
        "--left l --right r --speed-unit mm/s --wheel-base 20cm --angle-unit rad".split(" ", -1);
    checkCircle(csv("wheels", List.of(both), words), "wheels");
  }

  @ParameterizedTest
  @CsvSource({
    "--speed, engine, engine",
    "--speed-unit, furlongs/s, --speed-unit",
    "--angle-unit, m, --angle-unit",
    "--left, v, --right",
    "--track-sigma, -2mm, --track-sigma",
    "--heading-sigma, -1deg, --heading-sigma",
    "--angle-positive, sideways, --angle-positive"
  })
  void whatIsWrong_isSaidInALine(String option, String value, String said) throws IOException {
    String both =
        file("wrong.csv", "t,v,w,x,y,heading", (t, x, y, h) -> line(t, 1.0, 0.0, x, y, h));
    Shell shell = csv("wrong", List.of(both), option, value);
    assertEquals(2, shell.status(), shell.out());
    assertTrue(shell.err().contains(said), shell.err());
    assertEquals(1, shell.err().lines().count(), shell.err());
    assertFalse(Files.exists(folder.resolve("wrong")));
  }

  @Test
  void cellThatIsNoNumber_isNamed() throws IOException {
    String both =
        file(
            "bad.csv",
            "t,v,w,x,y,heading",
            (t, x, y, h) -> line(t, t == 0.3 ? "fast" : "1.0", 0.0, x, y, h));
    Shell shell = csv("bad", List.of(both));
    assertEquals(2, shell.status());
    assertTrue(shell.err().contains("bad.csv:5: v: 'fast'"), shell.err());
  }

  /** A known word with a unit behind it is known, too. */
  @ParameterizedTest
  @CsvSource({"yaw_deg, omega_rad_s, time_us", "theta [deg], yaw_rate (rad/s), stamp_us"})
  void knownNamesWithUnits_needNoOption(String yaw, String omega, String time) throws Exception {
    String both =
        file(
            "units.csv",
            String.join(",", time, "speed_mm_s", omega, "x_m", "y_m", yaw),
            (t, x, y, h) -> line(1e6 * t, 250.0, 0.5, x, y, Math.toDegrees(h)));
    checkCircle(csv("units", List.of(both)), "units");
  }

  @Test
  void posesThatWereLost_areLeftOut_andCounted() throws Exception {
    String commands = file("commands.csv", "t_s,v_m_s,w_rad_s", (t, x, y, h) -> line(t, 0.25, 0.5));
    String track =
        file(
            "track.csv",
            "t_s,x_m,y_m,yaw_deg",
            (t, x, y, h) ->
                t == 0.3
                    ? line(t, "NaN", "NaN", "NaN")
                    : t == 0.5 ? line(t, "", "", "") : line(t, x, y, t == 0.7 ? "nan" : 0.0));
    Shell shell = csv("lost", List.of(commands, track));
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().contains("read: 3 rows have no pose"), shell.out());
    assertTrue(shell.out().contains("read 61 commands and 58 poses in 1 run"), shell.out());
    MotionRun run = new MotionFolder(folder.resolve("lost")).read("log").runs().get(0);
    assertEquals(58, run.track().size());
  }

  @Test
  void timesThatGoBackOrRepeat_areCounted() throws IOException {
    String both =
        file(
            "back.csv",
            "t,v,w,x,y,heading",
            (t, x, y, h) ->
                line(t == 3.0 ? 2.95 : t == 4.0 ? 1.05 : t == 5.0 ? 4.9 : t, 0.2, 0.0, x, y, h));
    Shell shell = csv("back", List.of(both));
    assertEquals(0, shell.status(), shell.err());
    assertTrue(
        shell.out().contains("read: 1 row of the track has an earlier time than the row before"),
        shell.out());
    assertTrue(
        shell.out().contains("read: 1 row of the commands has the time of another row"),
        shell.out());
  }
}
