package oldprograms;

import java.awt.image.BufferedImage;
import javax.swing.JPanel;
import javax.vecmath.*;
import simbad.gui.Simbad;
import simbad.sim.*;

/** Looks for something red with the camera and drives there; another sensor reads in gray. */
public class BallWatcher extends EnvironmentDescription {
  public Watcher watcher;

  public BallWatcher() {
    add(new Wall(new Vector3d(0, 0, 5), 10, 1, this));
    add(new CherryAgent(new Vector3d(3, 0, -2), "cherry", 0.15f));
    watcher = new Watcher(new Vector3d(0, 0, 0), "watcher");
    add(watcher);
  }

  public class Watcher extends Agent {
    CameraSensor camera;
    BufferedImage cameraImage;
    SensorMatrix matrix;
    public int found;
    public double brightness;

    public Watcher(Vector3d position, String name) {
      super(position, name);
      camera = RobotFactory.addCameraSensor(this);
      camera.setUpdatePerSecond(10);
      camera.rotateZ(0);
      cameraImage = camera.createCompatibleImage();
      matrix = camera.createCompatibleSensorMatrix();
      JPanel panel = camera.createInspectorPanel();
      setUIPanel(panel);
    }

    public void initBehavior() {
      found = 0;
    }

    public void performBehavior() {
      camera.copyVisionImage(cameraImage);
      camera.copyVisionImage(matrix);
      brightness = matrix.get(0.5f, 0.1f);
      int sum = 0;
      int count = 0;
      // What is red above the own nose.
      for (int y = 0; y < camera.getImageHeight() * 3 / 4; y++) {
        for (int x = 0; x < camera.getImageWidth(); x++) {
          int rgb = cameraImage.getRGB(x, y);
          if ((rgb >> 16 & 0xFF) > 4 * (rgb >> 8 & 0xFF) && (rgb >> 16 & 0xFF) > 10) {
            sum += x - camera.getImageWidth() / 2;
            count++;
          }
        }
      }
      if (count > 0) {
        found++;
        setRotationalVelocity(-0.02 * sum / count);
        setTranslationalVelocity(0.4);
      } else if (found == 0) {
        setRotationalVelocity(0.5);
      }
      if (anOtherAgentIsVeryNear()) {
        getVeryNearAgent().detach();
        setTranslationalVelocity(0);
      }
    }
  }

  public static void main(String[] args) {
    System.setProperty("j3d.implicitAntialiasing", "true");
    Simbad frame = new Simbad(new BallWatcher(), false);
  }
}
