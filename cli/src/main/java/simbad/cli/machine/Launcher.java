package simbad.cli.machine;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;

/**
 * The script {@code simbad} that started this process, called back for what it does for itself as
 * well: to install packages, and to have Maven package.
 *
 * @param script its path
 */
public record Launcher(Path script) {
  private static final String PROPERTY = "simbad.launcher";

  /** Returns the one that started this process; nothing where Java was called in another way. */
  public static Optional<Launcher> ofThisProcess() {
    String script = System.getProperty(PROPERTY);
    return script == null ? Optional.empty() : Optional.of(new Launcher(Path.of(script)));
  }

  /** Returns the folder with the jars that this process runs. */
  public Path build() {
    return Path.of(System.getProperty("simbad.build", ""));
  }

  /** Returns the folder of the project. */
  public Path project() {
    return Objects.requireNonNull(script.toAbsolutePath().getParent(), "a file lies in a folder");
  }

  /**
   * Installs what is missing for a purpose, if this process was started by the launcher and may;
   * does nothing where all is there.
   *
   * @param purpose what it is needed for
   * @throws SaidAlreadyException if it may not, with the line to type said, or if apt fails
   * @throws IOException if it is still missing, or the launcher cannot be called
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public static void need(Purpose purpose) throws IOException, InterruptedException {
    Optional<Launcher> launcher = ofThisProcess();
    if (launcher.isPresent()) {
      launcher.get().install(purpose);
    }
  }

  private void install(Purpose purpose) throws IOException, InterruptedException {
    Machine machine = Machine.here(project());
    Set<String> missing = machine.missing(purpose);
    if (missing.isEmpty()) {
      return;
    }
    List<String> words = new ArrayList<>(List.of("--install", purpose.why()));
    words.addAll(missing);
    call(words);
    Set<String> still = machine.missing(purpose);
    if (!still.isEmpty()) {
      throw new IOException("installed, but still missing: " + String.join(" ", still));
    }
  }

  /**
   * Has Maven package rooms of a project and what they use, without tests and checks.
   *
   * @param folder of the project, or of a clone of it
   * @param rooms separated by commas
   * @param log file for all that Maven says; what is wrong is said on standard error, too
   * @param more arguments for Maven
   * @throws SaidAlreadyException if it fails
   * @throws IOException if the launcher cannot be called
   * @throws InterruptedException if the thread is interrupted meanwhile
   */
  public void pack(Path folder, String rooms, Path log, List<String> more)
      throws IOException, InterruptedException {
    List<String> words =
        new ArrayList<>(List.of("--package", folder.toString(), rooms, log.toString()));
    words.addAll(more);
    call(words);
  }

  private void call(List<String> words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("bash", script.toString()));
    command.addAll(words);
    if (Children.run(new ProcessBuilder(command).inheritIO()) != 0) {
      throw new SaidAlreadyException();
    }
  }
}
