package simbad.cli;

import me.tongfei.progressbar.ProgressBar;
import me.tongfei.progressbar.ProgressBarBuilder;
import me.tongfei.progressbar.ProgressBarStyle;
import org.jspecify.annotations.Nullable;

/** How far long work is: a bar on a terminal, nothing elsewhere. Thread-safe. */
final class Progress implements AutoCloseable {
  /** Set by the launcher, which knows; Java does not say whether standard error is a terminal. */
  private static final String TERMINAL_PROPERTY = "simbad.terminal";

  private final @Nullable ProgressBar bar;

  private Progress(@Nullable ProgressBar bar) {
    this.bar = bar;
  }

  /** Tells whether a person looks on. */
  static boolean onTerminal() {
    return Boolean.getBoolean(TERMINAL_PROPERTY);
  }

  static Progress of(String what, long steps) {
    if (!onTerminal()) {
      return new Progress(null);
    }
    return new Progress(
        new ProgressBarBuilder()
            .setTaskName(what)
            .setInitialMax(steps)
            .setStyle(ProgressBarStyle.ASCII)
            .build());
  }

  void step() {
    if (bar != null) {
      bar.step();
    }
  }

  /** Makes room for a line on the same terminal; the bar comes back below it. */
  void clearLine() {
    if (bar != null) {
      System.err.print("\r\u001b[K");
    }
  }

  @Override
  public void close() {
    if (bar != null) {
      bar.close();
    }
  }
}
