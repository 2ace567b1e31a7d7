package simbad.parity;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Objects;
import java.util.regex.Pattern;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.api.Test;
import simbad.gui.Simbatch;
import simbad.parity.Scenario.Driver;
import simbad.sim.Box;
import simbad.sim.CameraSensor;
import simbad.sim.LightSensor;
import simbad.sim.RobotFactory;
import simbad.sim.SensorMatrix;
import simbad.sim.Wall;

/**
 * The recorded traces of what robots see. The original took its pictures beside the steps: a row
 * may hold the picture of a few steps before, and the first rows are black.
 */
class SightTest {
  private static final int LATE_STEPS = 3;

  /** In 8 steps of 236 the recorded camera misses the end of the wall. */
  private static final double SHARE = 0.95;

  private interface Sight {
    double[] see();
  }

  /** Returns within which difference 95 of 100 values agree. */
  private static double off(String file, Pattern cell, Scenario scenario, Sight sight)
      throws IOException {
    List<double[]> expected = rows(file, cell);
    Simbatch simulation = new Simbatch(scenario, false);
    simulation.reset();
    List<double[]> seen = new ArrayList<>();
    List<Double> off = new ArrayList<>();
    for (double[] row : expected.subList(1, expected.size())) {
      simulation.step();
      seen.add(sight.see());
      for (int i = 0; i < row.length; i++) {
        if (row[i] != 0) {
          off.add(nearest(row[i], seen, i));
        }
      }
    }
    simulation.dispose();
    Collections.sort(off);
    return off.get((int) (SHARE * off.size()));
  }

  private static double nearest(double value, List<double[]> seen, int column) {
    return seen.subList(Math.max(0, seen.size() - 1 - LATE_STEPS), seen.size()).stream()
        .mapToDouble(row -> Math.abs(row[column] - value))
        .min()
        .orElseThrow();
  }

  private static List<double[]> rows(String file, Pattern cell) throws IOException {
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(
                Objects.requireNonNull(SightTest.class.getResourceAsStream("/parity/" + file)),
                StandardCharsets.UTF_8))) {
      return reader
          .lines()
          .filter(line -> !line.startsWith("#"))
          .map(line -> cell.matcher(line).results().mapToDouble(r -> number(r.group(1))).toArray())
          .toList();
    }
  }

  private static double number(String text) {
    return Double.parseDouble(text);
  }

  private static Driver turning(double t, double r, int steps, double laterT, double laterR) {
    return new Driver(new Vector3d(), "r") {
      @Override
      void drive(int n) {
        vel(n < steps ? t : laterT, n < steps ? r : laterR);
      }
    };
  }

  @Test
  void light_isAsBright() throws IOException {
    Scenario scenario = new Scenario();
    scenario.light1SetPosition(6, 0.7, 5);
    scenario.ambientLightColor = scenario.darkgray;
    scenario.floorColor = scenario.white;
    scenario.backgroundColor = scenario.black;
    Driver robot = scenario.addAgent(turning(0, Math.PI / 3, 120, 0.5, 0));
    LightSensor[] sensors = {
      RobotFactory.addLightSensorLeft(robot),
      RobotFactory.addLightSensorRight(robot),
      RobotFactory.addLightSensor(robot)
    };
    for (LightSensor sensor : sensors) {
      sensor.setUpdateOnEachFrame(true);
    }
    double off =
        off(
            "06-light.csv",
            Pattern.compile("lux=([0-9.]+)"),
            scenario,
            () ->
                new double[] {
                  sensors[0].getAverageLuminance(),
                  sensors[1].getAverageLuminance(),
                  sensors[2].getAverageLuminance()
                });
    assertTrue(off < 0.06, "off by " + off);
  }

  @Test
  void camera_isAsBright() throws IOException {
    Scenario scenario = new Scenario();
    scenario.box(3, 0, 0, 1, 1, 1);
    scenario.add(new Box(new Vector3d(0, 0, -3), new Vector3f(1, 2, 1), scenario, scenario.green));
    scenario.add(new Wall(new Vector3d(0, 0, 4), 6, 1, scenario));
    Driver robot = scenario.addAgent(turning(0, Math.PI / 6, 240, 0, 0));
    CameraSensor camera = RobotFactory.addCameraSensor(robot);
    camera.setUpdateOnEachFrame(true);
    SensorMatrix matrix = camera.createCompatibleSensorMatrix();
    Sight sight =
        () -> {
          camera.copyVisionImage(matrix);
          double sum = 0;
          for (float value : matrix.getArray()) {
            sum += value;
          }
          return new double[] {sum / matrix.getArray().length};
        };
    double off = off("07-camera.csv", Pattern.compile("mean=([0-9.]+)"), scenario, sight);
    assertTrue(off < 0.02, "off by " + off);
  }
}
