package simbad.obstacles;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.Set;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OutlineFile;
import simbad.sonar.format.SensorFile;
import simbad.sonar.format.ShippedText;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.shape.Outline;

/** The obstacle types and the sensor that come with the project, and the types that users add. */
public final class Catalogue {
  private static final String FOLDER = "data/";

  /** Names the folder of one's own types. */
  public static final String FOLDER_PROPERTY = "simbad.obstacles";

  /** Names the folder of one's own types where the property does not. */
  public static final String FOLDER_VARIABLE = "SIMBAD_OBSTACLES";

  /** Types whose tables are predicted from their cross-sections (data/obstacles). */
  private static final List<String> PREDICTED =
      List.of("half-round", "hexagon", "plate", "tee", "channel", "leg-pair");

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

  /** Returns the types that come with the project: the thesis's three, then the predicted ones. */
  public static List<ObstacleType> shipped() {
    List<ObstacleType> shipped = new ArrayList<>(types());
    PREDICTED.forEach(name -> shipped.add(shipped(name)));
    return shipped;
  }

  /**
   * Returns all types by name: {@link #shipped()}, those of {@link ObstacleTypeProvider}s, and
   * those in the folder that the system property {@value #FOLDER_PROPERTY} or else the environment
   * variable {@value #FOLDER_VARIABLE} names. Of two with one name the first stands.
   *
   * @throws DataFormatException if a file in that folder is broken, or a jar names a provider that
   *     it does not hold
   */
  public static List<ObstacleType> all() throws DataFormatException {
    List<ObstacleType> all = new ArrayList<>(shipped());
    all.addAll(provided());
    Optional<Path> folder = ownFolder();
    if (folder.isPresent()) {
      all.addAll(ObstacleFiles.scan(folder.get()));
    }
    Set<String> names = new HashSet<>();
    return all.stream().filter(type -> names.add(type.name())).toList();
  }

  private static List<ObstacleType> provided() throws DataFormatException {
    List<ObstacleType> types = new ArrayList<>();
    try {
      for (ObstacleTypeProvider provider : ServiceLoader.load(ObstacleTypeProvider.class)) {
        types.addAll(provider.types());
      }
    } catch (ServiceConfigurationError e) {
      throw DataFormatException.inArgument(
          "a jar of the class path", String.valueOf(e.getMessage()));
    }
    return types;
  }

  private static Optional<Path> ownFolder() {
    String variable = System.getenv(FOLDER_VARIABLE);
    String named = System.getProperty(FOLDER_PROPERTY, variable == null ? "" : variable);
    return named.isEmpty() ? Optional.empty() : Optional.of(Path.of(named));
  }

  /**
   * Finds one of the types that come with the project.
   *
   * @param name as on the command line
   */
  public static Optional<ObstacleType> find(String name) {
    return PREDICTED.contains(name)
        ? Optional.of(shipped(name))
        : types().stream().filter(type -> type.name().equals(name)).findFirst();
  }

  /**
   * Finds a type by name among {@link #all}.
   *
   * @param name as on the command line
   * @throws DataFormatException if the folder of one's own types has to be looked into and a file
   *     in it is broken, or the type of that name has an outline and no table
   */
  public static Optional<ObstacleType> findAny(String name) throws DataFormatException {
    Optional<ObstacleType> shipped = find(name);
    if (shipped.isPresent()) {
      return shipped;
    }
    Optional<ObstacleType> other =
        all().stream().filter(type -> type.name().equals(name)).findFirst();
    Optional<Path> folder = ownFolder();
    // What is only half there is none of all, but whoever asks for it by name wants to know why.
    return other.isPresent() || folder.isEmpty() ? other : ObstacleFiles.find(folder.get(), name);
  }

  private static ObstacleType shipped(String name) {
    String folder = "obstacles/" + name + "/";
    try {
      return new ObstacleType(
          name,
          OutlineFile.parse(Path.of(folder + "outline.csv"), text(folder + "outline.csv")).parts(),
          TableFile.parse(Path.of(folder + "table.csv"), text(folder + "table.csv")));
    } catch (DataFormatException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Returns the Devantech SRF04. */
  public static SonarSpec srf04() {
    return sonar("srf04");
  }

  /** Returns the names of the sensors that come with the project. */
  public static List<String> sonars() {
    return List.of("hc-sr04", "srf04", "maxbotix-lv-ez1");
  }

  /**
   * Finds a sensor by its name, however it is spelt: hc-sr04, HCSR04.
   *
   * @param name as on the command line
   */
  public static Optional<SonarSpec> findSonar(String name) {
    return sonars().stream()
        .filter(known -> plain(known).equals(plain(name)))
        .findFirst()
        .map(Catalogue::sonar);
  }

  private static String plain(String name) {
    return name.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]", "");
  }

  private static SonarSpec sonar(String known) {
    String name = "sensors/" + known + ".json";
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

  private static String text(String name) {
    return ShippedText.read(Catalogue.class, FOLDER + name);
  }
}
