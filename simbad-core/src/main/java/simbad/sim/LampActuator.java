package simbad.sim;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.util.List;
import javax.swing.JPanel;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.geometry.BallShape;

/** A lamp that is on or off and may blink. */
public class LampActuator extends ActuatorDevice {
  private static final Rgb LIGHT = new Rgb(1, 1, 0.2f);
  private static final Rgb GLASS = new Rgb(0.3f, 0.3f, 0.3f);

  private final float size;
  private boolean on;
  private boolean blinking;
  private boolean dark;
  private boolean drawnLit;

  /**
   * Creates a lamp that is off.
   *
   * @param size diameter as drawn, metres
   */
  public LampActuator(float size) {
    this.size = size;
  }

  /** Lets a blinking lamp change between lit and dark. */
  @Override
  protected void update() {
    dark = blinking && !dark;
    followLight();
  }

  /** Switches the lamp. */
  public void setOn(boolean newOn) {
    on = newOn;
    followLight();
  }

  /** Returns true if the lamp is switched on, also in the dark phase of blinking. */
  public boolean getOn() {
    return on;
  }

  /** Starts or stops blinking. */
  public void setBlink(boolean newBlink) {
    blinking = newBlink;
  }

  /** Returns true if the lamp blinks. */
  public boolean getBlink() {
    return blinking;
  }

  /** Returns true if the lamp gives light at this moment. */
  boolean isLit() {
    return on && !dark;
  }

  private void followLight() {
    if (drawnLit != isLit()) {
      lookChanged();
    }
  }

  @Override
  protected List<Facets> drawing() {
    drawnLit = isLit();
    BallShape bulb = new BallShape(size / 2);
    return List.of(drawnLit ? Facets.plain(bulb, LIGHT) : Facets.lit(bulb, GLASS));
  }

  /** Returns a panel that shows whether the lamp gives light. */
  @Override
  public JPanel createInspectorPanel() {
    return new LampActuatorJPanel();
  }

  /** Shows the lamp as a disc. */
  public class LampActuatorJPanel extends JPanel {
    private static final int SIDE = 30;

    /** Creates a panel. */
    public LampActuatorJPanel() {
      setPreferredSize(new Dimension(SIDE, SIDE));
    }

    @Override
    protected void paintComponent(Graphics graphics) {
      super.paintComponent(graphics);
      graphics.setColor(isLit() ? Color.YELLOW : Color.DARK_GRAY);
      graphics.fillOval(5, 5, 20, 20);
      graphics.setColor(getForeground());
      graphics.drawOval(5, 5, 20, 20);
    }
  }
}
