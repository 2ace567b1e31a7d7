package simbad.experiments.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleTypeProvider;
import simbad.sim.EnvironmentDescription;

/** Every command and all code of docs/guide/new-obstacle.md, in the page's order. */
class NewObstacleGuideTest {
  private static final Path GUIDE = Path.of("..", "docs", "guide", "new-obstacle.md");
  private static final Pattern WORD = Pattern.compile("\"([^\"]*)\"|(\\S+)");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static List<String> blocks(String kind) throws IOException {
    Matcher fences =
        Pattern.compile("```" + kind + "\\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(GUIDE));
    List<String> blocks = new ArrayList<>();
    while (fences.find()) {
      blocks.add(fences.group(1));
    }
    return blocks;
  }

  /** Words that name files of the page stand in a folder of the test's own. */
  private String[] words(String line) {
    List<String> words = new ArrayList<>();
    Matcher matcher = WORD.matcher(line);
    while (matcher.find()) {
      String word = matcher.group(1) != null ? matcher.group(1) : matcher.group(2);
      boolean isFile = word.matches("(my-|wedge-|wedge\\.|both\\.).*");
      words.add(isFile ? folder.resolve(word).toString() : word);
    }
    return words.toArray(String[]::new);
  }

  @Test
  void everyCommand_works() throws IOException {
    List<String> csv = blocks("csv");
    Files.createDirectories(folder.resolve("my-obstacles/wedge"));
    Files.writeString(folder.resolve("my-obstacles/wedge/outline.csv"), csv.get(0));
    Files.writeString(folder.resolve("my-bench.csv"), csv.get(1));
    List<String> commands =
        Files.readAllLines(GUIDE).stream()
            .filter(line -> line.startsWith("    ./simbad "))
            .map(line -> line.substring("    ./simbad ".length()))
            .toList();
    assertEquals(12, commands.size(), "commands on the page");
    List<String> withJar = commands.subList(9, 12);
    commands = commands.subList(0, 9);
    assertEquals(
        List.of("table types", "demo slab --headless", "demo MyWorld --headless"), withJar);
    System.setProperty(Catalogue.FOLDER_PROPERTY, folder.resolve("my-obstacles").toString());
    try {
      for (String command : commands) {
        Shell shell = Shell.simbad(words(command));
        assertEquals(0, shell.status(), command + ": " + shell.err());
      }
      assertTrue(Shell.simbad("table", "types").out().contains("wedge (predicted): wooden wedge"));
    } finally {
      System.clearProperty(Catalogue.FOLDER_PROPERTY);
    }
    assertTrue(Files.exists(folder.resolve("wedge-run/report.html")));
    assertTrue(Files.exists(folder.resolve("wedge-data/readings.csv")));
    assertTrue(Files.readString(folder.resolve("both.svg")).contains("<svg"));
  }

  @Test
  void code_compilesAndDoesWhatItSays() throws Exception {
    List<String> code = blocks("java");
    compile("MyObstacles", code.get(0));
    compile("MyWorld", code.get(1));
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      ObstacleTypeProvider provider =
          (ObstacleTypeProvider)
              loader.loadClass("MyObstacles").getDeclaredConstructor().newInstance();
      assertEquals("slab", provider.types().get(0).name());
      EnvironmentDescription world =
          (EnvironmentDescription)
              loader.loadClass("MyWorld").getDeclaredConstructor().newInstance();
      assertEquals("MyWorld", world.getClass().getName());
    }
  }

  /**
   * The page's own shell lines make the jar; a program with it on its class path knows the type.
   */
  @Test
  void jar_addsItsTypes() throws Exception {
    Files.writeString(folder.resolve("MyObstacles.java"), blocks("java").get(0));
    Files.writeString(folder.resolve("MyWorld.java"), blocks("java").get(1));
    String jar =
        blocks("sh")
            .get(0)
            .replace(
                "experiments/target/experiments.jar:experiments/target/lib/*",
                System.getProperty("java.class.path"));
    checkOutput("MyObstacles", "bash", "-ec", jar + "cat my-jar/META-INF/services/*");
    String classPath = System.getProperty("java.class.path") + ":my-obstacles.jar";
    String main = "simbad.experiments.cli.Main";
    checkOutput("slab (predicted): flat plate", "java", "-cp", classPath, main, "table", "types");
    checkOutput(
        "robot: at", "java", "-cp", classPath, main, "demo", "slab", "--headless", "--steps", "20");
    checkOutput("MyWorld: 2000", "java", "-cp", classPath, main, "demo", "MyWorld", "--headless");
  }

  private void checkOutput(String expected, String... command) throws Exception {
    command[0] =
        command[0].equals("java")
            ? Path.of(System.getProperty("java.home"), "bin", "java").toString()
            : command[0];
    Path said = folder.resolve("said.txt");
    Process process =
        new ProcessBuilder(command)
            .directory(folder.toFile())
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();
    assertEquals(0, process.waitFor(), Files.readString(said));
    assertTrue(Files.readString(said).contains(expected), Files.readString(said));
  }

  private void compile(String name, String text) throws IOException {
    Path source = Files.writeString(folder.resolve(name + ".java"), text);
    String[] arguments = {
      "-proc:none",
      "-cp",
      System.getProperty("java.class.path"),
      "-d",
      folder.toString(),
      source.toString()
    };
    java.io.ByteArrayOutputStream errors = new java.io.ByteArrayOutputStream();
    int status = ToolProvider.getSystemJavaCompiler().run(null, null, errors, arguments);
    assertEquals(0, status, errors + Arrays.toString(arguments));
  }
}
