package simbad.cli;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;

/** The real program in a process of its own, that can be killed. */
record SimbadProcess(Process process, Path out, Path err) {
  /**
   * This Java with the classes of the tests, and what is cheapest for a short life: one collector,
   * and the first compiler alone. More words follow.
   */
  static List<String> java(String... words) {
    return Stream.concat(
            Stream.of(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:+UseSerialGC",
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path")),
            Stream.of(words))
        .toList();
  }

  /** The words that start it. */
  static List<String> command(String... arguments) {
    return Stream.concat(
            java(
                "-Dsimbad.home=" + Path.of("..").toAbsolutePath().normalize(), Main.class.getName())
                .stream(),
            Stream.of(arguments))
        .toList();
  }

  /** Starts it with lines to read, if any; what it says is added to files in a folder. */
  static SimbadProcess start(Path folder, String typed, String... arguments) throws IOException {
    return start(folder, typed, command(arguments));
  }

  /** Starts a command that ends in that of the program. */
  static SimbadProcess start(Path folder, String typed, List<String> command) throws IOException {
    Path out = folder.resolve("out.txt");
    Path err = folder.resolve("err.txt");
    Process process =
        new ProcessBuilder(command)
            .redirectOutput(ProcessBuilder.Redirect.appendTo(out.toFile()))
            .redirectError(ProcessBuilder.Redirect.appendTo(err.toFile()))
            .start();
    process.getOutputStream().write(typed.getBytes(StandardCharsets.UTF_8));
    process.getOutputStream().close();
    return new SimbadProcess(process, out, err);
  }

  /** The lines of its complaints so far. */
  List<String> complaints() throws IOException {
    return Files.readAllLines(err);
  }
}
