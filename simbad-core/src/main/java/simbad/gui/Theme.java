package simbad.gui;

import com.formdev.flatlaf.FlatDarkLaf;
import com.formdev.flatlaf.FlatLaf;
import com.formdev.flatlaf.FlatLightLaf;
import javax.swing.JPopupMenu;
import javax.swing.LookAndFeel;
import javax.swing.ToolTipManager;
import javax.swing.UIManager;

/** How the windows look: light or dark. */
final class Theme {
  /** The system property that chooses the theme at the start: {@code light} or {@code dark}. */
  static final String PROPERTY = "simbad.theme";

  private Theme() {}

  /** Sets the theme that the system property asks for, unless the program has a look of its own. */
  static void install() {
    // A shadow would be painted over the canvas as a border.
    UIManager.put("InternalFrame.dropShadowPainted", false);
    // The canvas would hide menus and tool tips that have no window of their own.
    JPopupMenu.setDefaultLightWeightPopupEnabled(false);
    ToolTipManager.sharedInstance().setLightWeightPopupEnabled(false);
    LookAndFeel current = UIManager.getLookAndFeel();
    boolean isDefault =
        current.getClass().getName().equals(UIManager.getCrossPlatformLookAndFeelClassName());
    if (isDefault && System.getProperty("swing.defaultlaf") == null) {
      set("dark".equals(System.getProperty(PROPERTY)));
    }
  }

  /** Sets a theme, also of the windows that are open. */
  static void set(boolean dark) {
    if (dark) {
      FlatDarkLaf.setup();
    } else {
      FlatLightLaf.setup();
    }
    FlatLaf.updateUI();
  }

  static boolean isDark() {
    return FlatLaf.isLafDark();
  }
}
