package simbad.gui;

import java.awt.event.ActionListener;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JLabel;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JOptionPane;
import javax.swing.KeyStroke;

/** The menus of the main window that do not belong to one simulation. */
final class Menus {
  /** As in docs/guide/window.md. */
  static final String CONTROLS =
      """
      <html><table cellpadding=3>
      <tr><td>left button</td><td>turn the view</td></tr>
      <tr><td>right button</td><td>move the view</td></tr>
      <tr><td>wheel, middle button, Alt + left button</td><td>nearer or farther</td></tr>
      <tr><td>double click</td><td>back to the chosen view</td></tr>
      <tr><td>F5, F6, F7, F8, F9</td><td>run, pause, step, reset, restart</td></tr>
      <tr><td>Ctrl+1, Ctrl+2</td><td>view from the top, from the side</td></tr>
      <tr><td>Ctrl+3, Ctrl+4</td><td>follow the chosen agent from far above, from near above</td></tr>
      <tr><td>Ctrl+5, Ctrl+6</td><td>follow it beside, behind</td></tr>
      <tr><td>Ctrl+7</td><td>follow it and look over it to the middle of the world</td></tr>
      <tr><td>Ctrl+L, Ctrl+T</td><td>legend, trails: on or off</td></tr>
      <tr><td>Ctrl+N, Ctrl+E</td><td>names, shadow edges: on or off</td></tr>
      <tr><td>Ctrl+S</td><td>save a picture of the world</td></tr>
      <tr><td>Ctrl+I, Ctrl+Shift+A</td><td>inspect an agent, arrange the windows</td></tr>
      <tr><td>F1, Ctrl+Q</td><td>help, quit</td></tr>
      <tr><td>other keys</td><td>go to the robots' key sensors</td></tr>
      </table></html>""";

  private static final String ABOUT =
      """
      <html><b>Simbad Sonar</b><br>
      A robot simulator, compatible with Simbad,<br>
      whose sonar detects what a real SRF04 detects.<br><br>
      GPL-3.0-or-later</html>""";

  private final Simbad frame;

  Menus(Simbad frame) {
    this.frame = frame;
  }

  JMenu file() {
    JMenu menu = menu("File", 'F');
    menu.add(item("Quit", "control Q", event -> frame.quit()));
    return menu;
  }

  JMenu window() {
    JMenu menu = menu("Window", 'W');
    menu.add(item("Inspect an agent", "control I", event -> frame.inspect()));
    menu.add(item("Arrange windows", "control shift A", event -> frame.arrange()));
    menu.addSeparator();
    JCheckBoxMenuItem dark = new JCheckBoxMenuItem("Dark theme", Theme.isDark());
    dark.addActionListener(event -> Theme.set(dark.isSelected()));
    menu.add(dark);
    return menu;
  }

  JMenu help() {
    JMenu menu = menu("Help", 'H');
    menu.add(item("Mouse and keys", "F1", event -> say("Mouse and keys", CONTROLS)));
    menu.add(item("About", "", event -> say("About", ABOUT)));
    return menu;
  }

  /** In one label: of a text with several lines, the dialog makes one of each line. */
  private void say(String title, String text) {
    JOptionPane.showMessageDialog(frame, new JLabel(text), title, JOptionPane.PLAIN_MESSAGE);
  }

  private static JMenu menu(String name, char mnemonic) {
    JMenu menu = new JMenu(name);
    menu.setMnemonic(mnemonic);
    return menu;
  }

  private static JMenuItem item(String name, String keys, ActionListener listener) {
    JMenuItem item = new JMenuItem(name);
    item.setAccelerator(KeyStroke.getKeyStroke(keys));
    item.addActionListener(listener);
    return item;
  }
}
