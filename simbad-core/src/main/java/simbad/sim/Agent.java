package simbad.sim;

import java.util.ArrayList;
import java.util.List;
import javax.media.j3d.Transform3D;
import javax.swing.JPanel;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;
import simbad.gui.AgentInspector;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.geometry.PrismShape;

/**
 * A robot with motors: the base class of users' robots. By default 0.3 m in radius and 0.5 m high.
 */
public class Agent extends SimpleAgent {
  private static final Rgb NOSE = new Rgb(0.8f, 0, 0);

  /** Turns commands into displacements. */
  protected KinematicModel kinematicModel = new DefaultKinematic();

  /** Acceleration that the motors give, for physics. */
  protected Vector3d motorsLinearAcceleration = new Vector3d();

  /** Angular acceleration that the motors give, for physics. */
  protected Vector3d motorsAngularAcceleration = new Vector3d();

  /** Counts steps against wall-clock time. */
  protected FrameMeter frameMeter = new FrameMeter();

  private @Nullable JPanel uiPanel;
  private @Nullable AgentInspector agentInspector;
  private final Transform3D rotation = new Transform3D();

  /**
   * Creates a robot.
   *
   * @param pos where its base stands at the start, metres; copied
   * @param name its name
   */
  public Agent(Vector3d pos, String name) {
    super(pos, name);
    setColor(new Color3f(0, 0.8f, 0));
  }

  @Override
  protected void reset() {
    super.reset();
    frameMeter.reset();
  }

  /** Returns to the start position and stops. */
  @Override
  protected void resetPosition() {
    super.resetPosition();
    kinematicModel.reset();
  }

  @Override
  protected void create3D() {
    super.create3D();
  }

  /** Returns the body with a red nose on top, which points ahead. */
  @Override
  protected List<Facets> drawing() {
    double[] x = {radius, 0, 0};
    double[] z = {0, -radius / 2, radius / 2};
    double top = restores(Compatibility.NOSES_FLOAT) ? height : height / 2;
    List<Facets> look = new ArrayList<>(super.drawing());
    if (look.isEmpty()) {
      return look;
    }
    look.add(Facets.lit(new PrismShape(x, z, top, top + radius / 30), NOSE));
    return look;
  }

  @Override
  boolean hasMotors() {
    return true;
  }

  /**
   * Asks the kinematic model for this step's displacement, as velocities. What falls goes on
   * falling.
   */
  @Override
  protected void setMotorsAcceleration(double elapsedSecond) {
    double upwardsMPerS = linearVelocity.y;
    getRotationTransform(rotation);
    kinematicModel.update(elapsedSecond, rotation, linearVelocity, angularVelocity);
    linearVelocity.scale(1 / elapsedSecond);
    angularVelocity.scale(1 / elapsedSecond);
    if (isFalling()) {
      linearVelocity.y = upwardsMPerS;
    }
  }

  @Override
  protected void initPreBehavior() {
    super.initPreBehavior();
  }

  @Override
  protected void initBehavior() {
    super.initBehavior();
  }

  @Override
  protected void performPreBehavior() {
    frameMeter.countFrame();
  }

  @Override
  protected void performBehavior() {
    super.performBehavior();
  }

  /** Returns the metres travelled since the last reset. */
  public double getOdometer() {
    return odometer;
  }

  /** Sets the turning rate in radians per second; ignored without the default kinematic model. */
  public final void setRotationalVelocity(double velocity) {
    if (kinematicModel instanceof DefaultKinematic model) {
      model.setRotationalVelocity(velocity);
    }
  }

  /** Sets the velocity in metres per second; ignored without the default kinematic model. */
  public final void setTranslationalVelocity(double velocity) {
    if (kinematicModel instanceof DefaultKinematic model) {
      model.setTranslationalVelocity(velocity);
    }
  }

  /** Returns the turning rate in radians per second; 0 without the default kinematic model. */
  public final double getRotationalVelocity() {
    return kinematicModel instanceof DefaultKinematic model ? model.getRotationalVelocity() : 0;
  }

  /** Returns the velocity in metres per second; 0 without the default kinematic model. */
  public final double getTranslationalVelocity() {
    return kinematicModel instanceof DefaultKinematic model ? model.getTranslationalVelocity() : 0;
  }

  /** Replaces the kinematic model. */
  protected void setKinematicModel(KinematicModel model) {
    kinematicModel = model;
  }

  /** Returns the kinematic model. */
  protected KinematicModel getKinematicModel() {
    return kinematicModel;
  }

  /** Sets over how many steps the step rate is measured; at least 1. */
  protected void setFrameMeterRate(int rate) {
    frameMeter.setUpdateRate(rate);
  }

  /** Gives the window a panel to show for this agent. */
  public void setUIPanel(@Nullable JPanel panel) {
    uiPanel = panel;
  }

  /** Returns the panel to show for this agent, or null if there is none. */
  public @Nullable JPanel getUIPanel() {
    return uiPanel;
  }

  /** Returns the window that shows this agent's state, or null if there is none. */
  public @Nullable AgentInspector getAgentInspector() {
    return agentInspector;
  }

  /** Says which window shows this agent's state. */
  public void setAgentInspector(@Nullable AgentInspector inspector) {
    agentInspector = inspector;
  }

  @Override
  protected void dispose() {
    super.dispose();
  }

  @Override
  @SuppressWarnings("UnsynchronizedOverridesSynchronized") // The modifiers are Simbad's.
  public String asString() {
    return super.asString() + "\n" + AgentText.ofRobot(this);
  }
}
