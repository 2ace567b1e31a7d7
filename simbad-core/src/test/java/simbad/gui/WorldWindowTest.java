package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Predicate;
import javax.imageio.ImageIO;
import javax.swing.JLabel;
import javax.swing.SwingUtilities;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import simbad.sim.Agent;
import simbad.sim.EnvironmentDescription;
import simbad.sim.RobotFactory;
import simbad.sim.World;

/** What the window shows of a world besides its objects, on a display. */
@Tag("display")
class WorldWindowTest {
  private static final class Rover extends Agent {
    Rover() {
      super(new Vector3d(-3, 0, 1), "rover");
      RobotFactory.addSonarBeltSensor(this, 12);
    }

    @Override
    protected void performBehavior() {
      setTranslationalVelocity(1);
    }
  }

  private static EnvironmentDescription field() {
    EnvironmentDescription field = new EnvironmentDescription();
    field.setWorldSize(10);
    field.add(new Rover());
    return field;
  }

  private static Desk open(EnvironmentDescription environment) throws Exception {
    Desk desk = new Desk(new Simbad(environment, false));
    Desk.await("the world is drawn", () -> colours(desk) > 10);
    return desk;
  }

  private static long colours(Desk desk) {
    return Desk.colours(world(desk));
  }

  private static BufferedImage world(Desk desk) {
    try {
      return desk.world();
    } catch (Exception e) {
      throw new AssertionError(e);
    }
  }

  /** The theme is that of the whole program: what a test leaves, the next one would meet. */
  @AfterEach
  void makeLight() throws Exception {
    SwingUtilities.invokeAndWait(() -> Theme.set(false));
  }

  private static void drive(Desk desk, int steps) throws Exception {
    for (int i = 0; i < steps; i++) {
      desk.click("step");
    }
  }

  /** Pixels of the trail's blue; its edges are smoothed, and other blues are as dark as can be. */
  private static long blue(Desk desk) {
    BufferedImage picture = world(desk);
    return count(picture, c -> c.getBlue() > 150 && c.getRed() < 110 && c.getGreen() < 110);
  }

  /** Pixels of the plate under a name, dark grey as hardly anything else. */
  private static long plate(Desk desk) {
    return count(
        world(desk),
        c ->
            Math.abs(c.getRed() - 60) < 15
                && Math.abs(c.getRed() - c.getGreen()) < 8
                && Math.abs(c.getGreen() - c.getBlue()) < 12);
  }

  private static long count(BufferedImage picture, Predicate<Color> kind) {
    long found = 0;
    for (int y = 0; y < picture.getHeight(); y++) {
      for (int x = 0; x < picture.getWidth(); x++) {
        found += kind.test(new Color(picture.getRGB(x, y))) ? 1 : 0;
      }
    }
    return found;
  }

  @Test
  void trail_grows_canBeLeftOut_andIsGoneAfterAReset() throws Exception {
    EnvironmentDescription field = field();
    field.showAxis(false);
    try (Desk desk = open(field)) {
      desk.choose("top");
      Desk.await("no trail yet", () -> blue(desk) == 0);
      drive(desk, 40);
      Desk.await("a trail of 2 m", () -> blue(desk) > 150);
      desk.photograph("trail");
      desk.choose("trails");
      Desk.await("it is left out", () -> blue(desk) == 0);
      desk.choose("trails");
      Desk.await("it is back", () -> blue(desk) > 150);
      desk.click("reset");
      Desk.await("it is cleared", () -> blue(desk) == 0);
    }
  }

  @Test
  void names_canBeLeftOut() throws Exception {
    try (Desk desk = open(field())) {
      desk.choose("top");
      Desk.await("a name", () -> plate(desk) > 200);
      desk.choose("names");
      Desk.await("no name", () -> plate(desk) < 100);
    }
  }

  @Test
  void legend_saysWhatIsThere_andCanBeHidden() throws Exception {
    try (Desk desk = open(field())) {
      Legend legend =
          Desk.parts(desk.frame(WorldWindow.class), Legend.class).findFirst().orElseThrow();
      List<String> texts =
          Desk.onEventThread(() -> Desk.parts(legend, JLabel.class).map(JLabel::getText).toList());
      assertEquals(
          List.of(
              "robot, red nose ahead",
              "sensor without echo",
              "echo, as long as its range",
              "where it has been",
              "axes: x red, y green, z blue"),
          texts);
      int heightWith = desk.world().getHeight();
      assertTrue(legend.isShowing());
      desk.choose("legend");
      assertFalse(legend.isShowing());
      Desk.await("the world takes its place", () -> world(desk).getHeight() > heightWith);
    }
  }

  @Test
  void emptyWorld_hasNoLegend() throws Exception {
    try (Desk desk = new Desk(new Simbad(new EnvironmentDescription(), false))) {
      Desk.settle();
      assertFalse(
          Desk.parts(desk.frame(WorldWindow.class), Legend.class).anyMatch(Legend::isShowing));
    }
  }

  @Test
  void darkTheme_isDarkBehindTheFloorToo_butOwnColoursStay() throws Exception {
    EnvironmentDescription own = field();
    own.backgroundColor = new Color3f(1, 1, 0);
    try (Desk desk = open(field())) {
      desk.choose("top");
      Desk.await("a light corner", () -> corner(desk).getRed() > 150);
      desk.choose("Dark theme");
      Desk.await("a dark corner", () -> corner(desk).getRed() < 60);
      Desk.await("a dark floor", () -> floor(desk) < 110);
      desk.photograph("dark world");
      World before = desk.window.getWorld();
      desk.window.open(own);
      Desk.await("the other world", () -> desk.window.getWorld() != before);
      Desk.settle();
      Desk.await("the own colour", () -> corner(desk).equals(new Color(255, 255, 0)));
    }
  }

  private static Color corner(Desk desk) {
    return new Color(world(desk).getRGB(2, 2));
  }

  /** The green of the floor a little beside the middle: no line of the grid goes there. */
  private static int floor(Desk desk) {
    BufferedImage picture = world(desk);
    int x = picture.getWidth() / 2 + picture.getWidth() / 25;
    int y = picture.getHeight() / 2 - picture.getHeight() / 25;
    return new Color(picture.getRGB(x, y)).getGreen();
  }

  @Test
  void picture_isWritten_andSaid(@TempDir Path folder) throws Exception {
    try (Desk desk = open(field())) {
      WorldWindow window = desk.frame(WorldWindow.class);
      window.setFolder(folder);
      desk.choose("save picture");
      Desk.await("it is said", () -> window.news().contains("simbad-world-001.png is written"));
      assertTrue(window.news().contains(folder.toString()));
      BufferedImage picture = ImageIO.read(folder.resolve("simbad-world-001.png").toFile());
      BufferedImage seen = desk.world();
      assertEquals(seen.getWidth(), picture.getWidth());
      assertTrue(picture.getHeight() > seen.getHeight(), "the legend is below");
      BufferedImage world = picture.getSubimage(0, 0, seen.getWidth(), seen.getHeight());
      assertTrue(unlike(seen, world) < 0.01, "it is what is seen: " + unlike(seen, world));
      desk.choose("save picture");
      Desk.await("the next name", () -> Files.exists(folder.resolve("simbad-world-002.png")));
    }
  }

  /** Share of the pixels that differ by more than the smoothing of lines. */
  private static double unlike(BufferedImage a, BufferedImage b) {
    int differ = 0;
    for (int i = 0; i < a.getWidth() * a.getHeight(); i++) {
      Color p = new Color(a.getRGB(i % a.getWidth(), i / a.getWidth()));
      Color q = new Color(b.getRGB(i % a.getWidth(), i / a.getWidth()));
      differ += Math.abs(p.getGreen() - q.getGreen()) > 48 ? 1 : 0;
    }
    return (double) differ / (a.getWidth() * a.getHeight());
  }

  @Test
  void pictureThatCannotBeWritten_isSaid(@TempDir Path folder) throws Exception {
    try (Desk desk = open(field())) {
      WorldWindow window = desk.frame(WorldWindow.class);
      window.setFolder(folder.resolve("nowhere"));
      desk.choose("save picture");
      Desk.await("it is said", () -> window.news().startsWith("no picture was written: "));
      assertEmpty(folder);
    }
  }

  private static void assertEmpty(Path folder) throws IOException {
    try (var files = Files.list(folder)) {
      assertEquals(0, files.count());
    }
  }
}
