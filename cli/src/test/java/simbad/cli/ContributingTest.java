package simbad.cli;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.obstacles.Catalogue;
import simbad.obstacles.ObstacleType;
import simbad.sonar.frame.Placement;
import simbad.sonar.model.SensorModel;
import simbad.sonar.ping.RangeChange;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.TransducerPoses;

/** The page for contributors: its code compiles and does what the page says. */
class ContributingTest {
  private static final Path PAGE = Path.of("..", "CONTRIBUTING.md");

  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  private static List<String> blocks() throws IOException {
    return Pattern.compile("```java\\n(.*?)```", Pattern.DOTALL)
        .matcher(Files.readString(PAGE))
        .results()
        .map((MatchResult fence) -> fence.group(1))
        .toList();
  }

  private void compile(String name, String code) throws IOException {
    Path source = Files.writeString(folder.resolve(name + ".java"), code);
    ByteArrayOutputStream errors = new ByteArrayOutputStream();
    int status =
        ToolProvider.getSystemJavaCompiler()
            .run(
                null,
                null,
                errors,
                "-proc:none",
                "-d",
                folder.toString(),
                "-cp",
                System.getProperty("java.class.path"),
                source.toString());
    assertEquals(0, status, errors.toString(UTF_8));
  }

  private Object made(String name, Object... arguments) throws Exception {
    try (URLClassLoader loader =
        new URLClassLoader(new URL[] {folder.toUri().toURL()}, getClass().getClassLoader())) {
      return loader.loadClass(name).getDeclaredConstructors()[0].newInstance(arguments);
    }
  }

  @Test
  void page_hasThreePiecesOfCode() throws IOException {
    assertEquals(3, blocks().size());
  }

  private static boolean hears(SensorModel model, double distanceM) {
    ObstacleType round = Catalogue.find("round").orElseThrow();
    Obstacle post =
        new Obstacle(
            "post", new Placement(distanceM, 0, 0), round.outline(), new UniformDetection(3));
    TransducerPoses poses = new TransducerPoses(1);
    poses.setDirection(0, 1, 0, 0);
    Readings readings = new Readings(1);
    model
        .bind(Catalogue.srf04(), new Scene(List.of(post)), new SplittableRandom(1))
        .ping(poses, 0, readings);
    return readings.isEcho(0);
  }

  @Test
  void sensorModel_hearsNothingBeyondAMetre() throws Exception {
    compile("ShortSighted", blocks().get(0));
    SensorModel model = (SensorModel) made("ShortSighted");
    assertTrue(hears(model, 0.9));
    assertFalse(hears(model, 1.1));
  }

  @Test
  void effect_isUndoneByItsInverse_andNeutralAtNought() throws Exception {
    compile("Sag", blocks().get(1));
    RangeChange sag = (RangeChange) made("Sag", 0.01);
    assertEquals(1.96, sag.meanM(2), 1e-12);
    assertEquals(2, sag.rangeM(sag.meanM(2)), 1e-12);
    assertEquals(2, ((RangeChange) made("Sag", 0.0)).rangeM(2), 0);
  }

  /** A class of this package that another loader loads is no part of it: compiling is all here. */
  @Test
  void command_compiles() throws Exception {
    compile("EchoTimeCommand", blocks().get(2));
    assertTrue(Files.exists(folder.resolve("simbad/cli/EchoTimeCommand.class")));
  }
}
