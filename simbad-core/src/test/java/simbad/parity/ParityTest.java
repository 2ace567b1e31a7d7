package simbad.parity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.gui.Simbatch;
import simbad.parity.TraceRecorder.Cell;
import simbad.sim.RangeSensorBelt;
import simbad.sim.SimpleAgent;

/** Every recorded trace of the original, row by row and column by column. */
class ParityTest {
  private static final double TOLERANCE = 1e-6;

  /** What stands between values in the columns of sensors, quadrants, lamps. */
  private static final Pattern SEPARATOR = Pattern.compile("[,:]");

  /** Notes that the recording driver wrote for people. */
  private static final Pattern NOTES = Pattern.compile(",ev=.*");

  private static final Pattern BELT =
      Pattern.compile(
          "# belt of \\w+ '(.*)' n=(\\d+) maxRange=(\\S+) flags=(\\d) ups=(\\S+) angles=(.*)");
  private static final Pattern AGENT =
      Pattern.compile("# agent (\\w+) radius=(\\S+) height=(\\S+) mass=(\\S+)");

  private static int values;
  private static double greatest;

  /** What docs/figures/measure takes. */
  @AfterAll
  static void say() {
    int traces = Scenarios.all().size();
    System.out.printf(
        Locale.ROOT,
        "parity: %d traces, %,d values, greatest difference %.1e%n",
        traces,
        values,
        greatest);
  }

  static Stream<String> names() {
    return Scenarios.all().keySet().stream();
  }

  @Test
  void scenarios_cover_everyFile() throws IOException {
    Set<String> known = Scenarios.all().keySet();
    try (BufferedReader index = open("README.md")) {
      assertTrue(index.lines().anyMatch(line -> line.startsWith("| file ")));
    }
    assertEquals(20, known.size());
  }

  @ParameterizedTest
  @MethodSource("names")
  void trace_isReproduced(String name) throws IOException {
    Scenario scenario = scenario(name);
    Simbatch simulation = new Simbatch(scenario, false);
    simulation.reset();
    TraceRecorder recorder = new TraceRecorder(scenario);
    int agents = scenario.agents.size();
    List<String> rows = lines(name).stream().filter(line -> !line.startsWith("#")).toList();
    for (int i = 0; i < rows.size(); i++) {
      // The trace of lines begins after the first step and names no agent.
      int step = i / agents + (name.startsWith("08") ? 1 : 0);
      if (step > 0 && i % agents == 0) {
        simulation.step();
      }
      SimpleAgent agent = scenario.agents.get(i % agents);
      checkRow(name, rows.get(i), recorder.row(step, agent));
    }
    simulation.dispose();
  }

  @ParameterizedTest
  @MethodSource("names")
  void header_isReproduced(String name) throws IOException {
    Scenario scenario = scenario(name);
    int agent = 0;
    int belts = 0;
    for (String line : lines(name)) {
      Matcher belt = BELT.matcher(line);
      Matcher body = AGENT.matcher(line);
      if (belt.matches()) {
        checkBelt(belt, Scenario.belt(scenario.agents.get(0), belts++));
      } else if (body.matches()) {
        checkAgent(body, scenario.agents.get(agent++));
      }
    }
    assertEquals(name.startsWith("08") ? 0 : scenario.agents.size(), agent, name);
  }

  private static void checkRow(String file, String line, List<Cell> actual) {
    String values = NOTES.matcher(line).replaceAll("").replaceAll("[a-z]+=", "");
    String[] expected = SEPARATOR.split(values, -1);
    String where = file + ", step " + (int) actual.get(0).number() + ", column ";
    for (int i = 0; i < Math.min(expected.length, actual.size()); i++) {
      checkCell(where + actual.get(i).column(), expected[i], actual.get(i));
    }
    assertEquals(expected.length, actual.size(), where + "count");
  }

  private static void checkCell(String where, String expected, Cell actual) {
    if (!actual.word().isEmpty()) {
      assertEquals(expected, actual.word(), where);
    } else if (actual.column().equals("heading")) {
      double off = Math.IEEEremainder(number(expected) - actual.number(), 2 * Math.PI);
      assertEquals(0, off, TOLERANCE, where);
      count(off);
    } else {
      assertEquals(number(expected), actual.number(), TOLERANCE, where);
      count(number(expected) - actual.number());
    }
  }

  /** Infinity less infinity, which is right, is no number. */
  private static void count(double difference) {
    values++;
    greatest = Math.max(greatest, Double.isNaN(difference) ? 0 : Math.abs(difference));
  }

  private static double number(String text) {
    return text.equals("inf") ? Double.POSITIVE_INFINITY : Double.parseDouble(text);
  }

  private static void checkBelt(Matcher header, RangeSensorBelt belt) {
    assertEquals(header.group(1), belt.getName());
    assertEquals(Integer.parseInt(header.group(2)), belt.getNumSensors());
    assertEquals(Float.parseFloat(header.group(3)), belt.getMaxRange());
    assertEquals(Integer.parseInt(header.group(4)), belt.getFlags());
    assertEquals(Double.parseDouble(header.group(5)), belt.getUpdatePerSecond());
    double[] angles =
        Arrays.stream(header.group(6).split(" ")).mapToDouble(Double::parseDouble).toArray();
    for (int i = 0; i < angles.length; i++) {
      assertEquals(angles[i], belt.getSensorAngle(i), 1e-9);
    }
  }

  private static void checkAgent(Matcher header, SimpleAgent agent) {
    assertEquals(header.group(1), agent.getName());
    assertEquals(Float.parseFloat(header.group(2)), agent.getRadius());
    assertEquals(Float.parseFloat(header.group(3)), agent.getHeight());
    assertEquals(Float.parseFloat(header.group(4)), agent.getMass());
  }

  private static Scenario scenario(String name) {
    return Objects.requireNonNull(Scenarios.all().get(name)).get();
  }

  private static List<String> lines(String name) throws IOException {
    try (BufferedReader reader = open(name + ".csv")) {
      return new ArrayList<>(reader.lines().toList());
    }
  }

  private static BufferedReader open(String file) {
    InputStream stream = ParityTest.class.getResourceAsStream("/parity/" + file);
    return new BufferedReader(
        new InputStreamReader(Objects.requireNonNull(stream), StandardCharsets.UTF_8));
  }
}
