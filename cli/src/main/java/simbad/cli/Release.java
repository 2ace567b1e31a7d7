package simbad.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Stream;
import simbad.cli.machine.Launcher;
import simbad.sonar.format.TemporaryFolder;
import simbad.sonar.format.WholeFile;

/**
 * A release of a commit: the commit's own files, built in a clone, so that nothing else that lies
 * in the project's folder has a part in them.
 */
final class Release {
  private static final String BUILT_JAR = "cli/target/simbad.jar";
  private static final String BUILD_LOG = "build.log";

  private final Launcher launcher;
  private final Consumer<String> say;
  private final Commit commit;
  private final long changes;

  private Release(Launcher launcher, Consumer<String> say, Commit commit, long changes) {
    this.launcher = launcher;
    this.say = say;
    this.commit = commit;
    this.changes = changes;
  }

  /**
   * Of the project's current commit.
   *
   * @param launcher that builds it
   * @param say told what is done
   * @throws IOException if the project is no git clone
   */
  static Release of(Launcher launcher, Consumer<String> say)
      throws IOException, InterruptedException {
    Commit commit = Commit.current(launcher.project());
    long changes = commit.changes();
    return new Release(launcher, say, commit, changes);
  }

  /** Returns the published figures that an older program measured. */
  List<String> staleFigures() throws IOException, InterruptedException {
    return StaleFigures.of(commit);
  }

  /**
   * Writes all files of the release into a folder.
   *
   * @param folder that is empty
   */
  void write(Path folder) throws IOException, InterruptedException {
    try (TemporaryFolder work = TemporaryFolder.create("simbad-release")) {
      Path source = clone(work);
      String name = "simbad-sonar-" + Publication.version(source);
      String time = commit.time();
      say.accept("building " + name + " of " + time);
      build(source, work, List.of("cyclonedx:makeBom", "javadoc:aggregate-no-fork"));
      ReleaseFiles files = new ReleaseFiles(source, folder);
      files.copy(BUILT_JAR, name + ".jar");
      files.copy("cli/target/bom.json", name + ".cdx.json");
      files.copy("cli/target/licences/THIRD-PARTY.txt", "THIRD-PARTY.txt");
      files.copy("CHANGELOG.md", "CHANGELOG.md");
      files.copy("LICENSE", "LICENSE");
      files.archiveJavadoc(time, name + "-javadoc.jar");
      files.archiveSources(name);
      files.sum();
    }
  }

  /**
   * Writes nothing but simbad.jar into a folder. Where no file that it is built of differs from the
   * commit it is built where the project lies, of what is compiled already.
   *
   * @param folder that is empty
   */
  void writeJar(Path folder) throws IOException, InterruptedException {
    try (TemporaryFolder work = TemporaryFolder.create("simbad-release")) {
      Path source = commit.changesOfProgram() == 0 ? launcher.project() : clone(work);
      say.accept("building simbad.jar of " + commit.time());
      build(source, work, List.of());
      new ReleaseFiles(source, folder).copy(BUILT_JAR, "simbad.jar");
    }
  }

  /**
   * Writes what a Maven repository takes, as a repository: each room's jar with sources, Javadoc
   * and a pom that says whose it is, and the list of their versions.
   *
   * @param folder that is empty
   * @param sign whether gpg signs every file
   * @throws UnpublishableException if the project does not say whose it is, or is no version
   */
  void writeRepository(Path folder, boolean sign)
      throws IOException, InterruptedException, UnpublishableException {
    try (TemporaryFolder work = TemporaryFolder.create("simbad-release")) {
      Path source = clone(work);
      Publication publication = Publication.read(source);
      if (!publication.missing().isEmpty()) {
        throw new UnpublishableException(publication.complaint());
      }
      if (publication.isSnapshot()) {
        throw new UnpublishableException(
            "pom.xml: version "
                + publication.version()
                + " is not a release, expected a version without -SNAPSHOT");
      }
      Path pom = source.resolve("pom.xml");
      String filled = publication.filled(Files.readString(pom));
      WholeFile.write(pom, filled.getBytes(StandardCharsets.UTF_8));
      say.accept("building " + publication.version() + " of " + commit.time());
      launcher.pack(
          source,
          "cli,build-config/bom",
          work.path().resolve(BUILD_LOG),
          List.of(
              "-P",
              sign ? "publish,sign" : "publish",
              "-Dproject.build.outputTimestamp=" + commit.time(),
              "-DaltDeploymentRepository=folder::" + folder.toAbsolutePath().toUri(),
              "deploy:deploy"));
    }
  }

  private Path clone(TemporaryFolder work) throws IOException, InterruptedException {
    if (changes > 0) {
      say.accept(
          "made from the commit "
              + commit.name()
              + ", without the "
              + changes
              + (changes == 1 ? " file that differs from it" : " files that differ from it"));
    }
    Path source = work.path().resolve("source");
    commit.checkOutInto(source);
    return source;
  }

  private void build(Path source, TemporaryFolder work, List<String> goals)
      throws IOException, InterruptedException {
    List<String> more =
        Stream.concat(
                Stream.of("-P", "jar", "-Dproject.build.outputTimestamp=" + commit.time()),
                goals.stream())
            .toList();
    launcher.pack(source, "cli", work.path().resolve(BUILD_LOG), more);
  }
}
