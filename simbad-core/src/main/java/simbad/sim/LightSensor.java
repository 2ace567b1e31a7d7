package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.Locale;
import java.util.OptionalDouble;
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
  private OptionalDouble asideRad = OptionalDouble.empty();

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
   * Returns how bright the lamps are where the sensor is now, as 1.7 did: the mean over the lamps
   * that are on of 0.25 / d<sup>2</sup>, with d the distance in metres, at least 0.5. Their colour,
   * what stands in the light's way and where the sensor looks are of no account. In [0, 1]; 0
   * without a lamp and outside a world.
   */
  public double getLux() {
    return world == null ? 0 : world.lux(getPosition());
  }

  /**
   * Returns where the sensor is in the world, metres, as {@link #getGlobalCoords} has it; the
   * sensor is on an agent.
   */
  public Point3d getPosition() {
    Placement owner = getOwner().placement();
    return global(owner, position);
  }

  /**
   * Returns the place of a sensor in the world as 1.7 did: x and z are turned with the agent and
   * added to its place, the height is the sensor's own.
   *
   * @param agent the sensor's owner
   * @param local where the sensor sits, metres from the agent's middle
   */
  public static Point3d getGlobalCoords(Agent agent, Vector3d local) {
    return global(agent.placement(), local);
  }

  private static Point3d global(Placement owner, Vector3d local) {
    return new Point3d(
        owner.outerX(local.x, 0, local.z), local.y, owner.outerZ(local.x, 0, local.z));
  }

  /** Sits aside of its owner, and goes nearer in a world that wants that. */
  void setAside(double angle) {
    asideRad = OptionalDouble.of(angle);
  }

  @Override
  protected void setWorld(World newWorld) {
    super.setWorld(newWorld);
    if (asideRad.isPresent() && newWorld.meets(Compatibility.LIGHT_SENSORS_SIT_NEARER)) {
      double angle = asideRad.getAsDouble();
      Vector3d there = RobotFactory.aside(getOwner().getRadius(), angle, true);
      there.sub(position);
      translateTo(there);
    }
    asideRad = OptionalDouble.empty();
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
      graphics.setColor(getForeground());
      graphics.drawString(String.format(Locale.ROOT, "%.3f of 1", luminance), 2, 2 * HEIGHT_PX - 5);
      graphics.drawRect(0, 0, WIDTH_PX - 1, HEIGHT_PX - 1);
      graphics.setColor(Color.ORANGE);
      graphics.fillRect(1, 1, Math.round(luminance * (WIDTH_PX - 2)), HEIGHT_PX - 2);
    }
  }
}
