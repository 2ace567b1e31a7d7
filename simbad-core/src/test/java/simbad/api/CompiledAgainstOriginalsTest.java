package simbad.api;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.File;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.vecmath.Point3d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.gui.Simbatch;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.LightSensor;
import simbad.sim.SimpleAgent;
import simbad.user.OldPrograms;

/**
 * Class files that were made with another jar than this project's run on this project's classes: a
 * member of other types would not be found then, even where the source compiles.
 */
class CompiledAgainstOriginalsTest {
  private static final Path SIGNATURES = Path.of("src", "test", "resources", "api");

  /** What the jar called 1.7 has and the released 1.4 has not. */
  private static final List<String> ONLY_1_7 =
      List.of(
          "LightSensor has public double getLux()",
          "LightSensor has public Point3d getPosition()",
          "LightSensor has public Vector3d position",
          "LightSensor has public static Point3d getGlobalCoords(Agent, Vector3d)",
          "World has public Light getLight1()",
          "World has public Light getLight2()",
          "RobotFactory has public static RangeSensorBelt addSonarBeltSensor(Agent, int, float)");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private List<String> signatures() throws IOException {
    return Files.readAllLines(SIGNATURES.resolve("signatures.txt"));
  }

  private List<String> without(List<String> lines, List<String> ends) {
    return lines.stream().filter(line -> ends.stream().noneMatch(line::endsWith)).toList();
  }

  private Path stubs(List<String> signatures) throws IOException {
    Path classes = Files.createDirectory(folder.resolve("stubs"));
    Stubs.compile(signatures, folder.resolve("stub-sources"), classes);
    return classes;
  }

  /** Compiles programs against stubs; returns the compiler's complaints. */
  private String compilePrograms(Path stubs, List<String> names) throws IOException {
    Path classes = Files.createDirectories(folder.resolve("programs"));
    List<Path> sources = names.stream().map(n -> OldPrograms.SOURCES.resolve(n + ".java")).toList();
    return Stubs.compile(sources, stubs + File.pathSeparator + Stubs.libraries(), classes);
  }

  private static List<Point3d> places(ClassLoader loader, String name)
      throws ReflectiveOperationException {
    Object made = loader.loadClass("oldprograms." + name).getDeclaredConstructor().newInstance();
    Simbatch simulation = new Simbatch((EnvironmentDescription) made, false);
    simulation.reset();
    List<Point3d> places = new ArrayList<>();
    for (int i = 0; i < 200; i++) {
      simulation.step();
      for (Object agent : simulation.getSimulator().getAgentList()) {
        Point3d at = new Point3d();
        ((SimpleAgent) agent).getCoords(at);
        places.add(at);
      }
    }
    simulation.dispose();
    return places;
  }

  private void checkRuns(List<String> signatures, List<String> programs)
      throws IOException, ReflectiveOperationException {
    assertEquals("", compilePrograms(stubs(signatures), programs));
    ClassLoader linked = loader(folder.resolve("programs"));
    ClassLoader own = OldPrograms.compile(Files.createDirectory(folder.resolve("own")));
    for (String program : programs) {
      assertEquals(places(own, program), places(linked, program), program);
    }
  }

  private static ClassLoader loader(Path classes) throws IOException {
    URL[] urls = {classes.toUri().toURL()};
    return new URLClassLoader(urls, Agent.class.getClassLoader());
  }

  private static List<String> programs(String... without) throws IOException {
    return OldPrograms.names().stream()
        .filter(name -> Stream.of(without).noneMatch(name::equals))
        .toList();
  }

  @Test
  void compiledAgainst14_runAsCompiledHere() throws IOException, ReflectiveOperationException {
    checkRuns(without(signatures(), ONLY_1_7), programs("LuxClimber", "BoundaryFollower"));
  }

  @Test
  void compiledAgainst17_runAsCompiledHere() throws IOException, ReflectiveOperationException {
    checkRuns(signatures(), programs());
  }

  @Test
  void stubsOf14_lackWhat17Added() throws IOException {
    List<String> of14 = without(signatures(), ONLY_1_7);
    assertEquals(signatures().size() - ONLY_1_7.size(), of14.size(), "a line that is in no list");
    String messages = compilePrograms(stubs(of14), List.of("LuxClimber"));
    assertTrue(messages.contains("getLux"), messages);
  }

  /** The stubs are what the programs are compiled against, or the tests above could not fail. */
  @Test
  void memberOfAnotherType_isNoticed() throws IOException, ReflectiveOperationException {
    List<String> other =
        signatures().stream()
            .map(l -> l.replace("has public double getLux()", "has public float getLux()"))
            .collect(Collectors.toList());
    assertNotEquals(signatures(), other);
    assertEquals("", compilePrograms(stubs(other), List.of("LuxClimber")));
    ClassLoader linked = loader(folder.resolve("programs"));
    assertEquals(double.class, LightSensor.class.getMethod("getLux").getReturnType());
    Throwable thrown = assertThrows(NoSuchMethodError.class, () -> places(linked, "LuxClimber"));
    assertTrue(String.valueOf(thrown.getMessage()).contains("getLux"));
  }
}
