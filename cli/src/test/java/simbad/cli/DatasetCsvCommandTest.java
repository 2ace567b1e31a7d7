package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.ByteArrayOutputStream;
import java.io.PrintWriter;
import java.io.StringReader;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.experiments.dataset.LogImport;
import simbad.experiments.dataset.LogSettings;
import simbad.gap.diagnosis.DataSet;
import simbad.gap.diagnosis.DataSetFolder;
import simbad.sonar.frame.Point;
import simbad.sonar.model.NominalModel;
import simbad.sonar.model.SightLine;
import simbad.sonar.model.TransducerPose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;

/** Small logs of every kind, made up here, as their owners would bring them in. */
class DatasetCsvCommandTest {
  private static final String LADDER = "true_cm,reading_cm\n10,9.8\n20,19.7\n30,\n";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private int made;

  private Shell type(String text, String options) throws Exception {
    return type(text.getBytes(StandardCharsets.UTF_8), options);
  }

  private Shell type(byte[] log, String options) throws Exception {
    Files.write(folder.resolve("log.csv"), log);
    return type("LOG " + options);
  }

  private Shell type(String options) {
    made++;
    List<String> words = new ArrayList<>(List.of("dataset", "csv"));
    for (String word : GuideShell.words(options)) {
      words.add(word.equals("LOG") ? folder.resolve("log.csv").toString() : word);
    }
    words.addAll(List.of("--out", folder.resolve("set" + made).toString()));
    return Shell.simbad(words.toArray(String[]::new));
  }

  private DataSet read(String text, String options) throws Exception {
    Shell said = type(text, options);
    assertEquals(0, said.status(), said.err());
    return last();
  }

  /** As the diagnosis takes it. */
  private DataSet last() throws Exception {
    return new DataSetFolder(folder.resolve("set" + made)).read();
  }

  private String file(String name) throws Exception {
    return Files.readString(folder.resolve("set" + made).resolve(name));
  }

  private static String ranges(DataSet data) {
    return data.readings().stream()
        .map(row -> row.reading() instanceof Echo echo ? number(echo.rangeM()) : "-")
        .collect(Collectors.joining(" "));
  }

  private static String poses(DataSet data) {
    return data.readings().stream()
        .map(
            row ->
                number(row.pose().position().xM())
                    + ","
                    + number(row.pose().position().zM())
                    + ","
                    + Math.round(row.pose().heading().degrees()))
        .collect(Collectors.joining(" "));
  }

  private static String number(double value) {
    String text = String.format(Locale.ROOT, "%.4f", value).replaceFirst("\\.?0+$", "");
    return text.equals("-0") ? "0" : text;
  }

  /** What the simulator expects where a row was taken. */
  private static double expectedM(DataSet data, int row) {
    NominalModel model = new NominalModel(data.setup().sensor(), data.setup().scene());
    return model.sight(0, data.readings().get(row).pose()).nearestM().orElseThrow();
  }

  @Test
  void twoColumns_areEnough() throws Exception {
    Shell said = type(LADDER, "");
    assertEquals(0, said.status(), said.err());
    assertEquals("0.098 0.197 -", ranges(last()));
    assertEquals("0,0.1,90 0,0.2,90 0,0.3,90", poses(last()));
    assertEquals(0.2, expectedM(last(), 1), 1e-9);
    assertTrue(
        said.out()
            .contains(
                "read 3 readings from 3 rows: 2 echoes at 0.098 to 0.197 m, 1 without echo;"
                    + " 3 places, 1 run, no times"),
        said.out());
  }

  /** Readings scatter beside a tape, and a tape does not beside readings. */
  @Test
  void exchangedColumns_areRefused_unlessSaid() throws Exception {
    StringBuilder log = new StringBuilder("tape_cm,sensor_cm\n");
    Random random = new Random(1);
    for (int i = 0; i < 60; i++) {
      double tape = 20 + 10 * (i / 6);
      log.append(number(tape + 0.3 * random.nextGaussian())).append(',').append(tape).append('\n');
    }
    Shell said = type(log.toString(), "");
    assertEquals(2, said.status(), said.out());
    assertTrue(said.err().contains("are they exchanged?"), said.err());
    assertEquals(0, type(log.toString(), "--range sensor_cm --distance tape_cm").status());
    String right = log.toString().replace("tape_cm,sensor_cm", "sensor_cm,tape_cm");
    assertEquals(0, type(right, "").status());
  }

  /** A ring of sensors pings once where the robot is; nobody put anything in place there. */
  @Test
  void ringOfSensors_hasNoPlacements() throws Exception {
    StringBuilder log = new StringBuilder("t_s,x_m,y_m,heading_deg,left_cm,right_cm\n");
    for (int i = 0; i < 5; i++) {
      log.append(0.2 * i).append(',').append(0.1 * i).append(",0,90,50,60\n");
    }
    String ring =
        "--range left_cm,right_cm --x x_m --y y_m --heading heading_deg --target board:1m@0,2m"
            + " --mount left_cm=0,-9cm,60deg --mount right_cm=0,9cm,-60deg";
    DataSet drive = read(log.toString(), ring + " --time t_s");
    assertTrue(drive.readings().get(0).circumstances().placement().isEmpty());
    DataSet untimed = read(log.toString(), ring);
    assertTrue(untimed.readings().get(0).circumstances().placement().isPresent());
  }

  /** A servo turns a sensor that was put there once; of few places nothing is known of each. */
  @Test
  void directionsFromOnePlace_areOnePlacement() throws Exception {
    String pans = "--range cm --range-unit cm --distance d_cm --pan pan_deg --target board:1m";
    DataSet scans = read(scans(4), pans);
    assertEquals("p1 p1 p1 p2 p2 p2 p3 p3 p3 p4 p4 p4", placements(scans));
    assertTrue(file("scene.json").contains("nothing was moved, only turned"), file("scene.json"));
    assertEquals("p1 p2 p3 p4 p5 p6 p7 p8 p9 p9", placements(read(scans(3) + "30,16,30\n", pans)));
    DataSet drive =
        read(
            scans(4),
            "--range cm --range-unit cm --x 0m --y d_cm --pose-unit cm --heading pan_deg"
                + " --period 60ms --target board:1m@0,-3m");
    assertTrue(drive.readings().get(0).circumstances().placement().isEmpty());
  }

  private static String scans(int places) {
    StringBuilder log = new StringBuilder("d_cm,pan_deg,cm\n");
    for (int i = 0; i < 3 * places; i++) {
      int distance = 10 * (1 + i / 3);
      log.append(distance)
          .append(',')
          .append(8 * (i % 3))
          .append(',')
          .append(distance)
          .append('\n');
    }
    return log.toString();
  }

  private static String placements(DataSet data) {
    return data.readings().stream()
        .map(row -> row.circumstances().placement().orElse(""))
        .collect(Collectors.joining(" "));
  }

  /** A servo's angle is known to a degree, unless it is said otherwise; a drive's is not asked. */
  @Test
  void headingsOfAScan_areKnownToADegree() throws Exception {
    StringBuilder log = new StringBuilder("angle,x_m,cm\n");
    for (int i = 0; i < 6; i++) {
      log.append(70 + 10 * i).append(',').append(0.1 * i).append(",80\n");
    }
    String scan = "--range cm --heading angle --y 0cm --target round:6cm@0,-80cm ";
    Shell said = type(log.toString(), scan + "--x 0cm");
    assertEquals(0, said.status(), said.err());
    assertEquals(1, sigmaDeg(last()), 1e-9);
    assertTrue(said.out().contains("assumed: Headings are known to 1.0 degree"), said.out());
    assertEquals(0, sigmaDeg(read(log.toString(), scan + "--x 0cm --heading-sigma 0deg")));
    assertEquals(0, sigmaDeg(read(log.toString(), scan + "--x x_m")));
  }

  private static double sigmaDeg(DataSet set) {
    return Math.toDegrees(set.setup().details().headingSigmaRad());
  }

  /** A sensor has its column's name, with its unit or without; each needs a mount. */
  @Test
  void mounts_areFoundByTheColumnsNames() throws Exception {
    String log = "t_s,x_m,y_m,heading_deg,left_cm,right [cm]\n0,0,0,90,50,60\n1,0.1,0,90,51,61\n";
    String ring =
        "--range 5,6 --range-unit cm --x x_m --y y_m --heading heading_deg --time t_s"
            + " --target board:1m@0,2m --mount left=0,-9cm,60deg";
    DataSet set = read(log, ring + " --mount right=0,9cm,-60deg");
    assertEquals(
        Set.of("left", "right"),
        set.readings().stream().map(ReadingRow::sensor).collect(Collectors.toSet()));
    Shell one = type(log, ring);
    assertEquals(2, one.status(), one.out());
    assertTrue(one.err().contains("column 'right [cm]' is a sensor without one"), one.err());
  }

  /** The sonar's greatest range counts from what is nearest, wherever the centre is. */
  @Test
  void wideTarget_isHeardAsFarAsTheSonarReaches() throws Exception {
    DataSet set = read(LADDER, "--max-range 3m --target board:2m");
    NominalModel model = new NominalModel(set.setup().sensor(), set.setup().scene());
    SightLine line = new SightLine();
    TransducerPose from = new TransducerPose();
    from.aim(0.9, 2.98, Math.PI / 2);
    model.trace(0, from, line);
    double heard =
        model.echoProbability(line.nearestM(), line.centreDistanceM(), line.thresholdM());
    assertEquals(2.98, line.nearestM(), 0.03);
    assertTrue(heard > 0.9, "heard with " + heard);
  }

  /** What stands beside the readings is a tape's distance by its name, or goes with them. */
  @ParameterizedTest
  @CsvSource({
    "temp_c, false",
    "sec, false",
    "vcc, false",
    "angle, false",
    "nr, false",
    "foo, true",
    "cm, true"
  })
  void secondColumn_isTheDistanceWhereItMayBe(String name, boolean isTaken) throws Exception {
    Shell said = type(name + ",distance_cm\n10,9.8\n20,19.7\n30,29.9\n", "");
    assertEquals(isTaken ? 0 : 2, said.status(), said.err());
    assertEquals(!isTaken, said.err().contains("--distance"), said.err());
  }

  @Test
  void secondColumn_thatDoesNotGoWithTheReadings_isNoDistance() throws Exception {
    Shell said = type("foo,distance_cm\n22,10.1\n21,19.7\n22,29.9\n23,19.8\n21,30.1\n", "");
    assertEquals(2, said.status(), said.out());
    assertTrue(said.err().contains("--distance"), said.err());
  }

  /** No time is invented, what is assumed is said, and stands in the scene. */
  @Test
  void assumptions_areWritten() throws Exception {
    Shell said = type(LADDER, "");
    List<String> assumed = last().setup().details().assumptions();
    assertTrue(assumed.size() >= 6, assumed.toString());
    assumed.forEach(one -> assertTrue(said.out().contains("assumed: " + one + "\n"), one));
    assertTrue(assumed.get(0).contains("'reading_cm'"), assumed.toString());
    assertFalse(last().readings().get(0).isTimed());
    assertTrue(file("readings.csv").startsWith("run,sensor,x_m,z_m,heading_deg,range_m,true_cm\n"));
    assertTrue(file("scene.json").contains("\"format\" : \"sonar-gap/2\""));
    assertEquals(0.001, last().setup().sensor().resolutionM());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "--target 'board:40cm x 20cm' --sonar srf04 --only 'true_cm=5..25' --period 60ms",
        "--range 2 --distance 1 --no-echo '0,765,>=400' --pose-sigma 2mm --moves target"
      })
  void printedCommand_makesTheSameBytes(String options) throws Exception {
    Shell said = type(LADDER, options);
    assertEquals(0, said.status(), said.err());
    String scene = file("scene.json");
    String readings = file("readings.csv");
    String again =
        said.out()
            .lines()
            .filter(line -> line.startsWith("again: ./simbad "))
            .findFirst()
            .orElseThrow();
    List<String> words = new ArrayList<>(List.of(GuideShell.words(again.substring(16))));
    words.set(words.size() - 1, folder.resolve("again").toString());
    assertEquals(0, Shell.simbad(words.toArray(String[]::new)).status());
    assertEquals(scene, Files.readString(folder.resolve("again/scene.json")));
    assertEquals(readings, Files.readString(folder.resolve("again/readings.csv")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "true_cm;reading_cm\\n10;9,8\\n20;19,7\\n30;\\n | ''",
        "true_cm\\treading_cm\\n10\\t9.8\\n20\\t19.7\\n30\\tNaN\\n | ''",
        "true_cm   reading_cm\\n 10  9.8\\n 20\\t19.7\\n 30 none\\n | ''",
        "# by hand\\r\\ntrue_cm,reading_cm\\r\\n10,9.8\\r\\n\\r\\n// moved\\r\\n20,19.7\\r\\n30,-1\\r\\n"
            + " | --no-echo -1",
        "10,9.8\\n20,19.7\\n30,out of range\\n | --range-unit cm",
        "Rangefinder 3; 4 May\\ntrue_cm,reading_cm\\n10,9.8\\n20,19.7\\n30,765\\n"
            + " | --skip 1 --no-echo 765",
        "n,true [cm],d [mm]\\n1,10,98\\n2,20,197\\n3,30,4000\\n | --range 3 --distance 2 --no-echo >=4000",
        "true,d\\n10,9.8 cm\\n20,19.7 cm\\n30,\\n | --distance-unit cm",
        "true_cm,\"reading, cm\"\\n\"10\",9.8\\n20,\"19.7\"\\n30,\\n | --range 2",
        "true_cm,ms\\n10,0.56843387\\n20,1.14269142\\n30,0\\n"
            + " | --range ms --range-unit ms --sound-speed 344.8 --no-echo 0",
        "true_cm,reading_cm\\n10,9.8\\ngarbage\\n20,19.7\\n30,\\n | --skip-bad"
      })
  void ladder_isTheSame_howeverItIsWritten(String text, String options) throws Exception {
    DataSet data =
        read(text.replace("\\n", "\n").replace("\\t", "\t").replace("\\r", "\r"), options);
    assertEquals("0.098 0.197 -", ranges(data));
    assertEquals("0,0.1,90 0,0.2,90 0,0.3,90", poses(data));
  }

  @ParameterizedTest
  @ValueSource(strings = {"UTF-8", "UTF-16", "UTF-16LE", "UTF-16BE", "ISO-8859-1"})
  void encoding_isFound(String encoding) throws Exception {
    String text = "wahr_cm,gemessen f\u00fcr \u00b5C_cm\n10,9.8\n20,19.7\n30,\n";
    String ascii = text.replace("\u00fc", "ue").replace("\u00b5", "u");
    Shell said = type(text.getBytes(encoding), "--range 2 --distance 1 --target board:1m");
    assertEquals(0, said.status(), encoding + said.err());
    assertEquals("0.098 0.197 -", ranges(last()));
    byte[] marked = ("\uFEFF" + ascii).getBytes(StandardCharsets.UTF_8);
    assertEquals(0, type(marked, "--range 2 --distance wahr_cm").status());
  }

  @Test
  void gzip_isUnpacked_andFilesAreOneLog() throws Exception {
    ByteArrayOutputStream packed = new ByteArrayOutputStream();
    try (GZIPOutputStream out = new GZIPOutputStream(packed)) {
      out.write(LADDER.getBytes(StandardCharsets.UTF_8));
    }
    Path second = Files.write(folder.resolve("second.csv.gz"), packed.toByteArray());
    Files.writeString(folder.resolve("log.csv"), LADDER);
    assertEquals(0, type("LOG " + second).status());
    assertEquals(
        List.of("log", "second"),
        last().readings().stream().map(ReadingRow::run).distinct().toList());
    byte[] cut = java.util.Arrays.copyOf(packed.toByteArray(), packed.size() - 9);
    Files.write(second, cut);
    Shell said = type("" + second);
    assertEquals(2, said.status());
    assertTrue(said.err().contains("second.csv.gz: is not a complete gzip file"), said.err());
  }

  /** A logger that was started again writes its header again. */
  @Test
  void headerThatComesAgain_beginsARun() throws Exception {
    DataSet data = read(LADDER + LADDER, "");
    assertEquals(6, data.readings().size());
    assertEquals("log-2", data.readings().get(5).run());
  }

  @Test
  void repeatsInALine_areOnePlacement() throws Exception {
    DataSet data =
        read(
            "d_cm,m1,m2,m3,note\n10,9,10,11,a\n20,19,20,,b\n",
            "--range m1-m3 --range-unit cm --distance d_cm");
    assertEquals("0.09 0.1 0.11 0.19 0.2 -", ranges(data));
    assertEquals("p1 p1 p1 p2 p2 p2", placements(data));
    assertTrue(file("readings.csv").contains(",placement,d_cm,note\n"), file("readings.csv"));
    assertTrue(file("readings.csv").contains(",p2,20,b\n"));
    assertEquals(0.01, data.setup().sensor().resolutionM());
  }

  @Test
  void distancesInTheHeader_areALadder() throws Exception {
    DataSet data =
        read(
            "10cm,0.2 m\n9.8,19.7\n9.9,\n",
            "--range 1-2 --range-unit cm --distance header --header yes");
    assertEquals("0.098 0.099 0.197 -", ranges(data));
    assertEquals("0,0.1,90 0,0.1,90 0,0.2,90 0,0.2,90", poses(data));
  }

  /** A distance to a round post's face; to its centre it is half of its 40 mm less. */
  @Test
  void distance_isToSurfaceOrCentre() throws Exception {
    assertEquals(0.2, expectedM(read(LADDER, "--target round:40mm"), 1), 1e-9);
    assertEquals(
        0.18, expectedM(read(LADDER, "--target round:40mm --distance-to centre"), 1), 1e-9);
    assertEquals(0.2, expectedM(read(LADDER, "--target square:50mm"), 1), 1e-9);
    assertEquals(0.2, expectedM(read(LADDER, "--target round:40mm --moves target"), 1), 1e-9);
    assertTrue(file("readings.csv").contains(",0.0000,0.0000,90.000,0.1970,0.0000,-0.2200,0.000,"));
  }

  /** A plate that turns clockwise shows its left side, as seen from the sensor. */
  @Test
  void turntable_turnsTheTarget() throws Exception {
    DataSet data =
        read(
            "angle,cm\n0,50\n30,51\n90,\n",
            "--target-turn angle --distance 50cm --range cm --range-unit cm --target board:20cm"
                + " --angle-positive cw");
    assertEquals("0.5 0.51 -", ranges(data));
    Obstacle board = data.setup().scene().obstacles().get(0);
    Point seen = data.readings().get(1).pose().position();
    assertEquals(
        Math.toRadians(30), board.worldFromObstacle().bearingRad(seen.xM(), seen.zM()), 1e-4);
    assertTrue(file("readings.csv").contains("obstacle_turn_deg"));
    assertTrue(file("readings.csv").contains(",-30.000,"));
  }

  /** A grid seen from above, y up the page, the target somewhere in the middle. */
  @Test
  void grid_isPlacedRoundItsTarget() throws Exception {
    String grid = "x_mm,y_mm,d_cm\n100,100,\n100,600,40\n";
    String options = "--range d_cm --x x_mm --y y_mm --origin 100,200 --target round:30mm";
    assertEquals("0,0.1,90 0,-0.4,-90", poses(read(grid, options)));
    assertEquals("0,0.1,0 0,-0.4,0", poses(read(grid, options + " --heading 0deg")));
    String down = options.replace("--y", "--z");
    assertEquals("0,-0.1,-90 0,0.4,90", poses(read(grid, down)));
  }

  @ParameterizedTest
  @CsvSource({
    "'', 0 30 90",
    "--angle-positive cw, 0 -30 -90",
    "--angle-zero up --angle-positive cw, 90 60 0",
    "--angle-zero down, -90 -60 0",
    "--angle-zero 10deg --angle-unit gon, 10 37 91"
  })
  void headings_turnAsTheyAreSaid(String options, String degrees) throws Exception {
    DataSet data =
        read(
            "x,h,d\n0,0,1\n0,30,1\n0,90,1\n",
            "--range d --range-unit m --x x --z 1m --heading h --target board:1m " + options);
    assertEquals(
        degrees,
        data.readings().stream()
            .map(row -> Long.toString(Math.round(row.pose().heading().degrees())))
            .collect(Collectors.joining(" ")));
  }

  @Test
  void panningServo_turnsFromTheTarget() throws Exception {
    DataSet data =
        read(
            "servo_rad,cm\n0,30\n0.5235988,31\n",
            "--pan servo_rad --distance 30cm --range cm --range-unit cm --target board:1m");
    assertEquals("0,0.3,90 0,0.3,120", poses(data));
  }

  @Test
  void bearing_goesRoundTheTarget() throws Exception {
    DataSet data =
        read(
            "b,d_m,r_m\n0,1,0.9\n90,1,0.9\n",
            "--bearing b --distance d_m --range r_m --target angle");
    assertEquals("0,1,90 1,0,180", poses(data));
  }

  /** Robot's poses stay in the file, sensors get mounts, the diagnosis sees the sensors' poses. */
  @Test
  void mounts_areOfTheSensors() throws Exception {
    DataSet data =
        read(
            "t_ms,x_m,y_m,th,front,left\n0,1,-2,90,50,60\n100,1,-1,90,51,\n",
            "--time t_ms --x x_m --y y_m --heading th --range front,left --range-unit cm"
                + " --mount front=10cm,0 --mount left=0,-5cm,90deg --target wall:2m@0,-1");
    assertEquals("0.5 0.6 0.51 -", ranges(data));
    assertEquals("1,1.9,90 0.95,2,180 1,0.9,90 0.95,1,180", poses(data));
    assertTrue(file("readings.csv").contains("log,left,0.100,1.0000,1.0000,90.000,,"));
    assertEquals(0.1, data.readings().get(2).timeS(), 1e-9);
    assertTrue(file("scene.json").contains("\"sensors\""));
  }

  @Test
  void targetThatIsMoved_standsElsewhereInEachRow() throws Exception {
    DataSet data =
        read(
            "tx_cm,ty_cm,d_cm\n0,100,100\n0,50,50\n",
            "--target-x tx_cm --target-y ty_cm --heading 90deg --range d_cm --target board:1m");
    assertEquals("0,1,90 0,0.5,90", poses(data));
    assertEquals(0.5, expectedM(data, 1), 1e-9);
  }

  @Test
  void temperatureAndPause_areKept() throws Exception {
    DataSet data =
        read(
            "d_cm,r_cm,T,gap\n10,10,21.5,5\n20,20,,\n",
            "--distance d_cm --range r_cm --temperature T --pause-ms gap --gap-ms 60ms"
                + " --compensated true --sound-speed 340 --height 14.5cm");
    assertEquals(21.5, data.readings().get(0).circumstances().temperatureC().orElseThrow());
    assertEquals(0.005, data.readings().get(0).circumstances().pauseS().orElseThrow(), 1e-9);
    assertEquals(0.06, data.readings().get(1).circumstances().gapS().orElseThrow(), 1e-9);
    assertTrue(data.readings().get(1).circumstances().temperatureC().isEmpty());
    assertEquals(true, data.setup().details().temperatureCompensated().orElseThrow());
    assertEquals(340, data.setup().sensor().assumedSoundSpeedMPerS());
    assertEquals(0.145, data.setup().sensor().mountHeightM());
  }

  @ParameterizedTest
  @CsvSource({
    "2021-03-04 12:00:01.5, 2021-03-04 12:01:01.25, 59.75",
    "2021/03/04T12:00:01Z, 2021-03-04T12:00:02+0000, 1",
    "23:00:01, 23:00:03.000125, 2.000125",
    "1616161616.5, 1616161617, 1616161617"
  })
  void time_isReadAsItStands(String first, String second, double secondS) throws Exception {
    DataSet data =
        read(
            "t,d,r\n" + first + ",10,9\n" + second + ",20,19\n",
            "--time t --time-unit s --distance d --range r --range-unit cm");
    assertEquals(secondS, data.readings().get(1).timeS(), 1e-6);
  }

  @Test
  void timeThatRepeats_isLeftOut() throws Exception {
    DataSet data =
        read(
            "t_s,d,r\n1,10,9\n1,10,9\n2,20,19\n",
            "--time t_s --distance d --range r --range-unit cm");
    assertFalse(data.readings().get(0).isTimed());
    assertTrue(data.setup().details().assumptions().toString().contains("1.0 s appears twice"));
    DataSet paced = read(LADDER, "--period 50ms");
    assertEquals(0.1, paced.readings().get(2).timeS(), 1e-9);
    assertEquals(0.05, paced.setup().sensor().updatePeriodS());
    assertEquals("SRF04", read(LADDER, "--sensor srf-04").setup().sensor().name());
  }

  @Test
  void shapesAndDetection_areAsNamed() throws Exception {
    SensingSetup setup =
        read(LADDER, "--target 'board:1.2m x 0.4m' --height 50cm --detection uniform:2.5m").setup();
    Obstacle board = setup.scene().obstacles().get(0);
    assertEquals(0.3, board.extent().bottomM(), 1e-12);
    assertEquals(0.7, board.extent().topM(), 1e-12);
    assertEquals(2.5, board.detection().greatestM());
    Obstacle angle =
        read(LADDER, "--target angle --detection angle").setup().scene().obstacles().get(0);
    assertTrue(angle.detection().findTable().isPresent());
    Files.writeString(folder.resolve("own.csv"), "x_mm,z_mm\n-5,-5\n5,-5\n0,5\n");
    Obstacle own =
        read(LADDER, "--target " + folder.resolve("own.csv")).setup().scene().obstacles().get(0);
    assertEquals(3, own.outline().size());
    // The sonar's reach, from its nearest point: its farthest corner and ten soft edges of 3 cm
    // more.
    double corner = Math.hypot(0.005, 0.005);
    assertEquals(4 + corner + 0.3, own.detection().greatestM(), 1e-9);
  }

  /** What was written once can be brought in again, with its scene. */
  @Test
  void dataSet_comesBack() throws Exception {
    Path kept = Path.of("..", "data", "gap", "hankb");
    assertEquals(
        0,
        type(kept.resolve("readings.csv")
                + " --range range_m --time t_s --x x_m --z z_m --heading heading_deg --run run"
                + " --sensor sensor --scene "
                + kept.resolve("scene.json"))
            .status());
    DataSet before = new DataSetFolder(kept).read();
    assertEquals(before.setup().scene(), last().setup().scene());
    assertEquals(before.setup().sensor(), last().setup().sensor());
    for (int i = 0; i < before.readings().size(); i++) {
      ReadingRow one = before.readings().get(i);
      ReadingRow other = last().readings().get(i);
      assertEquals(
          List.of(one.run(), one.sensor(), one.timeS(), one.pose(), one.reading()),
          List.of(other.run(), other.sensor(), other.timeS(), other.pose(), other.reading()));
    }
  }

  /** Rows without times: a verdict, and nothing that remembers. */
  @Test
  void untimedLog_isDiagnosed() throws Exception {
    StringBuilder log = new StringBuilder("true_cm,reading_cm\n");
    for (int i = 0; i < 100; i++) {
      double distance = 10 + 10 * (i / 10);
      log.append(
          distance + "," + Math.round(10 * (0.95 * distance - 1 + 0.1 * (i % 3))) / 10.0 + "\n");
    }
    read(log.toString(), "");
    Shell said =
        Shell.simbad(
            "diagnose",
            folder.resolve("set" + made).toString(),
            "--out",
            folder.resolve("diagnoses").toString());
    assertEquals(0, said.status(), said.err());
    assertFalse(said.out().contains("previous-ping"), said.out());
    assertFalse(said.out().contains("stale-reading"), said.out());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "a,b,c\\n1,2,3\\n | '' | --range: is missing: which column holds the sensor's readings; saw 1 a (1)",
        "true,reading\\n1,2\\n | '' | --range-unit: is missing: cm, mm, m, in, us or another; saw column 2,",
        "x,reading_cm,q\\n1,2,3\\n | '' | --distance: is missing: which column holds the true distance",
        "true_cm,reading_cm\\n1,2\\n | --pan 1 | --target: is missing: what the sensor looked at",
        "true_cm,reading_cm\\n1,2\\n | --range far | log.csv:1: far: column is missing; found 1 true_cm (1)",
        "true_cm,reading_cm\\n1,2\\n | --range 3 | log.csv:1: 3: column is missing",
        "true_cm,reading_cm,reading_cm\\n1,2,3\\n | --range reading_cm | appears "
            + "twice; give its number",
        "true_cm,reading_cm\\n1,2\\n3,far\\n | '' | log.csv:3: reading_cm: 'far' is not a number of at least 0",
        "true_cm,reading_cm\\n1,-5\\n | '' | log.csv:2: reading_cm: '-5' is not a number of at least 0",
        "true_cm,reading_cm\\n1,1e300\\n | '' | log.csv:2: reading_cm: '1e300' is not",
        "true_cm,reading_cm\\n-1,5\\n | '' | log.csv:2: true_cm: '-1' is not a number of at least 0",
        "true_cm,reading_cm\\n1,2\\n3\\n | '' | log.csv:3: reading_cm: the row ends before this column",
        "true_cm,reading_cm\\n1,2,7\\n | '' | log.csv:2: reading_cm: 3 fields in the row, expected 2",
        "true_cm,reading_cm\\n | '' | log.csv: has no rows",
        "'' | '' | log.csv: holds no line of a table",
        "true_cm,reading_cm\\n1,\"2\\n3,4\\n | '' | log.csv:2: reading_cm: '2 3,4' is not a number",
        "true_cm,reading_cm\\n1,2\\n | --range-unit yard | --range-unit: 'yard' is not one of m, cm",
        "true_cm,reading_cm\\n1,2\\n | --target tree | --target: 'tree' is none of board:1.2m",
        "true_cm,reading_cm\\n1,2\\n | --target board:1.2 | --target: '1.2' is not a number with its unit",
        "true_cm,reading_cm\\n1,2\\n | --target board:1km | --target: '1km' is not a number with its unit",
        "true_cm,reading_cm\\n1,2\\n | --sonar bat | --sonar: 'bat' is neither hc-sr04, srf04",
        "true_cm,reading_cm\\n1,2\\n | --max-range 1cm | --max-range: the least range of 0.02 m is not below",
        "true_cm,reading_cm\\n1,2\\n | --max-range 4 | --max-range: '4' is not a number with its unit",
        "true_cm,reading_cm\\n1,2\\n | --cone 500deg | --cone: 500.0 degrees is not in (0, 180]",
        "true_cm,reading_cm\\n1,2\\n | --sound-speed 3 | --sound-speed: '3' is not a number in [100.0, 2000.0]",
        "true_cm,reading_cm\\n1,2\\n | --separator bean | --separator: 'bean' is not one of comma",
        "true_cm,reading_cm\\n1,2\\n | --encoding morse | --encoding: 'morse' is not an encoding",
        "true_cm,reading_cm\\n1,2\\n | --skip -1 | --skip: '-1' is not a number in [0.0, 1000000.0]",
        "true_cm,reading_cm\\n1,2\\n | --only true_cm | --only: 'true_cm' is not COLUMN=VALUE",
        "true_cm,reading_cm\\n1,2\\n | --only true_cm=7 | log.csv: no row is left to read",
        "true_cm,reading_cm\\n1,2\\n | --origin 1 | --origin: '1' is not X,Z",
        "true_cm,reading_cm\\n1,2\\n | --mount left | --mount: 'left' is not SENSOR=X,Z,TURN",
        "true_cm,reading_cm\\n1,2\\n | --time true_cm | --time-unit: is missing: s, ms, us",
        "t,true_cm,reading_cm\\nsoon,1,2\\n | --time t | log.csv:2: t: 'soon' is neither a number nor a time",
        "t,true_cm,reading_cm\\n9e15,1,2\\n | --time t --time-unit s | --time-unit: gives times beyond",
        "true_cm,reading_cm\\n1,2\\n | --x 1 --distance true_cm --bearing 1deg --target 'board:1m@1,2,3,4'"
            + " | --target: '1,2,3,4' is not X,Z,TURN",
        "true_cm,reading_cm\\n1,2\\n | --target board:1m --target board:2m | overlaps board; @X,Z,TURN",
        "true_cm,reading_cm\\n1,2\\n | --scene none.json | --scene: 'none.json' is not a file",
        "true_cm,reading_cm\\n1,2\\n | --scene none.json --cone 3deg | --cone: does not go with --scene",
        "true_cm,reading_cm\\n1,2\\n | --no-echo >=far | --no-echo: '>=far' is not a number",
        "true_cm,reading_cm\\n1,2\\n | --no-echo 0,x | --no-echo: 'x' is neither a number as it stands in",
        "true_cm,reading_cm\\n1,2\\n | --no-echo 4m | --no-echo: '4m' is neither a number as it stands in",
        "true_cm,reading_cm\\n1,2\\n | --pause-ms 5 | --pause-ms: '5' is neither a column nor a value with its unit, such as 60ms",
        "true_cm,reading_cm\\n1,2\\n | --distance 30 | --distance: '30' is neither a column nor a value with its unit, such as 30cm",
        "a,b\\n1,2\\n | '' | --range: is missing: which column holds the sensor's readings; saw 1 a (1), 2 b (2)",
        "a,b\\n1,2\\n | --range-unit cm | --range: is missing: which column",
        "10,9\\n | '' | --range-unit: is missing: cm, mm, m, in, us or another; saw column 2, 'column2': 9 (taken for the ranges",
        "a,b\\nfoo,bar\\n | '' | log.csv: no column holds numbers, expected ranges; found 1 a (foo)",
        "x,r_cm\\n1,2\\n | --x x --range r_cm --target board:1m | --z: is missing: a place is --x with --z"
      })
  void badInput_isOneLine(String text, String options, String problem) throws Exception {
    Shell said = type(text.replace("\\n", "\n"), options);
    assertEquals(2, said.status(), said.out() + said.err());
    assertEquals(1, said.complaints().size(), said.err());
    assertTrue(said.err().contains(problem), said.err());
    assertFalse(Files.exists(folder.resolve("set" + made)));
  }

  @ParameterizedTest
  @CsvSource({
    "reading_cm, 0.05",
    "'reading [mm]', 0.005",
    "'reading in', 0.127",
    "reading (us), 0.001",
    "reading metres, 5",
    "reading-m, 5"
  })
  void unit_isTakenFromTheName(String name, double rangeM) throws Exception {
    DataSet data =
        read("true_cm," + name + "\n10,5\n", "--sonar maxbotix-lv-ez1 --sound-speed 400");
    assertEquals(new Echo(rangeM), data.readings().get(0).reading());
  }

  @ParameterizedTest
  @ValueSource(strings = {"reading_min", "reading", "read", "reading turn"})
  void name_thatEndsWithNoUnit_asksForIt(String name) throws Exception {
    Shell said = type("true_cm," + name + "\n10,5\n", "");
    assertTrue(said.err().contains("--range-unit: is missing"), said.err());
  }

  /** A column of names is none of ranges, whatever it is called. */
  @Test
  void sensorsNames_areNoRanges() throws Exception {
    String log = "sensor,true_cm,reading_cm\nleft,10,9.8\nright,20,19.7\n";
    assertEquals("0.098 0.197", ranges(read(log, "")));
    assertEquals("right", read(log, "--sensor sensor").readings().get(1).sensor());
  }

  /** The ranges stand in no column that something else is said to be in. */
  @Test
  void columnOfAnotherOption_isNoRange() throws Exception {
    String scan = " --x 0cm --y 0cm --target round:6cm@0,-80cm";
    assertEquals("0.8 0.79", ranges(read("angle,cm\n90,80\n80,79\n", "--heading angle" + scan)));
    assertEquals("0.8 0.79", ranges(read("cm,a\n80,90\n79,80\n", "--heading 2" + scan)));
    Shell none = type("a,b\n90,80\n80,79\n", "--heading a --time b --time-unit s" + scan);
    assertEquals(2, none.status());
    assertTrue(none.err().contains("no column but those of other options"), none.err());
    Shell unread = type("a,cm\n90,80\n80,79\n", "--pan a --distance cm --range cm");
    assertEquals(2, unread.status(), unread.out());
  }

  /** What cannot be guessed is asked for, in the order in which it is needed. */
  @Test
  void person_isAsked() throws Exception {
    Files.writeString(folder.resolve("log.csv"), "a,b,c\n10,9.8,1\n20,19.7,1\n");
    StringWriter said = new StringWriter();
    LogImport.Made answered =
        LogImport.of(
            List.of(folder.resolve("log.csv")),
            new LogSettings(Map.of("heading", List.of("90deg"))),
            new TerminalQuestions(
                new BufferedReader(new StringReader("b\n\ncm\na\nround:3cm\n")),
                new PrintWriter(said)));
    assertEquals(2, answered.data().readings().size());
    assertEquals(
        "--heading 90deg --range b --range-unit cm --distance a --target round:3cm",
        String.join(" ", answered.settings().words()));
    assertTrue(said.toString().contains("--range, which column holds the sensor's readings? "));
  }

  @Test
  void oddities_areNoted() throws Exception {
    Shell said = type("true_cm,reading\n10,9.8\n20,1270\n30,0\n", "--range-unit cm");
    assertEquals(0, said.status(), said.err());
    assertTrue(said.err().contains("note: 1 range beyond the sonar's 4.0 m"), said.err());
    assertTrue(
        said.err().contains("note: 1 range of 0; if 0 means no echo: --no-echo 0"), said.err());
  }

  @Test
  void noLog_isSaid() {
    assertEquals(2, Shell.simbad("dataset", "csv", "--out", "x").status());
    assertEquals(2, type("LOG").status());
    assertEquals(2, type("" + folder).status());
  }

  /** The longest line there is, and as many rows as a day of pings has. */
  @Test
  void manyRows_andHugeCells_areReadOrRefused() throws Exception {
    assertEquals(2, type("true_cm,reading_cm\n1," + "9".repeat(100_000) + "\n", "").status());
    assertEquals(2, type("true_cm,reading_cm\n1," + "9".repeat(20_000_000) + "\n", "").status());
    byte[] row = "10,9.8\n".getBytes(StandardCharsets.UTF_8);
    ByteArrayOutputStream many = new ByteArrayOutputStream();
    many.writeBytes("true_cm,reading_cm\n".getBytes(StandardCharsets.UTF_8));
    for (int i = 0; i < 100_000; i++) {
      many.writeBytes(row);
    }
    Shell said = type(many.toByteArray(), "");
    assertEquals(0, said.status(), said.err());
    assertTrue(said.out().contains("read 100000 readings"), said.out());
  }

  /** Pauses order the pings of a place; nothing is moved within two milliseconds. */
  @Test
  void pausesMakeTimes_inRunsOfPingsThatFollowedEachOther() throws Exception {
    String log = "true_cm,reading_cm,pause\n34.3,34.3,2\n34.3,,2\n34.3,34.3,2\n50,50,2\n50,50,2\n";
    DataSet data = read(log, "--pause-ms pause --max-range 3.43m --sound-speed 343");
    assertTrue(file("scene.json").contains("pings that followed each other"));
    List<ReadingRow> rows = data.readings();
    assertEquals(List.of("log-1", "log-1", "log-1", "log-2", "log-2"), runs(rows));
    // There and back of 34.3 cm, and of the greatest range where nothing came, at 343 m/s.
    assertEquals(0.004, rows.get(1).timeS(), 1e-6);
    assertEquals(0.026, rows.get(2).timeS(), 1e-6);
    assertEquals(0, rows.get(3).timeS());
  }

  private static List<String> runs(List<ReadingRow> rows) {
    return rows.stream().map(ReadingRow::run).toList();
  }
}
