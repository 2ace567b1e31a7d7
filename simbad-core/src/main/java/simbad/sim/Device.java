package simbad.sim;

import javax.swing.JLabel;
import javax.swing.JPanel;
import org.jspecify.annotations.Nullable;
import simbad.kernel.geometry.Placement;
import simbad.kernel.motion.UpdateClock;

/** A sensor or actuator on an agent, updated at its own rate. */
public abstract class Device extends BaseObject {
  private final UpdateClock clock = new UpdateClock();
  private String name = "<name>";
  private @Nullable SimpleAgent owner;

  Device() {}

  /** Returns the device's name. */
  public String getName() {
    return name;
  }

  /** Names the device. */
  protected void setName(String newName) {
    name = newName;
  }

  /** Says who carries the device. */
  protected void setOwner(SimpleAgent newOwner) {
    owner = newOwner;
  }

  /**
   * Returns who carries the device.
   *
   * @throws IllegalStateException if nobody does
   */
  protected SimpleAgent getOwner() {
    if (owner == null) {
      throw new IllegalStateException("device " + name + " is not on an agent");
    }
    return owner;
  }

  /** Computes where the device is in the world; for sensors of one's own. */
  protected void placeInWorld(Placement worldFromDevice) {
    worldFromDevice.compose(getOwner().placement(), placement());
  }

  /** Returns a new panel that shows the device's state; for most devices, only its name. */
  public JPanel createInspectorPanel() {
    JPanel panel = new JPanel();
    panel.add(new JLabel(name));
    return panel;
  }

  /** Sets how often per simulated second the device is updated; 0 leaves it at the first step. */
  public void setUpdatePerSecond(double rate) {
    clock.setRate(rate);
  }

  /** Updates the device in every step, or at its rate. */
  public void setUpdateOnEachFrame(boolean eachFrame) {
    clock.setEachStep(eachFrame);
  }

  /** Returns how often per simulated second the device is updated. */
  public double getUpdatePerSecond() {
    return clock.ratePerS();
  }

  /** Senses or acts; called when an update is due. Override it. */
  protected void update() {
    // A device without duties.
  }

  /** Lets the device be updated in the next step, as in the first one. */
  void restartClock() {
    clock.restart(clock.hasPhase() && meets(Compatibility.RESETS_KEEP_THE_PHASE));
  }

  /** Returns to the state at the start. */
  protected void reset() {
    // A device without state.
  }

  /** Lets simulated seconds pass and updates the device if that is due. */
  protected void update(double elapsedSeconds) {
    if (clock.tick(elapsedSeconds)) {
      update();
    }
  }
}
