package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.DynamicTest.dynamicTest;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import simbad.demo.DemoManager;

/**
 * simbad.jar without a display, on the Java that runs the tests and on Java 25 where one is found:
 * in the property {@code simbad.jdk25}, in the variable {@code JAVA25_HOME}, or beside this Java.
 */
@Tag("jar")
class JarTest {
  private static final Path JAR = Path.of(System.getProperty("simbad.jar", "target/simbad.jar"));

  private static final String OLD_PROGRAM =
      """
      import javax.vecmath.*;
      import simbad.gui.*;
      import simbad.sim.*;

      public class Old extends EnvironmentDescription {
        class Walker extends Agent {
          Walker() { super(new Vector3d(0, 0, 0), "walker"); }
          public void performBehavior() { setTranslationalVelocity(0.5); }
        }

        public static void main(String[] args) {
          Old world = new Old();
          Walker walker = world.new Walker();
          world.add(walker);
          Wall wall = new Wall(new Vector3d(9, 0, 0), 19, 1, world);
          wall.rotate90(1);
          world.add(wall);
          Simbatch batch = new Simbatch(world, false);
          batch.reset();
          for (int i = 0; i < 100; i++) batch.step();
          Point3d at = new Point3d();
          walker.getCoords(at);
          System.out.println("x " + Math.round(at.x * 100) / 100.0);
          System.exit(0);
        }
      }
      """;

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  /** A Java and what it is called. */
  private record Java(String name, Path home) {
    Path program(String program) {
      return home.resolve("bin").resolve(program);
    }
  }

  private static List<Java> found() {
    Path own = Path.of(System.getProperty("java.home"));
    List<Java> found = new ArrayList<>(List.of(new Java("this Java", own)));
    java25(own).ifPresent(home -> found.add(new Java("Java 25", home)));
    return found;
  }

  private static Optional<Path> java25(Path own) {
    Stream<String> named =
        Stream.of(
            System.getProperty("simbad.jdk25", ""),
            System.getenv().getOrDefault("JAVA25_HOME", ""));
    Path parent = own.toAbsolutePath().getParent();
    File[] beside = parent == null ? null : parent.toFile().listFiles();
    Stream<Path> others =
        Stream.of(Objects.requireNonNullElse(beside, new File[0])).map(File::toPath).sorted();
    return Stream.concat(named.filter(name -> !name.isEmpty()).map(Path::of), others)
        .filter(JarTest::isJava25)
        .findFirst();
  }

  private static boolean isJava25(Path home) {
    try {
      return Files.exists(home.resolve("bin/javac"))
          && Files.readString(home.resolve("release")).contains("JAVA_VERSION=\"25");
    } catch (IOException noRelease) {
      return false;
    }
  }

  @TestFactory
  Stream<DynamicTest> smoke() {
    return found().stream()
        .flatMap(
            java ->
                Stream.of(
                    dynamicTest(java.name() + ": a demo", () -> checkDemo(java)),
                    dynamicTest(
                        java.name() + ": all demos, as in this process", () -> checkDemos(java)),
                    dynamicTest(java.name() + ": no command, no display", () -> checkWindow(java)),
                    dynamicTest(java.name() + ": a table from inside", () -> checkTable(java)),
                    dynamicTest(java.name() + ": an old program", () -> checkOldProgram(java))));
  }

  private Shell run(Path directory, String... command) throws IOException, InterruptedException {
    ProcessBuilder builder = new ProcessBuilder(command).directory(directory.toFile());
    builder.environment().remove("DISPLAY");
    Path err = folder.resolve("err");
    Process process = builder.redirectError(err.toFile()).start();
    process.getOutputStream().close();
    String out = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return new Shell(process.waitFor(), out, Files.readString(err));
  }

  private Shell jar(Java java, String... arguments) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>();
    command.addAll(
        List.of(java.program("java").toString(), "-jar", JAR.toAbsolutePath().toString()));
    command.addAll(List.of(arguments));
    return run(folder, command.toArray(String[]::new));
  }

  /** A run's numbers, and its pictures to the pixel: strokes, dashes, text, a map in colours. */
  @Test
  void everyJava_writesTheSameBytes() throws IOException, InterruptedException {
    List<Map<String, String>> written = new ArrayList<>();
    for (Java java : found()) {
      Path out = folder.resolve("run " + java.name());
      Shell shell = jar(java, "run", "angle", "--out", out.toString());
      assertEquals(0, shell.status(), shell.err());
      written.add(digests(out));
    }
    assertTrue(written.get(0).containsKey("angle/polar.png"));
    for (Map<String, String> other : written) {
      assertEquals(written.get(0), other);
    }
  }

  /** All files by name but the log, which has times in it. */
  private static Map<String, String> digests(Path folder) throws IOException {
    Map<String, String> digests = new TreeMap<>();
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        String name = folder.relativize(file).toString();
        if (!name.equals("run.log")) {
          digests.put(name, digest(file));
        }
      }
    }
    return digests;
  }

  private static String digest(Path file) throws IOException {
    try {
      byte[] bytes = MessageDigest.getInstance("SHA-256").digest(Files.readAllBytes(file));
      return HexFormat.of().formatHex(bytes);
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException(e);
    }
  }

  private void checkDemo(Java java) throws IOException, InterruptedException {
    Shell shell = jar(java, "demo", "SimplestDemo", "--headless", "--steps", "100");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("SimplestDemo: 100 steps"), shell.out());
    assertEquals("", shell.err());
  }

  private void checkDemos(Java java) throws IOException, InterruptedException {
    assertEquals(String.join("\n", DemoManager.names()), jar(java, "demo", "--list").out().strip());
    for (String name : DemoManager.names()) {
      String[] arguments = {"demo", name, "--headless", "--steps", "300"};
      assertEquals(places(Shell.simbad(arguments)), places(jar(java, arguments)), name);
    }
  }

  /** Without the first line, which has the speed. */
  private static List<String> places(Shell shell) {
    return shell.out().lines().skip(1).toList();
  }

  private void checkWindow(Java java) throws IOException, InterruptedException {
    Shell shell = jar(java);
    assertEquals(1, shell.status());
    assertTrue(shell.err().startsWith("simbad view: there is no display"), shell.err());
  }

  private void checkTable(Java java) throws IOException, InterruptedException {
    Shell shell = jar(java, "table", "show", "angle");
    assertEquals(0, shell.status(), shell.err());
    assertTrue(shell.out().startsWith("angle (measured)\n"), shell.out());
  }

  private void checkOldProgram(Java java) throws IOException, InterruptedException {
    Files.writeString(folder.resolve("Old.java"), OLD_PROGRAM);
    String jar = JAR.toAbsolutePath().toString();
    String javac = java.program("javac").toString();
    Shell compiled = run(folder, javac, "-nowarn", "-cp", jar, "Old.java");
    assertEquals(0, compiled.status(), compiled.err());
    String classPath = jar + File.pathSeparator + ".";
    Shell shell = run(folder, java.program("java").toString(), "-cp", classPath, "Old");
    // Java 3D says its version on standard error.
    assertEquals("0 x 2.5", shell.status() + " " + shell.out().strip(), shell.err());
  }
}
