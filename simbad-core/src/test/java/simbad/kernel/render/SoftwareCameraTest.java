package simbad.kernel.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.kernel.drawing.Facets;
import simbad.kernel.drawing.Lighting;
import simbad.kernel.drawing.PointLight;
import simbad.kernel.drawing.Rgb;
import simbad.kernel.drawing.Stage;
import simbad.kernel.drawing.Visual;
import simbad.kernel.geometry.BallShape;
import simbad.kernel.geometry.BoxShape;
import simbad.kernel.geometry.Placement;

/** Pictures whose every pixel follows from the geometry or from the formula of the light. */
class SoftwareCameraTest {
  private static final int RED = 0xff0000;
  private static final int GREEN = 0x00ff00;
  private static final int BLACK = 0x000000;

  /** Pixels per metre at depth 1 m: half of 100 pixels by the tangent of half of 45 degrees. */
  private static final double FOCAL_PX = 50 / Math.tan(Math.toRadians(22.5));

  private final Placement eye = new Placement();
  private final Picture picture = new Picture(100, 100);

  private static Stage dark() {
    return new Stage(new Rgb(0, 0, 0), new Lighting(new Rgb(0, 0, 0), List.of()));
  }

  private static Stage lit(PointLight... lamps) {
    return new Stage(new Rgb(0, 0, 0), new Lighting(Rgb.WHITE, List.of(lamps)));
  }

  /** A box whose face is at x = depthM, in a colour of its own. */
  private static Facets wall(BoxShape box, Rgb colour) {
    Facets facets = Facets.lit(box, colour);
    return new Facets(facets.mesh(), facets.finish().reflecting(0.08f));
  }

  private static Visual block(double depthM, double yM, double zM, double side, Rgb colour) {
    BoxShape box = BoxShape.ofSides(1, side, side);
    Placement place = Placement.at(depthM + 0.5, yM, zM);
    return new Visual(place, () -> List.of(Facets.plain(box, colour)));
  }

  private static Visual litBlock(double depthM, double side, Rgb colour) {
    BoxShape box = BoxShape.ofSides(1, side, side);
    Placement place = Placement.at(depthM + 0.5, 0, 0);
    return new Visual(place, () -> List.of(wall(box, colour)));
  }

  private Picture take(Stage stage) {
    new SoftwareCamera(stage).take(eye, picture);
    return picture;
  }

  /** 1 m at 2 m is 60.4 pixels: the centres of columns 20 to 79 are inside. */
  @Test
  void box_coversThePixelsWhoseCentresItHolds() {
    Stage stage = dark();
    stage.add(block(2, 0, 0, 1, new Rgb(1, 0, 0)));
    take(stage);
    for (int row = 0; row < 100; row++) {
      for (int column = 0; column < 100; column++) {
        boolean inside = Math.max(Math.abs(column - 49.5), Math.abs(row - 49.5)) < FOCAL_PX / 4;
        assertEquals(inside ? RED : BLACK, picture.rgb(column, row), column + ", " + row);
      }
    }
  }

  /** To the right is +z, up is row 0. */
  @Test
  void box_upAndRight_isUpAndRightInThePicture() {
    Stage stage = dark();
    stage.add(block(2, 0.4, 0.6, 0.1, new Rgb(1, 0, 0)));
    take(stage);
    int column = (int) (50 + 0.6 * FOCAL_PX / 2);
    int row = (int) (50 - 0.4 * FOCAL_PX / 2);
    assertEquals(RED, picture.rgb(column, row));
    assertEquals(BLACK, picture.rgb(99 - column, row));
    assertEquals(BLACK, picture.rgb(column, 99 - row));
  }

  @Test
  void widePicture_hasItsFieldOfViewAcross_andSquarePixels() {
    Stage stage = dark();
    stage.add(block(2, 0, 0, 0.5, new Rgb(1, 0, 0)));
    Picture wide = new Picture(200, 60);
    new SoftwareCamera(stage).take(eye, wide);
    double half = 2 * FOCAL_PX * 0.25 / 2;
    for (int row = 0; row < 60; row++) {
      for (int column = 0; column < 200; column++) {
        boolean inside = Math.max(Math.abs(column - 99.5), Math.abs(row - 29.5)) < half;
        assertEquals(inside ? RED : BLACK, wide.rgb(column, row), column + ", " + row);
      }
    }
  }

  @Test
  void nearer_hidesFarther_whateverTheOrder() {
    Visual near = block(2, 0, 0, 0.5, new Rgb(1, 0, 0));
    Visual far = block(2.001, 0, 0.2, 0.5, new Rgb(0, 1, 0));
    Stage nearFirst = dark();
    nearFirst.add(near);
    nearFirst.add(far);
    Stage farFirst = dark();
    farFirst.add(far);
    farFirst.add(near);
    int[] pixels = take(nearFirst).argb().clone();
    assertArrayEquals(pixels, take(farFirst).argb());
    assertEquals(RED, picture.rgb(60, 50));
    assertEquals(GREEN, picture.rgb(74, 50));
  }

  /**
   * Light by the formula: with the lamp on the eye's axis all corners of the face are equal. Colour
   * 0.5, 0.25, 0; cosine 4 / sqrt(4^2 + 2 * 1^2) at the corners of a face of 2 m.
   */
  @Test
  void facingWall_isAsBrightAsTheFormulaSays() {
    Stage stage = lit(new PointLight(-1, 0, 0, new Rgb(1, 0.5f, 1)));
    stage.add(litBlock(3, 2, new Rgb(0.5f, 0.25f, 0)));
    take(stage);
    double light = 4 / Math.sqrt(18) / 0.5;
    long red = Math.round(255 * 0.5 * (0.08 + light));
    long green = Math.round(255 * 0.25 * (0.08 + 0.5 * light));
    assertEquals((red << 16) + (green << 8), picture.rgb(50, 50));
    assertEquals(picture.rgb(50, 50), picture.rgb(20, 30));
  }

  @Test
  void facingWall_thatIsTooBright_isFullyBright() {
    Stage stage = lit(new PointLight(0, 0, 0, Rgb.WHITE), new PointLight(1, 0, 0, Rgb.WHITE));
    stage.add(litBlock(3, 1, new Rgb(0.8f, 0.8f, 0)));
    assertEquals(RED | GREEN, take(stage).rgb(50, 50));
  }

  @Test
  void wall_withTheLampBehindIt_showsTheAmbientLightAlone() {
    Stage stage = lit(new PointLight(9, 0, 0, Rgb.WHITE));
    stage.add(litBlock(3, 2, new Rgb(1, 0, 0.5f)));
    long red = Math.round(255 * 0.08);
    long blue = Math.round(255 * 0.04);
    assertEquals((red << 16) + blue, take(stage).rgb(50, 50));
  }

  /** Between corners of different light the colour is in between, linear in space. */
  @Test
  void wall_litFromAside_isInterpolatedBetweenItsCorners() {
    PointLight lamp = new PointLight(2, 0, 5, Rgb.WHITE);
    Stage stage = lit(lamp);
    stage.add(litBlock(3, 2, new Rgb(0.5f, 0.5f, 0.5f)));
    take(stage);
    double left = 1 / Math.sqrt(1 + 36 + 1) / 0.5;
    double right = 1 / Math.sqrt(1 + 16 + 1) / 0.5;
    double column = 70;
    double z = (column + 0.5 - 50) * 3 / FOCAL_PX;
    double light = left + (z + 1) / 2 * (right - left);
    assertEquals(255 * 0.5 * (0.08 + light), picture.rgb(70, 50) & 0xff, 0.501);
  }

  @Test
  void facesTurnedAway_areNotDrawn() {
    Stage stage = dark();
    stage.add(new Visual(eye, () -> List.of(Facets.plain(new BallShape(1), Rgb.WHITE))));
    assertEquals(BLACK, take(stage).rgb(50, 50));
  }

  @Test
  void tooNear_isNotDrawn() {
    for (double depth : new double[] {0.3999, 0.4001, -3}) {
      Stage stage = dark();
      stage.add(block(depth, 0, 0, 1, new Rgb(1, 0, 0)));
      assertEquals(depth > 0.4 ? RED : BLACK, take(stage).rgb(50, 50), "depth " + depth);
    }
  }

  /** A floor that goes on behind the eye is cut, and ends where its far edge is. */
  @Test
  void floor_belowTheEye_reachesToItsEdge() {
    Stage stage = dark();
    BoxShape floor = BoxShape.ofSides(20, 0, 2000);
    stage.add(new Visual(new Placement(), () -> List.of(Facets.plain(floor, new Rgb(0, 1, 0)))));
    eye.moveTo(0, 0.5, 0);
    take(stage);
    double edge = 50 + 0.05 * FOCAL_PX;
    for (int row = 0; row < 100; row++) {
      for (int column = 0; column < 100; column += 33) {
        assertEquals(row + 0.5 > edge ? GREEN : BLACK, picture.rgb(column, row), "row " + row);
      }
    }
  }

  @Test
  void hidden_isNotDrawn_norItsParts() {
    Visual far = block(3, 0, 0, 1, new Rgb(1, 0, 0));
    far.add(block(-1.5, 0, 0, 0.3, new Rgb(0, 1, 0)));
    Stage stage = dark();
    stage.add(far);
    assertEquals(GREEN, take(stage).rgb(50, 50));
    far.parts().get(0).setPresent(false);
    assertEquals(RED, take(stage).rgb(50, 50));
    far.parts().get(0).setPresent(true);
    far.setPresent(false);
    assertEquals(BLACK, take(stage).rgb(50, 50));
  }

  @Test
  void eye_turnedToTheLeft_seesWhatIsThere() {
    Stage stage = dark();
    stage.add(block(2, 0, 0, 1, new Rgb(1, 0, 0)));
    BoxShape box = BoxShape.ofSides(1, 1, 1);
    stage.add(
        new Visual(Placement.at(0, 0, -2), () -> List.of(Facets.plain(box, new Rgb(0, 1, 0)))));
    eye.turnQuarters(1);
    assertEquals(GREEN, take(stage).rgb(50, 50));
  }

  @Test
  void picture_ofTheSame_isTheSame() {
    Stage stage = lit(new PointLight(-1, 2, 3, Rgb.WHITE));
    Placement moving = Placement.at(4, 0, 0);
    stage.add(new Visual(moving, () -> List.of(Facets.lit(new BallShape(1), Rgb.WHITE))));
    SoftwareCamera camera = new SoftwareCamera(stage);
    camera.take(eye, picture);
    int[] first = picture.argb().clone();
    moving.moveTo(4, 0, 0.2);
    camera.take(eye, picture);
    assertFalse(Arrays.equals(first, picture.argb()));
    moving.moveTo(4, 0, 0);
    camera.take(eye, picture);
    assertArrayEquals(first, picture.argb());
    assertArrayEquals(first, take(stage).argb());
  }

  @Test
  void look_changed_isDrawn() {
    Rgb[] colour = {new Rgb(1, 0, 0)};
    Visual visual =
        new Visual(Placement.at(3, 0, 0), () -> List.of(Facets.plain(new BallShape(1), colour[0])));
    Stage stage = dark();
    stage.add(visual);
    SoftwareCamera camera = new SoftwareCamera(stage);
    camera.take(eye, picture);
    colour[0] = new Rgb(0, 1, 0);
    camera.take(eye, picture);
    assertEquals(RED, picture.rgb(50, 50));
    visual.lookChanged();
    camera.take(eye, picture);
    assertEquals(GREEN, picture.rgb(50, 50));
  }
}
