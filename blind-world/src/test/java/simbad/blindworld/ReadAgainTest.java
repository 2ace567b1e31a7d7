package simbad.blindworld;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.blindworld.baseline.DataSet;
import simbad.blindworld.file.Csv;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.World;

/** Worlds that were drawn, read again at other poses, and scored: from the command line. */
class ReadAgainTest {
  private static final String ASKED = "next-experiment.csv";
  private static final String HEADER = "run,sensor,t_s,x_m,z_m,heading_deg\n";

  /** The scale of one offset, in all its forms, is beyond the noise of a mean. */
  private static final double PLAIN_M = 0.01;

  private static Path folder = Path.of("");
  private static Path world = Path.of("");
  private static String id = "";

  private record Done(int status, String err) {}

  private static Done run(String... arguments) {
    ByteArrayOutputStream err = new ByteArrayOutputStream();
    int status =
        Main.run(
            arguments,
            new PrintStream(new ByteArrayOutputStream(), true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8));
    return new Done(status, err.toString(StandardCharsets.UTF_8));
  }

  private static Done generate(String options, Path to, String... more) {
    List<String> all = new ArrayList<>(List.of("generate", "--out", to.toString()));
    all.addAll(List.of(options.split(" ")));
    all.addAll(List.of(more));
    return run(all.toArray(String[]::new));
  }

  private static final String ORDER =
      "--cases 1 --seed 13 --rows 300-320 --repeats 40 --mix single:1 --effects range-offset"
          + " --sizes 2-3 --reference 1";

  @BeforeAll
  static void makeAWorld(@TempDir Path temporary) throws IOException {
    folder = temporary;
    world = folder.resolve("world");
    Done done = generate(ORDER, world);
    assertEquals(0, done.status, done.err);
    id = onlyCase(world);
  }

  private static String onlyCase(Path of) throws IOException {
    try (Stream<Path> cases = Files.list(of.resolve("cases"))) {
      return cases.findFirst().orElseThrow().getFileName().toString();
    }
  }

  /** Poses in a folder of the case's name. */
  private static Path asked(String name, String text) throws IOException {
    Path poses = folder.resolve(name);
    Files.createDirectories(poses.resolve(id));
    Files.writeString(poses.resolve(id).resolve(ASKED), text);
    return poses;
  }

  private static Done again(String order, Path poses, Path to) {
    return generate(order, to, "--at", poses.toString(), "--world", world.toString());
  }

  private static Path sealedRows() {
    return world.resolve("rows").resolve(id).resolve("rows.csv");
  }

  /** At the sealed rows the offset shows as it does in the sealed readings, by other chance. */
  @Test
  void offset_showsAtOtherPoses() throws IOException, FormatException {
    Path poses = asked("offset", Files.readString(sealedRows()));
    Files.createDirectories(poses.resolve("nothing asked of this one"));
    Path to = folder.resolve("offset-read");
    Done done = again(ORDER, poses, to);
    assertEquals(0, done.status, done.err);
    assertEquals("generated 1 of 1\n", done.err);
    Path readings = to.resolve(id).resolve("readings.csv");
    Path sealed = world.resolve("truth").resolve(id).resolve("sealed.csv");
    assertNotEquals(Files.readString(sealed), Files.readString(readings), "another chance");
    assertEquals(0, meanDifference(ranges(readings), ranges(sealed)), PLAIN_M / 2);
    Scene scene = DataSet.scene(world.resolve("cases").resolve(id).resolve("scene.json"));
    Recording rows = DataSet.rows(Csv.read(sealedRows()));
    double[] nominal = new World(scene, Setup.nominal(scene.sensor()), List.of()).at(rows).read(1);
    assertTrue(Math.abs(meanDifference(ranges(readings), nominal)) > PLAIN_M, "without the offset");
  }

  private static double[] ranges(Path file) throws IOException, FormatException {
    Csv csv = Csv.read(file);
    int column = csv.column("range_m");
    double[] ranges = new double[csv.size()];
    for (int row = 0; row < ranges.length; row++) {
      boolean none = csv.text(row, column).isBlank();
      ranges[row] = none ? Double.POSITIVE_INFINITY : csv.number(row, column);
    }
    return ranges;
  }

  /** Over the rows that have an echo in both. */
  private static double meanDifference(double[] one, double[] other) {
    double sum = 0;
    int count = 0;
    for (int row = 0; row < one.length; row++) {
      if (Math.max(one[row], other[row]) < Double.POSITIVE_INFINITY) {
        sum += one[row] - other[row];
        count++;
      }
    }
    assertTrue(count > 20, count + " echoes");
    return sum / count;
  }

  @Test
  void sameRows_giveTheSameBytes_andKeepTheirText() throws IOException {
    String rows = "\"next, 1\",s,0,0.12345678,-0,0\nnext-2,s,1.5,1e1,2,-180\n";
    Path poses = asked("same", HEADER + rows);
    for (String to : List.of("same-1", "same-2")) {
      Done done = again(ORDER, poses, folder.resolve(to));
      assertEquals(0, done.status, done.err);
    }
    String first = Files.readString(folder.resolve("same-1").resolve(id).resolve("readings.csv"));
    String second = Files.readString(folder.resolve("same-2").resolve(id).resolve("readings.csv"));
    assertEquals(first, second);
    List<String> lines = first.lines().toList();
    assertEquals(HEADER.strip() + ",range_m", lines.get(0));
    assertTrue(lines.get(1).startsWith("\"next, 1\",s,0,0.12345678,-0,0,"), lines.get(1));
    assertTrue(lines.get(2).matches("next-2,s,1.5,1e1,2,-180,(\\d+\\.\\d{4})?"), lines.get(2));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "next-1,s,0,far,0,0 | next-experiment.csv, line 2, x_m: 'far', expected a number",
        "next-1,s,0,0,0,NaN | next-experiment.csv, line 2, heading_deg: 'NaN', expected a number",
        "next-1,s,0,0,0 | next-experiment.csv, line 2: 5 fields, expected 6",
      })
  void badRow_isToldInOneLine(String row, String complaint) throws IOException {
    Path poses = asked("bad", HEADER + row + "\n");
    Done done = again(ORDER, poses, folder.resolve("bad-read"));
    assertEquals(2, done.status, done.err);
    assertEquals(1, done.err.lines().count(), done.err);
    assertTrue(done.err.endsWith(complaint + "\n"), done.err);
    assertFalse(Files.exists(folder.resolve("bad-read")), "nothing is written");
  }

  @Test
  void otherColumns_areRefused() throws IOException {
    Path poses = asked("columns", "run,sensor,t_s,z_m,x_m,heading_deg\nr,s,0,0,0,0\n");
    Done done = again(ORDER, poses, folder.resolve("columns-read"));
    assertEquals(2, done.status, done.err);
    assertTrue(done.err.contains(ASKED + ", line 1: 'run,sensor,t_s,z_m,x_m"), done.err);
  }

  /** Another seed has no such case; other rows give another world under the same name. */
  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--seed 13 | --seed 14 | expected the name of a case of",
        "300-320 | 330-340 | drawn again they have other readings than",
      })
  void anotherOrder_isNotTheSealedWorld(String text, String other, String complaint)
      throws IOException {
    Path poses = asked("another", HEADER + "next-1,s,0,0,0,0\n");
    Path to = folder.resolve("another-read");
    Done done = again(ORDER.replace(text, other), poses, to);
    assertEquals(2, done.status, done.err);
    assertTrue(done.err.contains(id) && done.err.contains(complaint), done.err);
    assertFalse(Files.exists(to.resolve(id)), "nothing is read of it");
  }

  @Test
  void whatCannotBe_isSaid() throws IOException {
    Path poses = asked("cannot", HEADER + "next-1,s,0,0,0,0\n");
    Path to = folder.resolve("cannot-read");
    Done motion = again("--level motion --cases 1", poses, to);
    assertEquals(2, motion.status, motion.err);
    assertTrue(motion.err.contains("worlds of motion are not read again"), motion.err);
    Done without = generate(ORDER, to, "--at", poses.toString());
    assertTrue(without.err.contains("--world: missing"), without.err);
    Done nowhere = again(ORDER, folder.resolve("nowhere"), to);
    assertTrue(nowhere.err.contains("nowhere: no such folder"), nowhere.err);
  }

  /** A world of waves is read on the day of its readings, with what is at work. */
  @Test
  void waves_areReadAgain() throws IOException, FormatException {
    String order =
        "--level wave --cases 1 --seed 4 --rows 300-320 --repeats 40 --mix single:1"
            + " --effects range-offset --sizes 3-4";
    Path waves = folder.resolve("waves");
    assertEquals(0, generate(order, waves).status);
    String one = onlyCase(waves);
    Path poses = folder.resolve("waves-asked");
    Files.createDirectories(poses.resolve(one));
    Path rows = waves.resolve("rows").resolve(one).resolve("rows.csv");
    Files.copy(rows, poses.resolve(one).resolve(ASKED));
    Path to = folder.resolve("waves-read");
    Done done = generate(order, to, "--at", poses.toString(), "--world", waves.toString());
    assertEquals(0, done.status, done.err);
    double[] read = ranges(to.resolve(one).resolve("readings.csv"));
    double[] sealed = ranges(waves.resolve("truth").resolve(one).resolve("sealed.csv"));
    assertEquals(0, meanDifference(read, sealed), PLAIN_M);
  }

  /** A part of the benchmark's practice, by its own options. */
  @Test
  void practice_isReadAgain() throws IOException {
    String part = "benchmark --part L1 --practice 77 --first 1 --out ";
    Path drawn = folder.resolve("practice");
    assertEquals(0, run((part + drawn).split(" ")).status);
    String one = onlyCase(drawn);
    Path poses = folder.resolve("practice-asked");
    Files.createDirectories(poses.resolve(one));
    Files.writeString(poses.resolve(one).resolve(ASKED), HEADER + "next-1,s,0,0,0,0\n");
    Path to = folder.resolve("practice-read");
    Done done = run((part + to + " --at " + poses + " --world " + drawn).split(" "));
    assertEquals(0, done.status, done.err);
    assertEquals(2, Files.readAllLines(to.resolve(one).resolve("readings.csv")).size());
  }

  private static void answer(Path answers, String names, String ties, String more)
      throws IOException {
    Path one = Files.createDirectories(answers.resolve(id));
    Files.writeString(
        one.resolve("diagnosis.json"),
        "{\"verdict\": \"explained\", \"explanation\": ["
            + names
            + "], \"effects\": [{\"name\": "
            + names
            + ", \"probability\": 0.9, \"indistinguishable_from\": ["
            + ties
            + "]}], \"unknown_probability\": 0.1"
            + more
            + "}\n");
  }

  /** The answers before and after are scored by the truth that was sealed. */
  @Test
  void answersAfter_areScored() throws IOException {
    Path before = folder.resolve("before");
    Path after = folder.resolve("after");
    String next =
        ", \"next_experiment\": {\"separates\": [\"range-offset\", \"sound-speed\"],"
            + " \"poses\": \"next-experiment.csv\", \"expected_log_odds\": 12.5}";
    answer(before, "\"sound-speed\"", "\"range-offset\"", next);
    answer(after, "\"range-offset\"", "", "");
    Path csv = folder.resolve("next.csv");
    Done done =
        run(
            "next",
            "--truth",
            world.resolve("truth").toString(),
            "--manifest",
            world.resolve("manifest.json").toString(),
            "--answers",
            before.toString(),
            "--again",
            after.toString(),
            "--out",
            csv.toString());
    assertEquals(0, done.status, done.err);
    List<String> lines = Files.readAllLines(csv);
    assertEquals(2, lines.size());
    assertTrue(
        lines
            .get(1)
            .startsWith(
                id
                    + ",L2,single,range-offset,range-offset+sound-speed,range-offset,12.50,right,"
                    + "sound-speed,range-offset,"),
        lines.get(1));
  }
}
