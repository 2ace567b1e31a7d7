package simbad.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Level;
import simbad.bench.capture.Operator;
import simbad.bench.capture.PingSource;
import simbad.bench.capture.Ranging;
import simbad.bench.capture.SweepView;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;

/**
 * A person at a terminal. There the reading and the bearing stand large above the prompt, and the
 * reading goes on while the person moves the obstacle and types; elsewhere, as in a pipe, there are
 * lines only.
 */
final class TerminalOperator implements Operator {
  private static final String BELL = "\u0007";
  private static final String CLEAR = "\u001b[2J\u001b[H";
  private static final String SAVE = "\u001b7\u001b[H";
  private static final String RESTORE = "\u001b8";
  private static final String REST_OF_LINE = "\u001b[K";
  private static final String ALARM = "\u001b[1;31m";
  private static final String PLAIN = "\u001b[0m";
  private static final String RIGHT = "\u001b[48G";
  private static final int ROWS_ABOVE = 8;
  private static final double CM = 100;

  private final BufferedReader in;
  private final PrintWriter out;
  private final boolean terminal;
  private final EchoWindow window;
  private Ranging ranging;
  private String last = "";
  private String reading = "---";
  private List<String> bearing = BigDigits.of("");

  TerminalOperator(BufferedReader in, PrintWriter out, CaptureSettings settings, boolean terminal) {
    this.in = in;
    this.out = out;
    ranging = settings.ranging();
    window = new EchoWindow(settings.plan().pings(), settings.plan().misses());
    this.terminal = terminal;
  }

  @Override
  public void show(SweepView view) {
    bearing =
        BigDigits.of(
            String.format(Locale.ROOT, "%.4g", view.plan().bearingDeg(view.bearing()))
                    .replaceFirst("\\.?0*$", "")
                + "\u00b0");
    if (terminal) {
      out.print(CLEAR + "\n".repeat(ROWS_ABOVE));
    }
    view.text().forEach(out::println);
    if (!last.isEmpty()) {
      out.println(last);
    }
    out.print("> ");
    draw();
  }

  @Override
  public String ask(PingSource live) throws IOException, InterruptedException {
    while (terminal && !in.ready()) {
      FrameLine.Ping ping = live.ping();
      showLarge(ping.status(), ping.echoUs().orElse(0));
    }
    return typed();
  }

  private String typed() throws IOException {
    String line = in.readLine();
    return line == null ? "q" : line;
  }

  @Override
  public void pause() throws IOException {
    out.print("paused; Enter continues > ");
    out.flush();
    typed();
  }

  private void showLarge(PingStatus status, int echoUs) {
    boolean heard = status == PingStatus.ECHO;
    if (window.losesWith(heard || status == PingStatus.TOO_NEAR) && terminal) {
      out.print(BELL);
    }
    reading = heard ? String.format(Locale.ROOT, "%5.1f", CM * ranging.rangeM(echoUs)) : "  ---";
    draw();
  }

  /** Reading on the left, bearing on the right, what they are below; the cursor stays. */
  private void draw() {
    if (terminal) {
      StringBuilder drawn = new StringBuilder(SAVE + (window.isLost() ? ALARM : ""));
      List<String> left = BigDigits.of(window.isLost() ? "LOST" : reading);
      for (int row = 0; row < left.size(); row++) {
        drawn.append(left.get(row)).append(REST_OF_LINE);
        drawn.append(RIGHT).append(PLAIN).append(bearing.get(row)).append("\r\n");
        drawn.append(window.isLost() ? ALARM : "");
      }
      drawn.append(PLAIN).append(REST_OF_LINE).append("\r\n");
      drawn.append("cm to the SURFACE, ").append(window.text()).append(REST_OF_LINE);
      out.print(drawn.append(RIGHT).append("turn it to this bearing").append(RESTORE));
    }
    out.flush();
  }

  @Override
  public void say(String text) {
    last = text;
    if (!terminal) {
      out.println(text);
    }
  }

  @Override
  public void heard(Entry.Taken taken) {
    ranging = Ranging.of(taken.temperatureC(), ranging.mode());
    showLarge(taken.status(), taken.echoUs().orElse(0));
  }

  @Override
  public void lost(Level level) {
    say(
        String.format(
            Locale.ROOT,
            "LOST at %.1f cm: only %d of %d heard",
            CM * level.distanceM(),
            level.heard(),
            level.pings()));
    if (terminal) {
      out.print(BELL);
    }
  }
}
