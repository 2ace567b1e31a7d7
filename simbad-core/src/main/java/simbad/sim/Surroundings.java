package simbad.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.media.j3d.Light;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Point3f;
import javax.vecmath.Vector3d;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Lighting;
import simbad.kernel.drawing.PointLight;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;
import simbad.scene3d.Backdrop;

/** What of a world's looks belongs to no object: floor, axes, lamps, light and background. */
final class Surroundings {
  private static final double LAMP_RADIUS_M = 0.2;
  private static final double NEAREST_LAMP_M = 0.5;
  private static final double LUX_AT_1_M = 0.25;
  private static final double AXIS_WIDTH_M = 0.02;
  private static final Rgb X_AXIS = new Rgb(0.85f, 0.15f, 0.1f);
  private static final Rgb Y_AXIS = new Rgb(0.1f, 0.6f, 0.1f);
  private static final Rgb Z_AXIS = new Rgb(0.1f, 0.3f, 0.9f);

  private Surroundings() {}

  /** Creates a stage with an environment's surroundings, the floor first, and no objects. */
  static Stage stage(EnvironmentDescription environment) {
    List<PointLight> lamps = new ArrayList<>();
    light1(environment).ifPresent(lamps::add);
    light2(environment).ifPresent(lamps::add);
    Lighting lighting = new Lighting(rgb(environment.ambientLightColor), lamps);
    Stage stage = new Stage(rgb(environment.backgroundColor), lighting);
    stage.add(still(floor(environment.worldSize, rgb(environment.floorColor))));
    if (environment.hasAxis) {
      stage.add(still(axes(environment.worldSize / 10)));
    }
    lamps.forEach(lamp -> stage.add(still(List.of(globe(lamp)))));
    return stage;
  }

  /** Returns the colours of an environment, and whether the program has chosen them. */
  static Backdrop backdrop(EnvironmentDescription environment) {
    return new Backdrop(
        rgb(environment.backgroundColor),
        environment.hasOwnBackground(),
        rgb(environment.floorColor),
        environment.hasOwnFloor());
  }

  /** Returns the environment's first lamp if it is lit. */
  static Optional<PointLight> light1(EnvironmentDescription environment) {
    return environment.light1IsOn
        ? Optional.of(lamp(environment.light1Position, environment.light1Color))
        : Optional.empty();
  }

  /** Returns the environment's second lamp if it is lit. */
  static Optional<PointLight> light2(EnvironmentDescription environment) {
    return environment.light2IsOn
        ? Optional.of(lamp(environment.light2Position, environment.light2Color))
        : Optional.empty();
  }

  private static PointLight lamp(Vector3d at, Color3f colour) {
    return new PointLight(at.x, at.y, at.z, rgb(colour));
  }

  /** Returns the nearest colour that there is. */
  static Rgb rgb(Color3f colour) {
    return Rgb.nearest(colour.x, colour.y, colour.z);
  }

  /** Returns a lamp as Java 3D has it, on or off; can be made without a display. */
  static javax.media.j3d.PointLight light(Vector3d at, Color3f colour, boolean on) {
    var light = new javax.media.j3d.PointLight();
    light.setPosition((float) at.x, (float) at.y, (float) at.z);
    light.setColor(colour);
    light.setEnable(on);
    light.setCapability(Light.ALLOW_STATE_READ);
    light.setCapability(Light.ALLOW_STATE_WRITE);
    light.setCapability(javax.media.j3d.PointLight.ALLOW_POSITION_READ);
    return light;
  }

  /** See {@link LightSensor#getLux()}. */
  static double lux(List<javax.media.j3d.PointLight> lights, Point3d at) {
    double sum = 0;
    int on = 0;
    for (javax.media.j3d.PointLight light : lights) {
      if (light.getEnable()) {
        Point3f lamp = new Point3f();
        light.getPosition(lamp);
        double distance = Math.max(NEAREST_LAMP_M, at.distance(new Point3d(lamp)));
        sum += LUX_AT_1_M / (distance * distance);
        on++;
      }
    }
    return on == 0 ? 0 : sum / on;
  }

  private static Visual still(List<Facets> facets) {
    return new Visual(new Placement(), () -> facets);
  }

  /** One face, so that the light falls on its corners alone, as in the original. */
  private static List<Facets> floor(double sideM, Rgb colour) {
    return List.of(Facets.lit(BoxShape.ofSides(sideM, 0, sideM), colour));
  }

  /** Three bars that rest on the floor, from the origin. */
  private static List<Facets> axes(double lengthM) {
    double half = Math.min(AXIS_WIDTH_M, lengthM / 50) / 2;
    BoxShape x = new BoxShape(lengthM / 2, half, half);
    BoxShape y = new BoxShape(half, lengthM / 2, half);
    BoxShape z = new BoxShape(half, half, lengthM / 2);
    return List.of(
        Facets.plain(x, X_AXIS).movedBy(lengthM / 2, half, 0),
        Facets.plain(y, Y_AXIS).movedBy(0, lengthM / 2, 0),
        Facets.plain(z, Z_AXIS).movedBy(0, half, lengthM / 2));
  }

  private static Facets globe(PointLight lamp) {
    return Facets.plain(new BallShape(LAMP_RADIUS_M), lamp.colour())
        .movedBy(lamp.xM(), lamp.yM(), lamp.zM());
  }
}
