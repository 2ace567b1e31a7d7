package simbad.experiments.export;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;

/** Runs compilers and what they made. */
final class Compilers {
  private Compilers() {}

  /** Skips a test whose tool is not there; it counts as failed where all tools should be. */
  static void need(String tool) {
    Stream<Path> path =
        Arrays.stream(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1))
            .map(Path::of);
    assumeTrue(
        path.anyMatch(folder -> Files.isExecutable(folder.resolve(tool))),
        tool + " is not installed");
  }

  /** Runs a command in a folder that must succeed; returns what it prints. */
  static String run(Path folder, String input, String... command)
      throws IOException, InterruptedException {
    Path in = folder.resolve("stdin");
    Files.writeString(in, input);
    Process process =
        new ProcessBuilder(List.of(command))
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectInput(in.toFile())
            .start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), String.join(" ", command) + "\n" + output);
    return output;
  }
}
