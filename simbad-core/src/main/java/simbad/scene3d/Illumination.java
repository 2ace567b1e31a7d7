package simbad.scene3d;

import javax.media.j3d.AmbientLight;
import javax.media.j3d.Background;
import javax.media.j3d.BoundingSphere;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.DirectionalLight;
import javax.media.j3d.Light;
import javax.media.j3d.PointLight;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Point3f;
import javax.vecmath.Vector3f;
import simbad.kernel.drawing.Lighting;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.drawing.Stage;

/** The lights and the background of a stage. */
final class Illumination {
  private static final Point3f ATTENUATION = new Point3f((float) Lighting.ATTENUATION, 0, 0);

  private static final BoundingSphere EVERYWHERE =
      new BoundingSphere(new Point3d(), Double.POSITIVE_INFINITY);

  private static final Color3f HEADLIGHT = new Color3f(0.4f, 0.4f, 0.4f);

  private Illumination() {}

  static BranchGroup of(Stage stage) {
    BranchGroup group = lights(stage);
    group.addChild(background(stage.background()));
    return group;
  }

  /** Returns a background whose colour can be changed. */
  static Background background(Rgb colour) {
    Background background = new Background(Facet3D.color(colour));
    background.setApplicationBounds(EVERYWHERE);
    background.setCapability(Background.ALLOW_COLOR_WRITE);
    return background;
  }

  /** Returns the lights of a stage alone. */
  static BranchGroup lights(Stage stage) {
    BranchGroup group = new BranchGroup();
    group.addChild(reaching(new AmbientLight(Facet3D.color(stage.lighting().ambient()))));
    stage.lighting().lamps().forEach(lamp -> group.addChild(reaching(light(lamp))));
    return group;
  }

  /**
   * Returns a weak light that shines from the eye: without it, what no lamp reaches would be black.
   * Only the window has it, robots' cameras do not.
   */
  static Light headlight() {
    return reaching(new DirectionalLight(HEADLIGHT, new Vector3f(0, 0, -1)));
  }

  private static Light light(simbad.kernel.drawing.PointLight lamp) {
    Point3f position = new Point3f((float) lamp.xM(), (float) lamp.yM(), (float) lamp.zM());
    return new PointLight(Facet3D.color(lamp.colour()), position, ATTENUATION);
  }

  private static Light reaching(Light light) {
    light.setInfluencingBounds(EVERYWHERE);
    return light;
  }
}
