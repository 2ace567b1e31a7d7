package simbad.obstacles;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.Provenance;
import simbad.sonar.shape.Outline;

class ObstacleFilesTest {
  private static final String OUTLINE = "x_mm,z_mm\n5,5\n5,-5\n-5,-5\n-5,5\n";
  private static final String TABLE = "bearing_deg,threshold_m\n0,1\n120,2\n240,1.5\n";

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private Path typeFolder(String name, String table) throws IOException {
    Path own = Files.createDirectory(folder.resolve(name));
    Files.writeString(own.resolve("outline.csv"), OUTLINE);
    Files.writeString(own.resolve("table.csv"), table);
    return own;
  }

  private Path pair(String name) throws IOException {
    Files.writeString(folder.resolve(name + "-outline.csv"), OUTLINE);
    return Files.writeString(folder.resolve(name + ".csv"), TABLE);
  }

  private static void checkPost(ObstacleType type, String name) {
    assertEquals(name, type.name());
    assertEquals(4, type.outline().size());
    assertEquals(1e-4, type.outline().signedAreaM2(), 1e-12);
    assertEquals(3, type.thresholds().table().size());
  }

  @Test
  void folder_isAType() throws IOException, DataFormatException {
    checkPost(ObstacleFiles.read(typeFolder("post", TABLE)), "post");
  }

  @Test
  void pair_isAType() throws IOException, DataFormatException {
    checkPost(ObstacleFiles.read(pair("post")), "post");
  }

  /** Without a cross-section a table stands for the thesis's round post. */
  @Test
  void tableAlone_isOnARoundPost() throws IOException, DataFormatException {
    Path table = Files.writeString(folder.resolve("mine.csv"), TABLE);
    assertEquals(CrossSections.round(), ObstacleFiles.read(table).outline());
  }

  @Test
  void scan_findsFoldersAndPairs_andNothingElse() throws IOException, DataFormatException {
    typeFolder("zebra", TABLE);
    pair("ant");
    Files.writeString(folder.resolve("lonely.csv"), TABLE);
    Files.createDirectory(folder.resolve("empty"));
    assertEquals(
        List.of("ant", "zebra"),
        ObstacleFiles.scan(folder).stream().map(ObstacleType::name).toList());
  }

  @Test
  void scan_ofNoFolder_isRefused() {
    DataFormatException fault =
        assertThrows(
            DataFormatException.class, () -> ObstacleFiles.scan(folder.resolve("nowhere")));
    assertTrue(String.valueOf(fault.getMessage()).contains("is not a folder that can be read"));
  }

  /** A table within the body, and one that was made for another size. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "bearing_deg,threshold_m\n0,0.001\n120,0.002\n240,0.003\n",
        "# reach_m: 0.0500\nbearing_deg,threshold_m\n0,1\n120,2\n240,1.5\n"
      })
  void sizesThatDoNotFit_areRefused(String table) throws IOException {
    Path own = typeFolder("post", table);
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> ObstacleFiles.read(own));
    assertTrue(String.valueOf(fault.getMessage()).contains("table.csv: "), fault.getMessage());
    assertTrue(String.valueOf(fault.getMessage()).contains("reaches 0.0071 m"), fault.getMessage());
  }

  @Test
  void missingHalf_isNamed() throws IOException {
    Path own = typeFolder("post", TABLE);
    Files.delete(own.resolve("table.csv"));
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> ObstacleFiles.read(own));
    String message = String.valueOf(fault.getMessage());
    assertTrue(message.contains("table.csv: no such file; to predict it: simbad table predict"));
  }

  /** The property names a folder; what is in it is known by name, behind what comes along. */
  @Test
  void catalogue_hasTheFoldersTypes() throws IOException, DataFormatException {
    typeFolder("my-post", TABLE);
    typeFolder("angle", TABLE);
    System.setProperty(Catalogue.FOLDER_PROPERTY, folder.toString());
    try {
      checkPost(Catalogue.findAny("my-post").orElseThrow(), "my-post");
      assertEquals(Catalogue.find("angle"), Catalogue.findAny("angle"));
      assertEquals(Optional.empty(), Catalogue.findAny("your-post"));
      Files.delete(typeFolder("half", TABLE).resolve("table.csv"));
      assertEquals(Optional.empty(), Catalogue.findAny("your-post"));
      String half =
          String.valueOf(
              assertThrows(DataFormatException.class, () -> Catalogue.findAny("half"))
                  .getMessage());
      assertTrue(half.contains("table.csv: no such file; to predict it: simbad table"), half);
    } finally {
      System.clearProperty(Catalogue.FOLDER_PROPERTY);
    }
  }

  /** The service file of the tests names {@link ProvidedTypes}. */
  @Test
  void catalogue_hasTheProvidersTypes() throws DataFormatException {
    assertEquals(CrossSections.square(), Catalogue.findAny("provided").orElseThrow().outline());
  }

  @ParameterizedTest
  @ValueSource(strings = {"half-round", "hexagon", "plate", "tee", "channel", "leg-pair"})
  void predictedTypes_comeAlong(String name) throws DataFormatException {
    ObstacleType type = Catalogue.findAny(name).orElseThrow();
    assertEquals(Optional.of(Provenance.PREDICTED), type.thresholds().provenance());
    assertEquals(72, type.thresholds().table().size());
    assertTrue(type.thresholds().table().greatestM() > 1.5, name);
    SonarObstacle inWorld = new SonarObstacle(new Vector3d(1, 0, 2), 0.5, type);
    assertEquals(type.parts().size(), inWorld.bodyShapes().size());
    assertEquals(type.thresholds().table(), inWorld.shadow().table());
  }

  @Test
  void legPair_hasTwoBodies() {
    ObstacleType pair = Catalogue.find("leg-pair").orElseThrow();
    assertEquals(2, pair.parts().size());
    double areas = pair.parts().stream().mapToDouble(Outline::signedAreaM2).sum();
    assertEquals(areas, pair.outline().signedAreaM2(), 1e-12, "the joining line has no area");
  }
}
