package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Objects;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;
import simbad.user.OldPrograms;

/** The old programs' own {@code main} opens the window, in which they run and are to be seen. */
@Tag("display")
class OldProgramsWindowTest {
  private static ClassLoader loader;

  @BeforeAll
  static void compile(@TempDir Path classes) throws IOException {
    loader = OldPrograms.compile(classes);
  }

  @TestFactory
  Stream<DynamicTest> main_opensTheWindow_inWhichTheProgramRuns() throws IOException {
    return OldPrograms.names().stream()
        .filter(name -> !name.equals("Blinkers")) // It is a batch.
        .map(name -> DynamicTest.dynamicTest(name, () -> check(name)));
  }

  private static void check(String name) throws Exception {
    Class<?> program = loader.loadClass("oldprograms." + name);
    program.getMethod("main", String[].class).invoke(null, (Object) new String[0]);
    try (Desk desk = new Desk(Objects.requireNonNull(Simbad.getSimbadInstance()))) {
      assertTrue(desk.window.getTitle().endsWith(name), desk.window.getTitle());
      Desk.await("the world is drawn", () -> Desk.colours(picture(desk)) > 10);
      BufferedImage before = picture(desk);
      desk.click("run");
      Desk.await("something moves", () -> Desk.difference(before, picture(desk)) > 0);
      desk.click("pause");
      assertEquals(Simbad.getSimbadInstance(), desk.window);
    }
  }

  private static BufferedImage picture(Desk desk) {
    try {
      return desk.world();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }
}
