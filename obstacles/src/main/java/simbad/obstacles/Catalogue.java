package simbad.obstacles;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.SensorFile;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/** The obstacle types and the sensor that come with the project. */
public final class Catalogue {
  private static final String FOLDER = "data/";

  private Catalogue() {}

  /** Returns the types in the order of the thesis: square, round, angle. */
  public static List<ObstacleType> types() {
    return List.of(
        type("square", CrossSections.square(), "square-25mm.csv"),
        type("round", CrossSections.round(), "round-25mm.csv"),
        new ObstacleType("angle", CrossSections.angle(), angleTable()));
  }

  /** Returns the measured table of the angle, from which others are reconstructed. */
  public static TableDocument angleTable() {
    return table("angle-25mm.csv");
  }

  /**
   * Finds a type by name.
   *
   * @param name as on the command line
   */
  public static Optional<ObstacleType> find(String name) {
    return types().stream().filter(type -> type.name().equals(name)).findFirst();
  }

  /** Returns the Devantech SRF04. */
  public static SonarSpec srf04() {
    String name = "sensors/srf04.json";
    try {
      return SensorFile.parse(Path.of(name), text(name));
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  private static ObstacleType type(String name, Outline outline, String tableFile) {
    return new ObstacleType(name, outline, table(tableFile));
  }

  private static TableDocument table(String file) {
    String name = "threshold-plots/" + file;
    try {
      return TableFile.parse(Path.of(name), text(name));
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  /** These files are part of the program: one that is missing or wrong is a fault of the build. */
  private static String text(String name) {
    try (InputStream in = Catalogue.class.getResourceAsStream(FOLDER + name)) {
      if (in == null) {
        throw new IllegalStateException(name + " is not in the program");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
