package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.awt.GraphicsEnvironment;
import java.util.Optional;
import javax.media.j3d.Shape3D;
import javax.media.j3d.TriangleArray;
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
    assertNotEquals(
        0f, shape.getAppearance().getTransparencyAttributes().getTransparency(), "transparency");
  }
}
