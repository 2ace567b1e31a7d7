package simbad.experiments.program;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import simbad.sonar.format.DataFormatException;

/** A program as it was found: what can be started, and what it asks for that is not there. */
public final class ProgramFile {
  private static final int MOST_MISSING = 20;

  private final Path path;
  private final ProgramClasses classes;
  private final List<String> missing;

  private ProgramFile(Path path, ProgramClasses classes) {
    this.path = path;
    this.classes = classes;
    missing = MissingMembers.of(classes);
  }

  /**
   * Reads a program, and compiles it if it is sources.
   *
   * @param path a jar, a folder of classes or a folder of sources
   * @param libraries what it needs besides
   * @param errors is told each error in sources
   * @throws DataFormatException if it is none of these, or its sources do not compile
   * @throws IOException if it cannot be read
   */
  public static ProgramFile read(Path path, List<Path> libraries, Consumer<String> errors)
      throws DataFormatException, IOException {
    return new ProgramFile(path, ProgramClasses.read(path, libraries, errors));
  }

  /** Returns what its user should know before it runs, a line each. */
  public List<String> notes() {
    List<String> notes = new ArrayList<>();
    if (!classes.own().isEmpty()) {
      notes.add(
          "passed over: "
              + classes.own().size()
              + " classes of a Simbad of its own, such as "
              + classes.own().get(0));
    }
    missing.stream().limit(MOST_MISSING).map(line -> "not there: " + line).forEach(notes::add);
    if (missing.size() > MOST_MISSING) {
      notes.add("and " + (missing.size() - MOST_MISSING) + " more that are not there");
    }
    return notes;
  }

  /**
   * Plans a run.
   *
   * @param main the class to start; null for the only one that can be
   * @param arguments of its main
   * @throws DataFormatException if there is no such class, or not one only
   */
  public RunPlan plan(@Nullable String main, List<String> arguments, RunPlan.Settings settings)
      throws DataFormatException {
    MainClass found = MainClass.of(classes);
    String name = main != null ? main : only(found);
    if (!found.mains().contains(name) && !found.environments().contains(name)) {
      throw DataFormatException.inArgument(
          "--main",
          "'" + name + "' is no class of " + path + " with a main; it has: " + found.mains());
    }
    return new RunPlan(
        classes,
        name,
        found.mains().contains(name),
        arguments,
        settings.compatibility(),
        settings.steps(),
        settings.seed(),
        settings.traced());
  }

  private String only(MainClass found) throws DataFormatException {
    List<String> candidates = found.mains().isEmpty() ? found.environments() : found.mains();
    if (candidates.contains(classes.mainOfJar())) {
      return classes.mainOfJar();
    }
    if (candidates.size() == 1) {
      return candidates.get(0);
    }
    throw DataFormatException.inFile(
        path,
        candidates.isEmpty()
            ? "has neither a class with a main nor an environment"
            : "has several classes to start; name one by --main: " + candidates);
  }
}
