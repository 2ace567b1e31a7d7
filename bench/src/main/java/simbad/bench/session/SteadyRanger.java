package simbad.bench.session;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.function.Consumer;
import simbad.bench.link.LinkSource;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.PingStatus;

/**
 * A ranger that is asked again when something went wrong, over a line that is opened again when it
 * was lost. What comes out of it are pings that were asked for and answered in order. Not
 * thread-safe.
 */
public final class SteadyRanger implements AutoCloseable {
  private static final Duration RETRY = Duration.ofMillis(200);

  private static final int MOST_STUCK = 20;

  /** So long is a ping still heard. */
  private static final int RINGING_MS = 65;

  private final LinkSource source;
  private final Terms terms;
  private final Consumer<String> told;
  private Optional<Ranger> ranger = Optional.empty();
  private long askedNs = System.nanoTime() - Duration.ofSeconds(1).toNanos();
  private int stuck;

  /**
   * How it is asked.
   *
   * @param connect how long it is asked who it is
   * @param answer how long a ping's answer is waited for
   * @param patience how long a board that does not answer, or a port that is gone, is waited for
   * @param spacing least time from ping to ping, by this clock and by the board's: the ping before
   *     is heard for 65 ms. Zero where nothing echoes
   * @param mode in which the board reports
   */
  public record Terms(
      Duration connect, Duration answer, Duration patience, Duration spacing, FirmwareMode mode) {
    /**
     * Terms for a bench: nobody there must be said within 5 s, and a program takes some to begin.
     */
    public static final Terms BENCH =
        new Terms(
            Duration.ofSeconds(2),
            Duration.ofSeconds(1),
            Duration.ofSeconds(60),
            Duration.ofMillis(68),
            FirmwareMode.FRAME);

    /** Terms for a simulated board, whose time is not this one's and whose air does not ring. */
    public static final Terms SIMULATED =
        new Terms(
            Duration.ofSeconds(5),
            Duration.ofSeconds(5),
            Duration.ofSeconds(60),
            Duration.ZERO,
            FirmwareMode.FRAME);

    /** As the thesis spaced them; in its mode the board does not tell its own clock. */
    private static final Duration THESIS_SPACING = Duration.ofMillis(250);

    /** Returns the same in a mode. */
    public Terms in(FirmwareMode other) {
      boolean slow = other == FirmwareMode.THESIS && !spacing.isZero();
      return new Terms(connect, answer, patience, slow ? THESIS_SPACING : spacing, other);
    }
  }

  /**
   * Connects.
   *
   * @param source opens the line
   * @param terms how it is asked
   * @param told each disturbance, in one line
   * @throws IOException if there is no ranger
   */
  public SteadyRanger(LinkSource source, Terms terms, Consumer<String> told) throws IOException {
    this.source = source;
    this.terms = terms;
    this.told = told;
    ranger = Optional.of(Ranger.connect(source.open(), terms.connect(), terms.mode()));
  }

  /**
   * Returns who is there.
   *
   * @throws IOException if the line is lost at present
   */
  public FrameLine.Identity identity() throws IOException {
    return ranger.orElseThrow(() -> new IOException("the line is lost")).identity();
  }

  /**
   * Pings until an answer fits.
   *
   * @return the ping, whose status is any but stuck
   * @throws IOException if the patience has run out, in one line
   * @throws InterruptedException if the thread is interrupted while it waits
   */
  public FrameLine.Ping ping() throws IOException, InterruptedException {
    Deadline deadline = Deadline.in(terms.patience());
    while (true) {
      try {
        FrameLine.Ping ping = attempt();
        if (isGood(ping)) {
          return ping;
        }
      } catch (StuckLine e) {
        throw e;
      } catch (IOException e) {
        told.accept(String.valueOf(e.getMessage()));
        recover(deadline);
      }
    }
  }

  private FrameLine.Ping attempt() throws IOException, InterruptedException {
    long waitNs = terms.spacing().toNanos() - (System.nanoTime() - askedNs);
    if (waitNs > 0) {
      Thread.sleep(waitNs / 1_000_000 + 1);
    }
    askedNs = System.nanoTime();
    return ranger.orElseThrow(() -> new IOException("the line is lost")).ping(terms.answer());
  }

  private boolean isGood(FrameLine.Ping ping) throws IOException {
    if (ping.status() == PingStatus.STUCK) {
      told.accept("the echo line is stuck");
      stuck++;
      if (stuck >= MOST_STUCK) {
        throw new StuckLine();
      }
      return false;
    }
    stuck = 0;
    return ping.sinceMs() >= Math.min(terms.spacing().toMillis(), RINGING_MS);
  }

  /** Thrown past the retries: asking again would not mend a wire. */
  private static final class StuckLine extends IOException {
    private static final long serialVersionUID = 1;

    StuckLine() {
      super(
          "the sensor's echo line is stuck: "
              + MOST_STUCK
              + " pings without a pulse; look at its wires and its supply");
    }
  }

  private void recover(Deadline deadline) throws IOException, InterruptedException {
    while (true) {
      try {
        if (ranger.isEmpty()) {
          ranger = Optional.of(Ranger.connect(source.open(), terms.connect(), terms.mode()));
        } else {
          ranger.get().settle(terms.connect());
        }
        return;
      } catch (IOException e) {
        close();
        if (deadline.isOver()) {
          throw new IOException(
              "given up after " + terms.patience().toSeconds() + " s: " + e.getMessage(), e);
        }
        Thread.sleep(RETRY.toMillis());
      }
    }
  }

  @Override
  public void close() {
    ranger.ifPresent(Ranger::close);
    ranger = Optional.empty();
  }
}
