package simbad.gui;

import static org.junit.jupiter.api.Assertions.assertSame;

import java.io.PrintStream;
import javax.swing.JTextArea;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

@Tag("display")
class ConsoleTest {
  @Test
  void console_showsWhatIsPrinted_untilItIsClosed() throws Exception {
    PrintStream before = System.out;
    Console console = Desk.onEventThread(() -> new Console(300, 200));
    try {
      JTextArea text = Desk.parts(console, JTextArea.class).findFirst().orElseThrow();
      System.out.println("printed by a program");
      Desk.await("it is shown", () -> text.getText().contains("printed by a program"));
    } finally {
      Desk.onEventThread(
          () -> {
            console.dispose();
            return true;
          });
    }
    assertSame(before, System.out);
  }
}
