package simbad.figures.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * When a published figure was measured, and which rooms it speaks of: a row of {@code
 * docs/figures/origins.csv}.
 *
 * @param figure name of its file without ".txt"
 * @param commit of the program that measured it
 * @param date of the measurement, ISO 8601
 * @param folders of the project that it depends on: where one of them changed since, it is stale;
 *     with a "!" before it one that it leaves out
 */
public record FigureOrigin(String figure, String commit, String date, List<String> folders) {
  private static final String FILE = "origins.csv";
  private static final String HEADER = "figure,commit,date,folders";
  private static final int COLUMNS = 4;

  /** Copies the list. */
  public FigureOrigin {
    folders = List.copyOf(folders);
  }

  /**
   * Reads all origins; none where there is no such file.
   *
   * @param figures the folder of measured files
   * @throws IOException if a row cannot be read
   */
  public static List<FigureOrigin> read(Path figures) throws IOException {
    Path file = figures.resolve(FILE);
    List<FigureOrigin> origins = new ArrayList<>();
    if (Files.exists(file)) {
      List<String> lines = Files.readAllLines(file);
      for (int i = 0; i < lines.size(); i++) {
        if (i > 0 || !lines.get(i).equals(HEADER)) {
          origins.add(of(lines.get(i), file + ", line " + (i + 1)));
        }
      }
    }
    return origins;
  }

  private static FigureOrigin of(String line, String place) throws IOException {
    String[] cells = line.split(",", -1);
    if (cells.length != COLUMNS || !cells[1].matches("[0-9a-f]{7,40}")) {
      throw new IOException(place + ": \"" + line + "\" is not a row of " + HEADER);
    }
    return new FigureOrigin(cells[0], cells[1], cells[2], List.of(cells[3].split(" ", -1)));
  }

  /**
   * Returns the origin of a figure.
   *
   * @param figure name
   * @param origins that were read
   * @throws IOException if it has none
   */
  static FigureOrigin of(String figure, List<FigureOrigin> origins) throws IOException {
    return origins.stream()
        .filter(origin -> origin.figure.equals(figure))
        .findFirst()
        .orElseThrow(() -> new IOException(FILE + ": has no row of figure " + figure));
  }
}
