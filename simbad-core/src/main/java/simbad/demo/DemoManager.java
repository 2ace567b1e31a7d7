package simbad.demo;

import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.function.Supplier;
import java.util.stream.Stream;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import org.jspecify.annotations.Nullable;

/**
 * Lists the demos: every class that a jar on the class path provides as a service of the type
 * {@link Demo}. Their names are the classes' simple names.
 */
public class DemoManager {
  private static final String MENU = "Examples";

  /** Creates a list; its methods are static. */
  public DemoManager() {}

  /** Returns the names of all demos, Simbad's own first, then in the order of their jars. */
  public static List<String> names() {
    return providers().map(provider -> provider.type().getSimpleName()).distinct().toList();
  }

  /**
   * Makes a demo.
   *
   * @param name one of {@link #names()}
   * @return a new environment; empty if there is no demo of that name
   */
  public static Optional<Demo> find(String name) {
    return providers()
        .filter(provider -> provider.type().getSimpleName().equals(name))
        .findFirst()
        .map(Supplier::get);
  }

  private static Stream<ServiceLoader.Provider<Demo>> providers() {
    return ServiceLoader.load(Demo.class).stream()
        .sorted(Comparator.comparing(provider -> !isOwn(provider.type())));
  }

  private static boolean isOwn(Class<? extends Demo> type) {
    return type.getPackage().equals(Demo.class.getPackage());
  }

  /** Returns a new menu with an item for each demo, whose action command is the demo's name. */
  public static final JMenu createMenu(ActionListener listener) {
    JMenu menu = new JMenu(MENU);
    for (String name : names()) {
      JMenuItem item = new JMenuItem(name);
      item.setActionCommand(name);
      item.addActionListener(listener);
      menu.add(item);
    }
    return menu;
  }

  /** Returns a new demo for an event of the menu, or null if the event is of something else. */
  public static @Nullable Demo getDemoFromActionEvent(ActionEvent event) {
    String command = event.getActionCommand();
    return command == null ? null : find(command).orElse(null);
  }
}
