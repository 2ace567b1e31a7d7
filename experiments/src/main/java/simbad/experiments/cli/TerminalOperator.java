package simbad.experiments.cli;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.PrintWriter;
import java.util.Locale;
import simbad.bench.capture.Entry;
import simbad.bench.capture.Level;
import simbad.bench.capture.Operator;
import simbad.bench.capture.PingSource;
import simbad.bench.capture.Ranging;
import simbad.bench.capture.SweepView;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;

/**
 * A person at a terminal. There the reading stands large above the prompt and goes on while the
 * person turns and types; elsewhere, as in a pipe, there are lines only.
 */
final class TerminalOperator implements Operator {
  private static final String BELL = "\u0007";
  private static final String CLEAR = "\u001b[2J\u001b[H";
  private static final String SAVE = "\u001b7\u001b[H";
  private static final String RESTORE = "\u001b8";
  private static final String REST_OF_LINE = "\u001b[K";
  private static final int DIGIT_ROWS = 7;
  private static final double CM = 100;

  private final BufferedReader in;
  private final PrintWriter out;
  private final Ranging ranging;
  private final boolean terminal;
  private String last = "";

  TerminalOperator(BufferedReader in, PrintWriter out, Ranging ranging, boolean terminal) {
    this.in = in;
    this.out = out;
    this.ranging = ranging;
    this.terminal = terminal;
  }

  @Override
  public void show(SweepView view) {
    if (terminal) {
      out.print(CLEAR + "\n".repeat(DIGIT_ROWS));
    }
    view.text().forEach(out::println);
    if (!last.isEmpty()) {
      out.println(last);
    }
    out.print("> ");
    out.flush();
  }

  @Override
  public String ask(PingSource live) throws IOException, InterruptedException {
    while (terminal && !in.ready()) {
      showLarge(live.ping());
    }
    String line = in.readLine();
    return line == null ? "q" : line;
  }

  private void showLarge(FrameLine.Ping ping) {
    if (terminal) {
      StringBuilder drawn = new StringBuilder(SAVE);
      for (String line : BigDigits.of(reading(ping.status(), ping.echoUs().orElse(0)))) {
        drawn.append(line).append(REST_OF_LINE).append("\r\n");
      }
      out.print(drawn + "cm to the surface" + REST_OF_LINE + "\r\n" + REST_OF_LINE + RESTORE);
      out.flush();
    }
  }

  private String reading(PingStatus status, int echoUs) {
    return status == PingStatus.ECHO
        ? String.format(Locale.ROOT, "%5.1f", CM * ranging.rangeM(echoUs))
        : "---";
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
    if (terminal) {
      showLarge(new FrameLine.Ping(taken.sequence(), taken.status(), taken.echoUs(), 0));
    }
  }

  @Override
  public void lost(Level level) {
    if (terminal) {
      out.print(BELL);
    }
    say(
        String.format(
            Locale.ROOT,
            "LOST at %.1f cm: only %d of %d heard",
            CM * level.distanceM(),
            level.heard(),
            level.pings()));
  }
}
