package simbad.gui;

import java.awt.event.ActionEvent;
import java.awt.event.ActionListener;
import javax.swing.AbstractAction;
import javax.swing.Action;
import javax.swing.JButton;
import javax.swing.JToggleButton;
import javax.swing.KeyStroke;

/** One thing that a button or a menu item does; a listener tells it by its command. */
final class Choice extends AbstractAction {
  private transient ActionListener listener;

  /**
   * Creates a choice whose command is its name.
   *
   * @param name stands on the button and in the menu
   * @param toolTip says what it does
   * @param keys as in {@link KeyStroke#getKeyStroke(String)}; empty for none
   * @param listener is told
   */
  Choice(String name, String toolTip, String keys, ActionListener listener) {
    super(name);
    this.listener = listener;
    setCommand(name);
    putValue(Action.SHORT_DESCRIPTION, keys.isEmpty() ? toolTip : toolTip + text(keys));
    if (!keys.isEmpty()) {
      putValue(Action.ACCELERATOR_KEY, KeyStroke.getKeyStroke(keys));
    }
  }

  private static String text(String keys) {
    return " (" + keys.replace("control ", "Ctrl+") + ")";
  }

  void setCommand(String command) {
    putValue(Action.ACTION_COMMAND_KEY, command);
  }

  boolean hasCommand(String command) {
    return command.equals(getValue(Action.ACTION_COMMAND_KEY));
  }

  /** Marks the choice as the one that holds, on its toggle and in the menu. */
  void setSelected(boolean selected) {
    putValue(Action.SELECTED_KEY, selected);
  }

  JButton button() {
    JButton button = new JButton(this);
    button.setFocusable(false);
    return button;
  }

  JToggleButton toggle() {
    JToggleButton toggle = new JToggleButton(this);
    toggle.setFocusable(false);
    return toggle;
  }

  /**
   * Tells the listener no more. Swing notes actions whose buttons are gone, and forgets them when
   * the next button is made: until then nothing shall depend on them.
   */
  void release() {
    listener = event -> {};
  }

  @Override
  public void actionPerformed(ActionEvent event) {
    listener.actionPerformed(event);
  }
}
