package simbad.sim;

import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.event.KeyEvent;
import java.awt.event.KeyListener;
import javax.swing.JPanel;

/** Tells which key was pressed last. Without a window there is no key. */
public class KeyInputSensor extends SensorDevice implements KeyListener {
  private volatile int lastKey = KeyEvent.VK_UNDEFINED;

  /** Creates a sensor that has seen no key. */
  public KeyInputSensor() {}

  @Override
  protected void reset() {
    lastKey = KeyEvent.VK_UNDEFINED;
  }

  /** Returns a panel that shows the last key and takes keys while it has the focus. */
  @Override
  public JPanel createInspectorPanel() {
    return new KeyInputSensorJPanel(this);
  }

  @Override
  public void keyTyped(KeyEvent event) {
    // A typed key was pressed before.
  }

  @Override
  public void keyPressed(KeyEvent event) {
    lastKey = event.getKeyCode();
  }

  @Override
  public void keyReleased(KeyEvent event) {
    // The last key stays the last one.
  }

  /** Returns the code of the key pressed last, {@link KeyEvent#VK_UNDEFINED} if there is none. */
  public int getLastKey() {
    return lastKey;
  }

  /** Shows the last key. */
  public class KeyInputSensorJPanel extends JPanel {
    private static final int WIDTH = 100;
    private static final int HEIGHT = 30;

    /** Creates a panel that passes keys to a listener. */
    public KeyInputSensorJPanel(KeyListener listener) {
      setPreferredSize(new Dimension(WIDTH, HEIGHT));
      setFocusable(true);
      addKeyListener(listener);
    }

    @Override
    protected void paintComponent(Graphics graphics) {
      super.paintComponent(graphics);
      boolean none = lastKey == KeyEvent.VK_UNDEFINED;
      graphics.drawString(none ? "no key" : KeyEvent.getKeyText(lastKey), 10, 20);
    }
  }
}
