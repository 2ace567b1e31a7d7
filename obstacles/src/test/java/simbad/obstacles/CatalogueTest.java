package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.Provenance;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

class CatalogueTest {
  @Test
  void types_standInTheThesisOrder() {
    assertEquals(
        List.of("square", "round", "angle"),
        Catalogue.types().stream().map(ObstacleType::name).toList());
  }

  /** The thesis prints the angle's numbers only; the other two were plotted. */
  @ParameterizedTest
  @CsvSource({"square, RECONSTRUCTED", "round, RECONSTRUCTED", "angle, MEASURED"})
  void provenance_measuredForTheAngleOnly(String name, Provenance provenance) {
    ObstacleType type = Catalogue.find(name).orElseThrow();
    assertEquals(Optional.of(provenance), type.thresholds().provenance());
    assertTrue(type.thresholds().header("source").orElse("").contains("Kranz 2014"));
  }

  @ParameterizedTest
  @ValueSource(strings = {"square", "round", "angle"})
  void table_hasTheThesisSweepOf72(String name) {
    ObstacleType type = Catalogue.find(name).orElseThrow();
    assertEquals(72, type.thresholds().table().size());
    assertTrue(type.thresholds().table().greatestM() >= 2);
  }

  @Test
  void angleTable_isTheAngleType() {
    assertEquals(Catalogue.find("angle").orElseThrow().thresholds(), Catalogue.angleTable());
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "Angle", "octagon", "angle-25mm.csv"})
  void find_ofAnUnknownName_isEmpty(String name) {
    assertEquals(Optional.empty(), Catalogue.find(name));
  }

  /** Devantech: 55 degrees at -6 dB all told; DESIGN: 0.03 m to 6 m in steps of 1 cm. */
  @Test
  void srf04_hasDevantechsFigures() {
    SonarSpec spec = Catalogue.srf04();
    assertEquals(27.5, Math.toDegrees(spec.coneHalfAngleRad()), 1e-12);
    assertEquals(0.03, spec.minRangeM());
    assertEquals(6, spec.maxRangeM());
    assertEquals(0.01, spec.resolutionM());
  }

  /** One inch is 25.4 mm: every section spans -12.7 to 12.7 mm on both axes. */
  @ParameterizedTest
  @ValueSource(strings = {"square", "round", "angle"})
  void crossSection_isOneInchWide(String name) {
    Outline outline = Catalogue.find(name).orElseThrow().outline();
    double least = 0;
    double most = 0;
    for (int i = 0; i < outline.size(); i++) {
      least = Math.min(least, Math.min(outline.xM(i), outline.zM(i)));
      most = Math.max(most, Math.max(outline.xM(i), outline.zM(i)));
    }
    assertEquals(-0.0127, least, 1e-12);
    assertEquals(0.0127, most, 1e-12);
  }

  /** The metal's area: two legs of an inch, a sixteenth thick, less the corner counted twice. */
  @Test
  void angle_hasTwoLegsOfASixteenth() {
    double inch = 0.0254;
    double thick = inch / 16;
    assertEquals(2 * inch * thick - thick * thick, areaM2(CrossSections.angle()), 1e-12);
  }

  /** A regular polygon of 24 corners: 12 r^2 sin 15 degrees. */
  @Test
  void round_isRegular() {
    double expected = 12 * 0.0127 * 0.0127 * Math.sin(Math.toRadians(15));
    assertEquals(expected, areaM2(CrossSections.round()), 1e-12);
  }

  private static double areaM2(Outline outline) {
    double twice = 0;
    for (int i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
      twice += outline.xM(j) * outline.zM(i) - outline.xM(i) * outline.zM(j);
    }
    return Math.abs(twice) / 2;
  }

  /** A jar whose list of services names a class that is not in it. */
  @Test
  void brokenJar_isNamed(@TempDir Path folder) throws Exception {
    Path services = Files.createDirectories(folder.resolve("META-INF/services"));
    Files.writeString(services.resolve(ObstacleTypeProvider.class.getName()), "NoSuchTypes\n");
    Thread thread = Thread.currentThread();
    ClassLoader before = thread.getContextClassLoader();
    try (URLClassLoader broken = new URLClassLoader(new URL[] {folder.toUri().toURL()}, before)) {
      thread.setContextClassLoader(broken);
      DataFormatException fault = assertThrows(DataFormatException.class, Catalogue::all);
      assertTrue(
          String.valueOf(fault.getMessage()).contains("Provider NoSuchTypes not found"),
          fault.getMessage());
    } finally {
      thread.setContextClassLoader(before);
    }
  }

  @Test
  void namedObstacles_areTheirTypes() {
    Vector3d at = new Vector3d();
    assertEquals("square", new SquareObstacle(at, 0).type().name());
    assertEquals("round", new RoundObstacle(at, 0).type().name());
    assertEquals("angle", new AngleObstacle(at, 0).type().name());
  }

  /** By their names however they are spelt; data sheets say the greatest range of each. */
  @Test
  void sonars_areFoundByName() {
    assertEquals(List.of("hc-sr04", "srf04", "maxbotix-lv-ez1"), Catalogue.sonars());
    assertEquals(Catalogue.srf04(), Catalogue.findSonar("SRF-04").orElseThrow());
    assertEquals(4, Catalogue.findSonar("HCSR04").orElseThrow().maxRangeM());
    assertEquals(Optional.empty(), Catalogue.findSonar("srf05"));
    for (String name : Catalogue.sonars()) {
      assertTrue(Catalogue.findSonar(name).isPresent(), name);
    }
  }
}
