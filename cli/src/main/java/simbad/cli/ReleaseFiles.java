package simbad.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.spi.ToolProvider;
import java.util.stream.Stream;
import simbad.sonar.format.Sha256;
import simbad.sonar.format.WholeFile;

/**
 * The files of a release, made of a built clone.
 *
 * @param source the clone
 * @param folder that they go to
 */
record ReleaseFiles(Path source, Path folder) {
  void copy(String from, String name) throws IOException {
    WholeFile.write(folder.resolve(name), Files.readAllBytes(source.resolve(from)));
  }

  /** Puts the Javadoc into a jar, in the order of the names and with one time. */
  void archiveJavadoc(String time, String name) throws IOException {
    Path pages = source.resolve("target").resolve("reports").resolve("apidocs");
    List<String> words =
        new ArrayList<>(
            List.of(
                "--create", "--no-manifest", "--date=" + time, "--file=" + folder.resolve(name)));
    for (String page : files(pages)) {
      words.addAll(List.of("-C", pages.toString(), page));
    }
    StringWriter said = new StringWriter();
    PrintWriter both = new PrintWriter(said);
    int status =
        ToolProvider.findFirst("jar")
            .orElseThrow(() -> new IOException("this Java has no jar program: a JDK is needed"))
            .run(both, both, words.toArray(String[]::new));
    if (status != 0) {
      throw new IOException(name + " cannot be made: " + said.toString().strip());
    }
  }

  /** The commit's files, as git has them. */
  void archiveSources(String name) throws IOException, InterruptedException {
    Path archive = folder.resolve(name + "-sources.tar.gz");
    List<String> git =
        List.of("git", "-C", source.toString(), "archive", "--prefix=" + name + "/", "HEAD");
    List<Process> pipeline =
        ProcessBuilder.startPipeline(
            List.of(
                new ProcessBuilder(git).redirectError(Redirect.INHERIT),
                new ProcessBuilder("gzip", "-n", "-9")
                    .redirectError(Redirect.INHERIT)
                    .redirectOutput(archive.toFile())));
    for (Process part : pipeline) {
      if (part.waitFor() != 0) {
        throw new IOException(archive + " cannot be made");
      }
    }
  }

  /** Writes the checksums of all, as sha256sum does. */
  void sum() throws IOException {
    StringBuilder sums = new StringBuilder();
    for (String name : files(folder)) {
      sums.append(Sha256.hex(Files.readAllBytes(folder.resolve(name))))
          .append("  ")
          .append(name)
          .append('\n');
    }
    WholeFile.write(folder.resolve("SHA256SUMS"), sums.toString().getBytes(StandardCharsets.UTF_8));
  }

  /** The names of the files below a folder, in order. */
  private static List<String> files(Path below) throws IOException {
    try (Stream<Path> all = Files.walk(below)) {
      return all.filter(Files::isRegularFile)
          .map(file -> below.relativize(file).toString())
          .sorted()
          .toList();
    }
  }
}
