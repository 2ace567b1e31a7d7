package simbad.gui;

import java.awt.BorderLayout;
import java.awt.Component;
import java.awt.Graphics2D;
import java.awt.event.ActionEvent;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JInternalFrame;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.SwingConstants;
import javax.swing.SwingUtilities;
import org.jspecify.annotations.Nullable;
import simbad.scene3d.DisplayException;
import simbad.scene3d.Layer;
import simbad.sim.World;

/**
 * Shows the world in 3D, and below it what its colours mean; where there can be no 3D, why. Takes
 * pictures of it.
 */
public final class WorldWindow extends JInternalFrame {
  /** Side at first, as in the original. */
  private static final int SIDE_PX = 400;

  /** Where the program was started. */
  private static final Path HERE = Path.of("").toAbsolutePath();

  private final transient @Nullable World world;
  private final Legend legend;
  private final WorldStrip strip;
  private final transient Choice picture =
      new Choice("save picture", "Save a picture of the world as PNG", "control S", this::save);
  private final transient Choice legendShown =
      new Choice("legend", "What the colours mean", "control L", this::showLegend);
  private final transient List<Choice> layers =
      List.of(
          layer("trails", Layer.TRAILS, "Where agents have been", "control T"),
          layer("names", Layer.NAMES, "The robots' names", "control N"),
          layer("shadow edges", Layer.EDGES, "How far obstacles are heard", "control E"));
  private transient Path folder = HERE;

  /** Creates a window of a world. */
  public WorldWindow(World world) {
    super("world", true, false, true, true);
    this.world = world;
    setLayout(new BorderLayout());
    add(view(world));
    legend = new Legend(world.signs());
    strip = new WorldStrip(legend, picture.button());
    add(strip, BorderLayout.PAGE_END);
    legendShown.setSelected(!legend.isEmpty());
    takeTheme();
    setSize(SIDE_PX, SIDE_PX);
    setVisible(true);
  }

  private Component view(World shown) {
    try {
      Component canvas = shown.getCanvas3D();
      shown.whenDrawingFails(why -> SwingUtilities.invokeLater(() -> explain(canvas, why)));
      return canvas;
    } catch (DisplayException e) {
      picture.setEnabled(false);
      return explanation(e.getMessage());
    }
  }

  private void explain(Component canvas, String why) {
    getContentPane().remove(canvas);
    picture.setEnabled(false);
    add(explanation(why));
    validate();
  }

  private static JLabel explanation(String why) {
    JLabel label = new JLabel("<html><center>" + escape(why) + "</center></html>");
    label.setHorizontalAlignment(SwingConstants.CENTER);
    return label;
  }

  private static String escape(String text) {
    return text.replace("&", "&amp;").replace("<", "&lt;");
  }

  private Choice layer(String name, Layer layer, String toolTip, String keys) {
    Choice choice = new Choice(name, toolTip, keys, event -> draw(layer, event));
    choice.setSelected(true);
    return choice;
  }

  /** The world is as dark as the windows are. */
  @Override
  public void updateUI() {
    super.updateUI();
    takeTheme();
  }

  /** Also called by the constructor of the frame, before there is a world. */
  private void takeTheme() {
    if (world != null) {
      world.setLook(world.getLook().withDark(Theme.isDark()));
    }
  }

  /** Returns a menu of what is drawn besides the world itself. */
  JMenu createMenu() {
    JMenu menu = new JMenu("Show");
    menu.setMnemonic('O');
    menu.add(new JCheckBoxMenuItem(legendShown));
    layers.forEach(layer -> menu.add(new JCheckBoxMenuItem(layer)));
    menu.addSeparator();
    menu.add(picture);
    return menu;
  }

  private void draw(Layer layer, ActionEvent event) {
    if (world != null) {
      world.setLook(world.getLook().with(layer, isChosen(event)));
    }
  }

  private void showLegend(ActionEvent event) {
    legend.setVisible(isChosen(event));
    validate();
  }

  private static boolean isChosen(ActionEvent event) {
    return ((JCheckBoxMenuItem) event.getSource()).isSelected();
  }

  /** Says where pictures go to from now on. */
  void setFolder(Path newFolder) {
    folder = newFolder;
  }

  /** Returns what was said at last about a picture. */
  String news() {
    return strip.news();
  }

  /** Takes a picture and writes it; neither the event thread nor a step waits for it. */
  private void save(ActionEvent event) {
    World shown = world;
    if (shown != null) {
      Path into = folder;
      Optional<BufferedImage> below = legendPicture();
      Commands.run(() -> save(shown, below, into));
    }
  }

  private void save(World shown, Optional<BufferedImage> below, Path into) {
    String outcome;
    try {
      BufferedImage taken = shown.photograph();
      Path file = PictureFile.write(into, below.map(part -> stacked(taken, part)).orElse(taken));
      outcome = file.getFileName() + " is written, in " + into;
    } catch (IOException e) {
      outcome = PictureFile.why(e);
    } catch (DisplayException e) {
      outcome = "no picture was taken: " + e.getMessage();
    }
    String said = outcome;
    SwingUtilities.invokeLater(() -> strip.say(said));
  }

  /** Returns the legend as it is shown, if it is. */
  private Optional<BufferedImage> legendPicture() {
    if (!legend.isVisible() || legend.getHeight() == 0) {
      return Optional.empty();
    }
    BufferedImage image =
        new BufferedImage(legend.getWidth(), legend.getHeight(), BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = image.createGraphics();
    legend.printAll(graphics);
    graphics.dispose();
    return Optional.of(image);
  }

  private static BufferedImage stacked(BufferedImage above, BufferedImage below) {
    BufferedImage both =
        new BufferedImage(
            Math.max(above.getWidth(), below.getWidth()),
            above.getHeight() + below.getHeight(),
            BufferedImage.TYPE_INT_RGB);
    Graphics2D graphics = both.createGraphics();
    graphics.drawImage(above, 0, 0, null);
    graphics.drawImage(below, 0, above.getHeight(), null);
    graphics.dispose();
    return both;
  }

  @Override
  public void dispose() {
    Stream.concat(layers.stream(), Stream.of(legendShown, picture)).forEach(Choice::release);
    super.dispose();
  }
}
