package simbad.sim;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.util.Arrays;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class BeltPanelTest {
  private static final int SIDE = 240;

  /** A robot before a box, of whose four sensors one hears. */
  private static RangeSensorBelt belt(int flags) {
    EnvironmentDescription environment = new EnvironmentDescription();
    environment.add(new Box(new Vector3d(2, 0, 0), new Vector3f(1, 1, 1), environment));
    Agent agent = new Agent(new Vector3d(), "agent");
    RangeSensorBelt belt = new RangeSensorBelt(0.3f, 0, 6, 4, RangeSensorBelt.TYPE_SONAR, flags);
    agent.addSensorDevice(belt, new Vector3d(), 0);
    environment.add(agent);
    new Simulator(null, new World(environment), environment).performSimulationStep();
    return belt;
  }

  @ParameterizedTest
  @ValueSource(ints = {0, RangeSensorBelt.FLAG_RETURN_INFINITY})
  void silentSensor_saysNoEcho_thoughItMeasuresANumber(int flags) {
    RangeSensorBelt belt = belt(flags);
    BeltPanel panel = new BeltPanel(belt);
    assertEquals("1.20 m", panel.text(0));
    assertEquals("no echo", panel.text(2));
    assertEquals(flags == 0 ? 6 : Double.POSITIVE_INFINITY, belt.getMeasurement(2));
  }

  @ParameterizedTest
  @ValueSource(ints = {0x202020, 0xF0F0F0})
  void echo_isRed_andReadable(int background) {
    BeltPanel panel = new BeltPanel(belt(0));
    panel.setBackground(new Color(background));
    panel.setSize(SIDE, SIDE);
    BufferedImage image = new BufferedImage(SIDE, SIDE, BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    panel.paint(graphics);
    graphics.dispose();
    int[] pixels = image.getRGB(0, 0, SIDE, SIDE, null, 0, SIDE);
    int red = background == 0x202020 ? 0xFFFF786E : 0xFFC6261E;
    assertTrue(Arrays.stream(pixels).filter(pixel -> pixel == red).count() > 10);
  }
}
