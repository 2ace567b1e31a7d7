package simbad.demo;

import java.awt.Color;
import java.awt.Dimension;
import java.awt.Graphics;
import java.awt.image.BufferedImage;
import javax.swing.JPanel;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import javax.vecmath.Vector3f;
import simbad.sim.Agent;
import simbad.sim.Box;
import simbad.sim.CameraSensor;
import simbad.sim.LampActuator;
import simbad.sim.RobotFactory;

/**
 * A robot looks for the yellow box among boxes of other colours, drives up to it, and lights its
 * lamp there. Its panel shows what the camera sees, with a mark on the middle of what is yellow.
 * (Red would not do: the camera sees the robot's own nose.)
 */
public class ImagerDemo extends Demo {
  /** Middle of the yellow box, x and z in metres. */
  static final double[] GOAL = {-2, 4};

  final Robot robot;

  /** Creates the environment. */
  public ImagerDemo() {
    addSquareOfWalls(12);
    boxColor = green;
    add(new Box(new Vector3d(4, 0, 0), new Vector3f(1, 1, 1), this));
    add(new Box(new Vector3d(-4, 0, -2), new Vector3f(1, 1, 1), this));
    boxColor = white;
    add(new Box(new Vector3d(2, 0, -4), new Vector3f(1, 1, 1), this));
    boxColor = new Color3f(0.8f, 0.8f, 0);
    add(new Box(new Vector3d(GOAL[0], 0, GOAL[1]), new Vector3f(1, 1, 1), this));
    robot = new Robot();
    add(robot);
  }

  /** Turns until it sees yellow, then drives there. */
  static final class Robot extends Agent {
    private static final double TURN_RAD_PER_S = 0.6;

    /** Share of the picture that is yellow when the box is near enough. */
    private static final double NEAR = 0.6;

    final CameraSensor camera = RobotFactory.addCameraSensor(this);
    final LampActuator lamp = RobotFactory.addLamp(this);
    private final BufferedImage image = camera.createCompatibleImage();
    private double share;
    private int column = -1;

    Robot() {
      super(new Vector3d(), "imager");
      camera.setUpdatePerSecond(10);
      setUIPanel(new Picture());
    }

    @Override
    public void initBehavior() {
      lamp.setOn(false);
    }

    @Override
    public void performBehavior() {
      look();
      boolean there = share > NEAR;
      lamp.setOn(there);
      double aside = column < 0 ? 1 : 1 - 2.0 * column / image.getWidth();
      setRotationalVelocity(there ? 0 : aside * TURN_RAD_PER_S);
      setTranslationalVelocity(there || column < 0 ? 0 : 0.5);
    }

    /** Finds the middle column and the share of the pixels that are yellow. */
    private void look() {
      synchronized (image) {
        camera.copyVisionImage(image);
        long columns = 0;
        int count = 0;
        for (int x = 0; x < image.getWidth(); x++) {
          for (int y = 0; y < image.getHeight(); y++) {
            if (isYellow(new Color(image.getRGB(x, y)))) {
              columns += x;
              count++;
            }
          }
        }
        share = (double) count / (image.getWidth() * image.getHeight());
        column = count == 0 ? -1 : (int) (columns / count);
      }
    }

    private static boolean isYellow(Color color) {
      int least = Math.min(color.getRed(), color.getGreen());
      return least > 40 && least > 2 * color.getBlue();
    }

    /** The picture at twice its size, and the mark. */
    private final class Picture extends JPanel {
      private static final int SCALE = 2;

      Picture() {
        setPreferredSize(new Dimension(SCALE * image.getWidth(), SCALE * image.getHeight()));
      }

      @Override
      protected void paintComponent(Graphics graphics) {
        super.paintComponent(graphics);
        synchronized (image) {
          int side = SCALE * image.getWidth();
          graphics.drawImage(image, 0, 0, side, SCALE * image.getHeight(), null);
          if (column >= 0) {
            graphics.setColor(Color.YELLOW);
            graphics.drawLine(SCALE * column, 0, SCALE * column, SCALE * image.getHeight());
          }
        }
      }
    }
  }
}
