package simbad.experiments.program;

import java.awt.Graphics;
import java.awt.GraphicsConfiguration;
import java.awt.image.BufferedImage;
import javax.swing.JInternalFrame;
import org.jspecify.annotations.Nullable;

/**
 * Stands in for a {@link javax.swing.JFrame} in a program that runs without a display: things can
 * be put into it, and nobody sees it. What a frame has and this has not does nothing.
 */
public class HeadlessWindow extends JInternalFrame {
  private static final long serialVersionUID = 1;

  /** A window without a title. */
  public HeadlessWindow() {
    this("");
  }

  /** A window with a title. */
  public HeadlessWindow(String title) {
    super(title);
  }

  /** A window without a title, on a screen that is of no account. */
  public HeadlessWindow(@Nullable GraphicsConfiguration screen) {
    this("");
  }

  /** A window with a title, on a screen that is of no account. */
  public HeadlessWindow(String title, @Nullable GraphicsConfiguration screen) {
    this(title);
  }

  /** Does nothing: looks need fonts, which a machine without a display may not have. */
  @Override
  public void updateUI() {
    // Nobody looks.
  }

  /** Does nothing. */
  @Override
  public void setVisible(boolean visible) {
    // Nobody looks.
  }

  /** Does nothing. */
  @Override
  public void pack() {
    // Sizes of texts need fonts.
  }

  /** Returns something to draw on that is not shown. */
  @Override
  public Graphics getGraphics() {
    return new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB).createGraphics();
  }

  /** Does nothing. */
  @Override
  public void update(Graphics graphics) {
    // Nobody looks.
  }

  /** Does nothing. */
  @Override
  public void paint(Graphics graphics) {
    // Nobody looks.
  }
}
