package simbad.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simbad.figures.site.FigureOrigin;

/**
 * Published figures of an older program: since the commit that measured them one of the rooms that
 * they speak of has changed, or nobody knows, since that commit is not there.
 */
final class StaleFigures {
  private static final String FIGURES = "docs/figures";

  private StaleFigures() {}

  /**
   * Finds them.
   *
   * @param commit that is to be released
   * @return each by name, with the commit that measured it
   */
  static List<String> of(Commit commit) throws IOException, InterruptedException {
    List<String> stale = new ArrayList<>();
    for (FigureOrigin origin : FigureOrigin.read(commit.folder().resolve(FIGURES))) {
      List<String> sources = sources(commit.folder(), origin.folders());
      if (!commit.hasSameFilesAs(origin.commit(), sources)) {
        stale.add(origin.figure() + " (" + origin.commit() + ")");
      }
    }
    return stale;
  }

  /**
   * A test that changed makes no figure another one, nor does what a figure leaves out of a room.
   */
  private static List<String> sources(Path project, List<String> rooms) {
    return rooms.stream().map(room -> source(project, room)).toList();
  }

  private static String source(Path project, String room) {
    if (room.startsWith("!")) {
      return ":" + room;
    }
    return Files.exists(project.resolve(room).resolve("src/main")) ? room + "/src/main" : room;
  }
}
