package simbad.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A commit of a git clone.
 *
 * @param folder of the clone
 * @param name its hash
 */
record Commit(Path folder, String name) {
  /** What the jar is built of, as git takes paths; the launcher looks at the same. */
  private static final List<String> PROGRAM =
      List.of(
          "simbad",
          "LICENSE",
          ".mvn",
          "data",
          "build-config",
          "docs/protocol.csv",
          ":(glob)**/pom.xml",
          ":(glob)*/src/main/**");

  /**
   * The one that is checked out.
   *
   * @param clone its folder
   * @throws IOException if it is none
   */
  static Commit current(Path clone) throws IOException, InterruptedException {
    try {
      return new Commit(clone, git(own(clone, "rev-parse", "-q", "--verify", "HEAD")).strip());
    } catch (IOException e) {
      throw new IOException(clone + " is not a git clone; a release is made from a commit", e);
    }
  }

  /** How many files differ from it. */
  long changes() throws IOException, InterruptedException {
    return git(own(folder, "--no-optional-locks", "status", "--porcelain")).lines().count();
  }

  /** How many of the files that the program is built of differ from it, or are new. */
  long changesOfProgram() throws IOException, InterruptedException {
    List<String> words =
        new ArrayList<>(List.of("--no-optional-locks", "status", "--porcelain", "-uall", "--"));
    words.addAll(PROGRAM);
    return git(own(folder, words.toArray(String[]::new))).lines().count();
  }

  /** When it was made, as Maven takes a time: UTC. */
  String time() throws IOException, InterruptedException {
    return git(own(
            folder, "log", "-1", "--format=%cd", "--date=format-local:%Y-%m-%dT%H:%M:%SZ", name))
        .strip();
  }

  /**
   * Returns whether files and folders are the same in another commit; false where that is not
   * known.
   *
   * @param other hash
   * @param paths from the clone's folder
   */
  boolean hasSameFilesAs(String other, List<String> paths) throws InterruptedException {
    List<String> words = new ArrayList<>(List.of("diff", "--quiet", other, name, "--"));
    words.addAll(paths);
    try {
      git(own(folder, words.toArray(String[]::new)));
      return true;
    } catch (IOException differs) {
      return false;
    }
  }

  /**
   * Makes a clone that has it checked out.
   *
   * @param other folder, that does not exist yet
   */
  void checkOutInto(Path other) throws IOException, InterruptedException {
    git(List.of("clone", "-q", "--shared", "--no-checkout", folder.toString(), other.toString()));
    git(List.of("-C", other.toString(), "checkout", "-q", "--detach", name));
  }

  /** By its folder: git refuses to look for the clone of another account. */
  private static List<String> own(Path clone, String... words) {
    List<String> all =
        new ArrayList<>(List.of("--git-dir=" + clone.resolve(".git"), "--work-tree=" + clone));
    all.addAll(List.of(words));
    return all;
  }

  private static String git(List<String> words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of("git"));
    command.addAll(words);
    ProcessBuilder builder = new ProcessBuilder(command);
    builder.environment().put("TZ", "UTC");
    Process process = builder.start();
    process.getOutputStream().close();
    String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    String complaint = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    if (process.waitFor() != 0) {
      throw new IOException("'" + String.join(" ", command) + "' failed: " + complaint.strip());
    }
    return said;
  }
}
