package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.GraphicsEnvironment;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import javax.media.j3d.Shape3D;
import javax.media.j3d.TriangleArray;
import javax.vecmath.Color3f;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.shape.DetectionShadow;
import simbad.sonar.shape.ThresholdTable;

class ShadowShapeTest {
  private static final double HEIGHT_M = 0.3;

  private static DetectionShadow shadow(String name) {
    return new DetectionShadow(Catalogue.find(name).orElseThrow().thresholds().table());
  }

  /** Java 3D keeps floats: the very same numbers, each cast once. */
  private static void checkVertices(DetectionShadow shadow, TriangleArray mesh) {
    double[] plain = shadow.triangles(HEIGHT_M);
    assertEquals(plain.length / 3, mesh.getVertexCount());
    float[] vertex = new float[3];
    for (int i = 0; i < mesh.getVertexCount(); i++) {
      mesh.getCoordinate(i, vertex);
      for (int k = 0; k < 3; k++) {
        assertEquals((float) plain[3 * i + k], vertex[k], "vertex " + i);
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"square", "round", "angle"})
  void geometry_holdsThePlainShadowsVertices(String name) {
    checkVertices(shadow(name), ShadowShape.geometry(shadow(name), HEIGHT_M));
  }

  /** 72 cells of four triangles each: bottom, top and two of the wall. */
  @Test
  void geometry_has12VerticesACell() {
    assertEquals(72 * 12, ShadowShape.geometry(shadow("angle"), HEIGHT_M).getVertexCount());
  }

  @ParameterizedTest
  @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
  void geometry_ofAnImpossibleHeight_isRefused(double height) {
    DetectionShadow shadow = new DetectionShadow(ThresholdTable.uniform(4, 1));
    assertThrows(IllegalArgumentException.class, () -> ShadowShape.geometry(shadow, height));
  }

  @Test
  void find_headless_isEmpty() {
    assertEquals(true, GraphicsEnvironment.isHeadless());
    assertEquals(Optional.empty(), ShadowShape.find(shadow("angle"), HEIGHT_M));
  }

  @ParameterizedTest
  @Tag("display")
  @ValueSource(strings = {"square", "round", "angle"})
  void find_withADisplay_isTheMeshSeenThrough(String name) {
    assertEquals(false, GraphicsEnvironment.isHeadless(), "this test needs a display");
    Shape3D shape = ShadowShape.find(shadow(name), HEIGHT_M).orElseThrow();
    checkVertices(shadow(name), (TriangleArray) shape.getGeometry());
    checkLooks(shape);
  }

  /** Burlywood, of which six tenths are let through: the thesis, appendix A.2. */
  private static void checkLooks(Shape3D shape) {
    assertEquals(0.6f, shape.getAppearance().getTransparencyAttributes().getTransparency());
    Color3f colour = new Color3f();
    shape.getAppearance().getColoringAttributes().getColor(colour);
    assertEquals(new Color(222, 184, 135), colour.get());
  }

  @Test
  @Tag("display")
  void namedShadows_areThoseOfTheirObstacles_oneMetreHigh() {
    for (ShadowShape shape : List.of(new SquareShadow(), new RoundShadow(), new AngleShadow())) {
      String name = shape.getClass().getSimpleName().replace("Shadow", "").toLowerCase(Locale.ROOT);
      checkLooks(shape);
      TriangleArray mesh = (TriangleArray) shape.getGeometry();
      assertEquals(shadow(name).triangles(1).length / 3, mesh.getVertexCount());
      float[] vertices = new float[3 * mesh.getVertexCount()];
      mesh.getCoordinates(0, vertices);
      double greatest = 0;
      for (int i = 0; i < vertices.length; i += 3) {
        assertTrue(vertices[i + 1] == 0 || vertices[i + 1] == 1, "height " + vertices[i + 1]);
        greatest = Math.max(greatest, Math.hypot(vertices[i], vertices[i + 2]));
      }
      assertEquals(
          Catalogue.find(name).orElseThrow().thresholds().table().greatestM(), greatest, 1e-6);
    }
  }
}
