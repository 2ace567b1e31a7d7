package simbad.cli;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import simbad.figures.plot.PlotFigure;
import simbad.sonar.format.WholeFile;

/** A single file that a command writes. */
final class OutputFile {
  private OutputFile() {}

  static void refuseExisting(Path file) throws IOException {
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
      throw new FileAlreadyExistsException(file.toString());
    }
    Path folder = file.toAbsolutePath().getParent();
    if (folder != null && !Files.isDirectory(folder)) {
      throw new NoSuchFileException(folder.toString());
    }
  }

  static boolean isPicture(Path file) {
    return isPng(file) || file.toString().toLowerCase(Locale.ROOT).endsWith(".svg");
  }

  private static boolean isPng(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".png");
  }

  /** As PNG or SVG by the file's ending; the file appears when all of it is there. */
  static void draw(PlotFigure figure, Path file) throws IOException {
    WholeFile.create(file, isPng(file) ? figure.png(PlotFigure.PRINT_DPI) : figure.svg());
  }
}
