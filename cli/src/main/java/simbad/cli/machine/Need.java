package simbad.cli.machine;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * A row of the project's list of what a machine needs.
 *
 * @param purposes for what it is needed: names of {@link Purpose}
 * @param kind how it is looked for
 * @param name what is looked for
 * @param packages of Debian that bring it
 */
record Need(List<String> purposes, Kind kind, String name, List<String> packages) {
  /** The one list; the launcher reads it, too. */
  private static final Path LIST = Path.of("build-config", "packages.txt");

  private static final int COLUMNS = 4;

  Need {
    purposes = List.copyOf(purposes);
    packages = List.copyOf(packages);
  }

  /** How something is looked for. */
  enum Kind {
    /** A program or library of the Java that runs this, seen from its folder bin. */
    JAVA,
    /** A program on the path. */
    PROGRAM,
    /** A program on the path that Debian has and its kin do not. */
    DEBIAN,
    /** A file among the system's libraries, by the begin of its name; one of several. */
    LIBRARY,
    /** A file among the C headers. */
    HEADER,
    /** Any font. */
    FONT,
    /** Modules of Python. */
    PYTHON,
    /** A script of the project that prints, with --missing, the packages that it lacks. */
    SCRIPT
  }

  /**
   * Reads the list.
   *
   * @param project folder of the project
   * @throws IOException if it is not there, or a row of it is none
   */
  static List<Need> of(Path project) throws IOException {
    Path file = project.resolve(LIST);
    List<Need> needs = new ArrayList<>();
    int number = 0;
    for (String line : Files.readAllLines(file)) {
      number++;
      if (!line.isBlank() && !line.startsWith("#")) {
        needs.add(row(file, number, line.strip().split("\\s+", COLUMNS)));
      }
    }
    return needs;
  }

  private static Need row(Path file, int number, String... cells) throws IOException {
    try {
      Kind kind = Kind.valueOf(cells[1].toUpperCase(Locale.ROOT));
      return new Need(List.of(cells[0].split(",", -1)), kind, cells[2], words(cells[3]));
    } catch (IllegalArgumentException | ArrayIndexOutOfBoundsException e) {
      throw new IOException(file + ":" + number + ": not a row: " + String.join(" ", cells), e);
    }
  }

  private static List<String> words(String cell) {
    return List.of(cell.split(" +", -1));
  }

  boolean isFor(Purpose purpose) {
    return purposes.contains(purpose.word());
  }

  /** Whether it can be looked for elsewhere than on Debian and its kin, too: Java and Maven. */
  boolean isEverywhere() {
    boolean isForBuild = isFor(Purpose.BUILD) || isFor(Purpose.RUN);
    return isForBuild && (kind == Kind.JAVA || kind == Kind.PROGRAM);
  }
}
