package simbad.obstacles;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.OutlineDocument;
import simbad.sonar.format.OutlineFile;
import simbad.sonar.format.TableDocument;
import simbad.sonar.format.TableFile;

/**
 * Obstacle types without code: a folder {@code NAME} with {@code outline.csv} and {@code
 * table.csv}, or two files {@code NAME-outline.csv} and {@code NAME.csv} side by side.
 */
public final class ObstacleFiles {
  private static final String SUFFIX = ".csv";
  private static final String OUTLINE = "outline.csv";
  private static final String TABLE = "table.csv";
  private static final String REACH = "reach_m";
  private static final double SAME_SIZE = 0.01;

  private ObstacleFiles() {}

  /**
   * Reads a type.
   *
   * @param path a folder with both files, or the table of a pair; a table without an outline beside
   *     it stands for the one inch round post
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static ObstacleType read(Path path) throws DataFormatException {
    if (Files.isDirectory(path)) {
      if (Files.notExists(path.resolve(OUTLINE)) && Files.notExists(path.resolve(TABLE))) {
        throw DataFormatException.inFile(path, "is a folder without " + OUTLINE + " and " + TABLE);
      }
      return type(name(path), path.resolve(OUTLINE), path.resolve(TABLE));
    }
    Path outline = outlineBeside(path);
    if (Files.exists(outline)) {
      return type(name(path), outline, path);
    }
    return new ObstacleType(name(path), CrossSections.round(), TableFile.read(path));
  }

  /**
   * Returns the files that {@link #read} reads, whether they are there or not, but for an outline
   * that a table may do without.
   *
   * @param path as for reading
   */
  public static List<Path> files(Path path) {
    if (Files.isDirectory(path)) {
      return List.of(path.resolve(OUTLINE), path.resolve(TABLE));
    }
    Path outline = outlineBeside(path);
    return Files.exists(outline) ? List.of(path, outline) : List.of(path);
  }

  /** The file that holds the outline to a pair's table. */
  private static Path outlineBeside(Path table) {
    return table.resolveSibling(stem(table) + "-" + OUTLINE);
  }

  private static ObstacleType type(String name, Path outline, Path table)
      throws DataFormatException {
    OutlineDocument section = OutlineFile.read(outline);
    if (!Files.exists(table)) {
      throw DataFormatException.inFile(
          table,
          "no such file; to predict it: simbad table predict " + outline + " --out " + table);
    }
    TableDocument thresholds = TableFile.read(table);
    checkSizes(section, outline, thresholds, table);
    return new ObstacleType(name, section.parts(), thresholds);
  }

  /** Both files are there, but do they speak of one thing? */
  static void checkSizes(
      OutlineDocument section, Path outline, TableDocument thresholds, Path table)
      throws DataFormatException {
    double reachM = section.reachM();
    double greatestM = thresholds.table().greatestM();
    if (greatestM > 0 && greatestM <= reachM) {
      throw DataFormatException.inFile(
          table,
          "its greatest threshold, "
              + greatestM
              + " m, is inside the outline: "
              + outline
              + " reaches "
              + metres(reachM)
              + " m from the axis");
    }
    String stated = thresholds.header(REACH).orElse("");
    if (stated.matches("\\d+(\\.\\d+)?")
        && Math.abs(Double.parseDouble(stated) - reachM) > SAME_SIZE * reachM) {
      throw DataFormatException.inFile(
          table,
          "was made for a cross-section that reaches "
              + stated
              + " m from its axis (reach_m), but "
              + outline
              + " reaches "
              + metres(reachM)
              + " m");
    }
  }

  private static String metres(double value) {
    return String.format(Locale.ROOT, "%.4f", value);
  }

  /**
   * Finds the types in a folder: folders that hold both files, and pairs of files.
   *
   * @param folder to look through, not what is in its folders' folders
   * @return in the order of their names
   * @throws DataFormatException for the first type that is broken, and for a folder that is none
   */
  public static List<ObstacleType> scan(Path folder) throws DataFormatException {
    List<ObstacleType> types = new ArrayList<>();
    for (Path path : entries(folder)) {
      boolean holdsBoth = Files.exists(path.resolve(OUTLINE)) && Files.exists(path.resolve(TABLE));
      boolean isPair = path.toString().endsWith(SUFFIX) && Files.exists(outlineBeside(path));
      if (holdsBoth || isPair) {
        types.add(read(path));
      }
    }
    return types;
  }

  /** Finds a type whose outline is there, by the name of its folder. */
  static Optional<ObstacleType> find(Path folder, String name) throws DataFormatException {
    for (Path path : entries(folder)) {
      if (String.valueOf(path.getFileName()).equals(name) && Files.exists(path.resolve(OUTLINE))) {
        return Optional.of(read(path));
      }
    }
    return Optional.empty();
  }

  private static List<Path> entries(Path folder) throws DataFormatException {
    try (Stream<Path> entries = Files.list(folder)) {
      return entries.sorted().toList();
    } catch (IOException e) {
      throw DataFormatException.inFile(folder, "is not a folder that can be read");
    }
  }

  private static String stem(Path file) {
    String name = String.valueOf(file.getFileName());
    return name.endsWith(SUFFIX) ? name.substring(0, name.length() - SUFFIX.length()) : name;
  }

  /**
   * The name becomes a folder and part of a page; without a dot it is none of a run's own files.
   */
  private static String name(Path path) {
    String plain = stem(path.toAbsolutePath().normalize()).replaceAll("[^\\p{L}\\p{N}_-]", "_");
    return plain.isEmpty() ? "table" : plain;
  }
}
