package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.Locale;
import javax.swing.JPanel;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import simbad.kernel.geometry.Placement;

/**
 * A sensor of brightness: an eye of 10 by 10 pixels that looks backwards, from where it sits to
 * what is behind it. The sensors on the left and right of {@link RobotFactory} see the robot's own
 * body, whose sides are as bright as the lamps make them.
 */
public class LightSensor extends Eye {
  private static final int SIDE_PX = 10;
  private static final float RADIUS_M = 0.02f;

  /**
   * Where the sensor sits, metres from the agent's middle; to be read only. {@link
   * #translateTo(Vector3d)} moves it.
   */
  public Vector3d position = new Vector3d();

  private float luminance;

  /** Creates a light sensor. */
  public LightSensor() {
    super(RADIUS_M, SIDE_PX, SIDE_PX);
  }

  /**
   * Returns the mean luminance of the latest image, 0.299 red + 0.587 green + 0.114 blue, in [0,
   * 1]; 0 before the first update.
   */
  public float getAverageLuminance() {
    return luminance;
  }

  /**
   * Returns the illuminance at the sensor where it is now, in lux, if each lamp that is on shines
   * with 1 candela times the luminance of its colour: the sum of luminance / distance squared.
   * Nothing stands in the light's way, and the sensor does not care where the light comes from. A
   * lamp is not nearer than its globe's radius of 0.2 m. Outside a world it is dark.
   */
  public float getLux() {
    if (world == null) {
      return 0;
    }
    Placement here = new Placement();
    placeInWorld(here);
    return Surroundings.illuminanceLx(world.getStage().lighting(), here);
  }

  /** Returns where the sensor sits, metres from the agent's middle. */
  public Vector3d getPosition() {
    return new Vector3d(position);
  }

  /** Returns where a sensor is in the world now, metres; the sensor is on an agent. */
  public static Point3d getGlobalCoords(LightSensor sensor) {
    Placement here = new Placement();
    sensor.placeInWorld(here);
    return new Point3d(here.xM(), here.yM(), here.zM());
  }

  @Override
  public void translateTo(Vector3d displacement) {
    super.translateTo(displacement);
    position.set(placement().xM(), placement().yM(), placement().zM());
  }

  @Override
  protected void update() {
    super.update();
    luminance = picture().luminance();
  }

  @Override
  protected void reset() {
    super.reset();
    luminance = 0;
  }

  @Override
  void placeEye(Placement placement) {
    super.placeEye(placement);
    placement.turnQuarters(2);
  }

  /** Returns a panel that shows the luminance as a bar. */
  @Override
  public JPanel createInspectorPanel() {
    return new LigthSensorJPanel();
  }

  /** Shows the luminance as a bar and a number; the spelling is Simbad's. */
  public class LigthSensorJPanel extends JPanel {
    private static final int WIDTH_PX = 150;
    private static final int HEIGHT_PX = 20;

    /** Creates a panel. */
    public LigthSensorJPanel() {
      setPreferredSize(new Dimension(WIDTH_PX, 2 * HEIGHT_PX));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
      super.paintComponent(graphics);
      graphics.setColor(Color.DARK_GRAY);
      graphics.drawString(String.format(Locale.ROOT, "%.3f", luminance), 2, 2 * HEIGHT_PX - 5);
      graphics.drawRect(0, 0, WIDTH_PX - 1, HEIGHT_PX - 1);
      graphics.setColor(Color.ORANGE);
      graphics.fillRect(1, 1, Math.round(luminance * (WIDTH_PX - 2)), HEIGHT_PX - 2);
    }
  }
}
