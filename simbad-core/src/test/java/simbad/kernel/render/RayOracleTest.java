package simbad.kernel.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Lighting;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;
import simbad.kernel.geometry.PrismShape;
import simbad.kernel.geometry.Ray;
import simbad.kernel.geometry.Shape;

/**
 * Each pixel shows the solid that a ray through it meets first. Rays are cast by the shapes
 * themselves, which the renderer does not use.
 */
class RayOracleTest {
  private static final int SIDE_PX = 40;
  private static final double SLOPE = Math.tan(PictureSource.FIELD_OF_VIEW_RAD / 2);

  /** Corners are rounded to 1/256 pixel: what is nearer to an edge than this may go either way. */
  private static final double DOUBT_PX = 1 / 64.0;

  private final List<Shape> shapes = new ArrayList<>();
  private final List<Placement> places = new ArrayList<>();
  private final Placement eye = new Placement();

  @Property(tries = 60, seed = "20140914")
  void pixels_showWhatRaysMeet(@ForAll long seed) {
    Random random = new Random(seed);
    Stage stage = fill(random);
    eye.moveTo(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
    eye.resetTurn();
    eye.turnAboutY(random.nextDouble() * 2 * Math.PI);
    eye.turnAboutZ(random.nextDouble() - 0.5);
    Picture picture = new Picture(SIDE_PX, SIDE_PX);
    new SoftwareCamera(stage).take(eye, picture);
    int certain = 0;
    for (int row = 0; row < SIDE_PX; row++) {
      for (int column = 0; column < SIDE_PX; column++) {
        certain += check(picture, column, row) ? 1 : 0;
      }
    }
    assertTrue(certain > 0.9 * SIDE_PX * SIDE_PX, "pixels off the edges: " + certain);
  }

  /** Boxes, walls that go far past the eye, and stars, all of them off the eye. */
  private Stage fill(Random random) {
    shapes.clear();
    places.clear();
    Stage stage = new Stage(new Rgb(0, 0, 0), new Lighting(Rgb.WHITE, List.of()));
    add(stage, BoxShape.ofSides(100, 0.1, 100), Placement.at(0, -1, 0));
    add(stage, BoxShape.ofSides(60, 1, 0.3), Placement.at(0, 0, 2));
    for (int i = 0; i < 30; i++) {
      double angle = random.nextDouble() * 2 * Math.PI;
      double away = 3 + 6 * random.nextDouble();
      Placement place =
          Placement.at(
              away * Math.cos(angle), random.nextDouble() * 3 - 1.5, away * Math.sin(angle));
      place.turnAboutY(random.nextDouble() * 6);
      place.turnAboutZ(random.nextDouble());
      add(stage, i % 2 == 0 ? star(random) : BoxShape.ofSides(1, random.nextDouble(), 0.5), place);
    }
    return stage;
  }

  private static PrismShape star(Random random) {
    double[] x = new double[9];
    double[] z = new double[9];
    for (int i = 0; i < x.length; i++) {
      double radius = 0.2 + random.nextDouble();
      x[i] = radius * Math.cos(i * 2 * Math.PI / 9);
      z[i] = radius * Math.sin(i * 2 * Math.PI / 9);
    }
    return new PrismShape(x, z, -0.3, 0.3);
  }

  private void add(Stage stage, Shape shape, Placement place) {
    shapes.add(shape);
    places.add(place);
    float red = shapes.size() / 255f;
    stage.add(new Visual(place, () -> List.of(Facets.plain(shape, new Rgb(red, 0, 0)))));
  }

  /** Compares a pixel, unless rays round its centre disagree with one another. */
  private boolean check(Picture picture, int column, int row) {
    int seen = met(column + 0.5, row + 0.5);
    for (int i = 0; i < 4; i++) {
      double across = i % 2 == 0 ? DOUBT_PX : -DOUBT_PX;
      double down = i < 2 ? DOUBT_PX : -DOUBT_PX;
      if (met(column + 0.5 + across, row + 0.5 + down) != seen) {
        return false;
      }
    }
    assertEquals(seen, picture.rgb(column, row) >> 16, column + ", " + row);
    return true;
  }

  /** Returns the number of the solid that a ray through a point of the picture meets, from 1. */
  private int met(double column, double row) {
    double right = (column / SIDE_PX * 2 - 1) * SLOPE;
    double up = (1 - row / SIDE_PX * 2) * SLOPE;
    double length = Math.sqrt(1 + right * right + up * up);
    Ray ray = new Ray();
    ray.setOrigin(eye.xM(), eye.yM(), eye.zM());
    ray.setDirection(
        eye.turnedX(1, up, right) / length,
        eye.turnedY(1, up, right) / length,
        eye.turnedZ(1, up, right) / length);
    ray.setLength(1000);
    int met = 0;
    Ray local = new Ray();
    for (int i = 0; i < shapes.size(); i++) {
      local.setToLocal(ray, places.get(i));
      if (shapes.get(i).strike(local) && ray.shortenTo(local.lengthM())) {
        met = i + 1;
      }
    }
    return met;
  }
}
