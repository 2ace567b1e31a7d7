package simbad.bench.capture;

import java.io.IOException;

/** The person at the bench, or what stands for one. */
public interface Operator {
  /** Shows what is to be done now. */
  void show(SweepView view);

  /**
   * Waits for a line that the person types; readings may be shown meanwhile.
   *
   * @param live gives readings that are not recorded
   * @return what was typed; {@code q} at the end of the input
   * @throws IOException if there are no readings any more
   * @throws InterruptedException if the thread is interrupted
   */
  String ask(PingSource live) throws IOException, InterruptedException;

  /**
   * Waits for a line that the person types; nothing pings meanwhile.
   *
   * @throws IOException if nothing can be read
   */
  void pause() throws IOException;

  /** Says something in one line. */
  void say(String text);

  /** Shows a reading that was recorded. */
  void heard(Entry.Taken taken);

  /** Says, to be heard from afar, that the echo is lost. */
  void lost(Level level);
}
