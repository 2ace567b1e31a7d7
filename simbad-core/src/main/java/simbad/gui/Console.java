package simbad.gui;

import java.io.ByteArrayOutputStream;
import java.io.OutputStream;
import java.io.PrintStream;
import java.nio.charset.Charset;
import javax.swing.JInternalFrame;
import javax.swing.JScrollPane;
import javax.swing.JTextArea;
import javax.swing.SwingUtilities;
import simbad.kernel.run.Pacer;

/** Shows what the program prints, from its creation until it is closed. */
public class Console extends JInternalFrame implements Runnable {
  private static final double REFRESH_S = 0.1;

  private final JTextArea text = new JTextArea();
  private final transient ByteArrayOutputStream printed = new ByteArrayOutputStream();
  private final transient PrintStream before = System.out;
  private final transient Pacer pacer = new Pacer("console");

  /**
   * Creates a console and lets it have what is printed to standard output, which still appears
   * where it did.
   *
   * @param width pixels
   * @param height pixels
   */
  public Console(int width, int height) {
    super("Console", true, true, true, true);
    text.setEditable(false);
    add(new JScrollPane(text));
    setSize(width, height);
    setVisible(true);
    System.setOut(new PrintStream(new Both(), true, Charset.defaultCharset()));
    pacer.start(REFRESH_S, this);
  }

  /** Shows what has been printed since the last time. */
  @Override
  public void run() {
    String news;
    synchronized (printed) {
      news = printed.toString(Charset.defaultCharset());
      printed.reset();
    }
    if (!news.isEmpty()) {
      SwingUtilities.invokeLater(() -> append(news));
    }
  }

  private void append(String news) {
    // In the order in which a layout takes its locks, which old programs start on any thread.
    synchronized (text.getTreeLock()) {
      text.append(news);
    }
  }

  @Override
  public void dispose() {
    pacer.stop();
    System.setOut(before);
    super.dispose();
  }

  private final class Both extends OutputStream {
    @Override
    public void write(int octet) {
      before.write(octet);
      synchronized (printed) {
        printed.write(octet);
      }
    }
  }
}
