package simbad.benchmarks;

import com.sun.management.OperatingSystemMXBean;
import java.awt.Component;
import java.awt.Container;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.lang.management.ManagementFactory;
import java.util.Arrays;
import java.util.Optional;
import java.util.stream.Stream;
import javax.media.j3d.Canvas3D;
import simbad.demo.AvoidersDemo;
import simbad.gui.Simbad;

/**
 * How long the window takes to start: from the start of the virtual machine until its 3D world is
 * to be seen on the screen. Looks at the screen itself, so that nothing is believed that a user
 * would not see. Needs a display.
 */
public final class WindowStart {
  /** Sky, floor, walls and robots in their shades; a canvas in which nothing is drawn has one. */
  private static final int COLOURS_OF_A_WORLD = 20;

  /** The looking must cost little beside the starting. */
  private static final int PAUSE_MS = 50;

  /** Side of the piece in the middle of the canvas that is looked at. */
  private static final int PIECE_PX = 200;

  private WindowStart() {}

  /** Opens the window, prints when its world was seen, and ends. */
  public static void main(String[] arguments) throws Exception {
    requireExport();
    Simbad window = new Simbad(new AvoidersDemo(), false);
    double opened = sinceStartS();
    Robot eye = new Robot();
    while (!showsWorld(window, eye)) {
      Thread.sleep(PAUSE_MS);
    }
    double seen = sinceStartS();
    System.out.printf(
        "window %.2f s, world %.2f s, processor time %.2f s%n", opened, seen, processorS());
    System.exit(0);
  }

  /** Without it Java 3D finds no screen, and nothing would ever be seen. */
  private static void requireExport() {
    Module awt = Component.class.getModule();
    if (!awt.isExported("sun.awt", Canvas3D.class.getModule())) {
      System.err.println(
          "WindowStart: expected java --add-exports=java.desktop/sun.awt=ALL-UNNAMED");
      System.exit(2);
    }
  }

  private static double sinceStartS() {
    long startMs = ManagementFactory.getRuntimeMXBean().getStartTime();
    return (System.currentTimeMillis() - startMs) / 1e3;
  }

  /** Of all threads: on a busy machine it tells how much of the time was others'. */
  private static double processorS() {
    return ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class).getProcessCpuTime()
        / 1e9;
  }

  private static boolean showsWorld(Simbad window, Robot eye) {
    return findCanvas(window.getDesktopPane())
        .filter(Component::isShowing)
        .map(WindowStart::middle)
        .map(eye::createScreenCapture)
        .filter(picture -> colours(picture) >= COLOURS_OF_A_WORLD)
        .isPresent();
  }

  private static Rectangle middle(Component part) {
    Point corner = part.getLocationOnScreen();
    return new Rectangle(
        corner.x + (part.getWidth() - PIECE_PX) / 2,
        corner.y + (part.getHeight() - PIECE_PX) / 2,
        PIECE_PX,
        PIECE_PX);
  }

  private static Optional<Canvas3D> findCanvas(Container container) {
    return parts(container)
        .filter(Canvas3D.class::isInstance)
        .map(Canvas3D.class::cast)
        .findFirst();
  }

  private static Stream<Component> parts(Container container) {
    return Arrays.stream(container.getComponents())
        .flatMap(
            part ->
                part instanceof Container inner
                    ? Stream.concat(Stream.of(part), parts(inner))
                    : Stream.of(part));
  }

  private static long colours(BufferedImage picture) {
    int width = picture.getWidth();
    return Arrays.stream(picture.getRGB(0, 0, width, picture.getHeight(), null, 0, width))
        .distinct()
        .count();
  }
}
