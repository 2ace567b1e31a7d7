package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.GraphicsEnvironment;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.media.j3d.Canvas3D;
import javax.swing.AbstractButton;
import javax.swing.JDialog;
import javax.swing.JInternalFrame;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import javax.swing.plaf.basic.BasicHTML;

/** Somebody who sits before the main window, clicks and looks. */
final class Desk implements AutoCloseable {
  private static final long PATIENCE_MS = 60_000;
  private static final long BLINK_MS = 50;
  private static final Path PICTURES = Path.of("target", "screenshots");

  final Simbad window;

  Desk(Simbad window) {
    assertFalse(GraphicsEnvironment.isHeadless(), "this test needs a display");
    this.window = window;
  }

  @Override
  public void close() {
    CompletableFuture.runAsync(window::dispose, SwingUtilities::invokeLater).join();
  }

  /** Waits until something holds; says what if it never does. */
  static void await(String what, BooleanSupplier condition) throws InterruptedException {
    long end = System.nanoTime() + PATIENCE_MS * 1_000_000;
    while (!condition.getAsBoolean()) {
      assertTrue(System.nanoTime() < end, "in vain: " + what);
      Thread.sleep(BLINK_MS);
    }
  }

  static <T> T onEventThread(Callable<T> task) throws Exception {
    FutureTask<T> future = new FutureTask<>(task);
    SwingUtilities.invokeAndWait(future);
    return future.get();
  }

  /** Chooses a menu item by its text. */
  void choose(String text) throws Exception {
    JMenuItem item = onEventThread(() -> item(text));
    onEventThread(
        () -> {
          item.doClick(0);
          return true;
        });
    settle();
  }

  /** Chooses a menu item that may open a dialog; on the event thread, which the dialog holds. */
  void chooseUnawaited(String text) {
    item(text).doClick(0);
  }

  /** The dialogs that are open. */
  List<JDialog> dialogs() {
    return Arrays.stream(window.getOwnedWindows())
        .filter(JDialog.class::isInstance)
        .map(JDialog.class::cast)
        .filter(JDialog::isShowing)
        .toList();
  }

  static boolean isHtml(JLabel label) {
    return label.getClientProperty(BasicHTML.propertyKey) != null;
  }

  private JMenuItem item(String text) {
    List<JMenuItem> found =
        Arrays.stream(window.getJMenuBar().getSubElements())
            .flatMap(menu -> items((JMenu) menu.getComponent()))
            .filter(item -> item.getText().equals(text))
            .toList();
    assertEquals(1, found.size(), text);
    return found.get(0);
  }

  private static Stream<JMenuItem> items(JMenu menu) {
    return Arrays.stream(menu.getMenuComponents())
        .filter(JMenuItem.class::isInstance)
        .map(JMenuItem.class::cast)
        .flatMap(item -> item instanceof JMenu inner ? items(inner) : Stream.of(item));
  }

  /** Clicks a button of the control window by its text. */
  void click(String text) throws Exception {
    AbstractButton button =
        parts(frame(ControlWindow.class), AbstractButton.class)
            .filter(b -> text.equals(b.getText()))
            .findFirst()
            .orElseThrow(() -> new AssertionError("no button " + text));
    onEventThread(
        () -> {
          button.doClick(0);
          return true;
        });
    settle();
  }

  /** Waits until the commands so far have been carried out and the event queue is empty. */
  static void settle() throws InterruptedException, InvocationTargetException {
    FutureTask<Boolean> last = new FutureTask<>(() -> true);
    Commands.run(last);
    try {
      last.get();
    } catch (ExecutionException e) {
      throw new AssertionError(e);
    }
    SwingUtilities.invokeAndWait(() -> {});
  }

  <T extends JInternalFrame> T frame(Class<T> kind) {
    return Arrays.stream(window.getDesktopPane().getAllFrames())
        .filter(kind::isInstance)
        .map(kind::cast)
        .findFirst()
        .orElseThrow(() -> new AssertionError("no " + kind.getSimpleName()));
  }

  static <T> Stream<T> parts(Container container, Class<T> kind) {
    return Arrays.stream(container.getComponents())
        .flatMap(
            part ->
                Stream.concat(
                    kind.isInstance(part) ? Stream.of(kind.cast(part)) : Stream.empty(),
                    part instanceof Container inner ? parts(inner, kind) : Stream.empty()));
  }

  /** Returns what is to be seen of the world. */
  BufferedImage world() throws Exception {
    return picture(parts(frame(WorldWindow.class), Canvas3D.class).findFirst().orElseThrow());
  }

  private static BufferedImage picture(Component part) throws Exception {
    Point corner = part.getLocationOnScreen();
    Rectangle place = new Rectangle(corner.x, corner.y, part.getWidth(), part.getHeight());
    return new Robot().createScreenCapture(place);
  }

  /** Keeps a picture of the whole window for people to look at. */
  void photograph(String name) throws Exception {
    photograph(name, window);
  }

  void photograph(String name, Component part) throws Exception {
    Files.createDirectories(PICTURES);
    try {
      ImageIO.write(picture(part), "png", PICTURES.resolve(name + ".png").toFile());
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Share of the pixels of two pictures of one size that differ. */
  static double difference(BufferedImage a, BufferedImage b) {
    int[] pixelsA = pixels(a);
    int[] pixelsB = pixels(b);
    assertEquals(pixelsA.length, pixelsB.length);
    int differ = 0;
    for (int i = 0; i < pixelsA.length; i++) {
      differ += pixelsA[i] == pixelsB[i] ? 0 : 1;
    }
    return (double) differ / pixelsA.length;
  }

  /** Number of colours in a picture. */
  static long colours(BufferedImage picture) {
    return Arrays.stream(pixels(picture)).distinct().count();
  }

  private static int[] pixels(BufferedImage image) {
    return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
  }
}
