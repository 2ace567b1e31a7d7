package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** No key and no token lies in the project's files, by git-secrets with the project's patterns. */
class SecretsTest {
  private static final Path PROJECT = Path.of("..");

  @BeforeEach
  void needsTheToolAndAClone() {
    Stream<Path> path =
        Stream.of(System.getenv().getOrDefault("PATH", "").split(File.pathSeparator, -1))
            .map(Path::of);
    assumeTrue(
        path.anyMatch(folder -> Files.isExecutable(folder.resolve("git-secrets"))),
        "git-secrets is not installed");
    assumeTrue(Files.exists(PROJECT.resolve(".git")), "these sources are no git clone");
  }

  /** The exit status, with what it printed. */
  private static String scan(String input, String... arguments)
      throws IOException, InterruptedException {
    Stream<String> command =
        Stream.of(
            "git",
            "-c",
            "secrets.providers=grep -v ^# build-config/secret-patterns.txt",
            "secrets");
    Process scan =
        new ProcessBuilder(Stream.concat(command, Stream.of(arguments)).toList())
            .directory(PROJECT.toFile())
            .redirectErrorStream(true)
            .start();
    scan.getOutputStream().write(input.getBytes(StandardCharsets.UTF_8));
    scan.getOutputStream().close();
    String output = new String(scan.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return scan.waitFor() + " " + output;
  }

  @Test
  void files_holdNone() throws Exception {
    assertEquals("0 ", scan("", "--scan"));
  }

  @Tag("full")
  @Test
  void history_holdsNone() throws Exception {
    assertEquals("0 ", scan("", "--scan-history"));
  }

  /** In two parts, so that this file is not found. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "id = AKIA IOSFODNN7EXAMPLE",
        "-----BEGIN RSA PRIVATE KE Y-----",
        "token: ghp_ 0123456789abcdefghij0123456789abcdef",
        "glpat- 0123456789abcdefghij",
        "https://me: secret@example.org/"
      })
  void secret_isFound(String parts) throws Exception {
    String secret = parts.replaceFirst(" (?=[^ ]*$)", "");
    String found = scan(secret + "\n", "--scan", "-");
    assertTrue(found.startsWith("1 "), found);
  }

  @Test
  void plainText_isNone() throws Exception {
    assertEquals("0 ", scan("https://example.org:80/a@b\n", "--scan", "-"));
  }
}
