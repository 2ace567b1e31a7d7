package simbad.bench.session;

import java.io.IOException;
import java.time.Duration;
import java.util.Optional;
import java.util.OptionalInt;
import simbad.bench.link.SerialLink;
import simbad.bench.protocol.FirmwareMode;
import simbad.bench.protocol.FrameLine;
import simbad.bench.protocol.ProtocolTable;
import simbad.bench.protocol.ThesisLine;

/**
 * A ranger at the other end of a line, asked for one ping at a time. Not thread-safe.
 *
 * <p>No ping is ever taken for another one: after {@link #settle} the board is known to be silent,
 * each ping is asked for, and a line whose number is not the next one, or that nobody asked for, is
 * a {@link Disturbance}, never a reading.
 */
public final class Ranger implements AutoCloseable {
  private static final int NUMBERS = 65536;
  private static final int LONGEST_SHOWN = 40;

  /** Saying who it is takes the board 20 ms, and a ping is over within 75. */
  private static final int ROUNDS_TO_SILENCE = 6;

  private static final Duration PATIENCE = Duration.ofMillis(700);

  private final SerialLink link;
  private final LineAssembler lines = new LineAssembler();
  private final byte[] bytes = new byte[4096];
  private final byte identify;
  private final byte[] asking;
  private final byte[] attention;
  private final FirmwareMode mode;
  private FrameLine.Identity identity;
  private OptionalInt last = OptionalInt.empty();

  private Ranger(SerialLink link, ProtocolTable table, FirmwareMode mode) {
    this.link = link;
    this.mode = mode;
    identify = table.command("identify");
    byte single = table.command("single");
    // The mode each time: after a reset that nobody noticed the board is in frame mode.
    asking =
        mode == FirmwareMode.FRAME
            ? new byte[] {single}
            : new byte[] {table.command(mode.word()), single};
    // The line end ends a number that may be waited for.
    attention = new byte[] {'\r', table.command("frame"), table.command("halt"), identify};
    identity = new FrameLine.Identity("", "", "", "");
  }

  /**
   * Finds out who is there and makes it fall silent.
   *
   * @param link open; closed when this fails
   * @param limit how long to try
   * @param mode in which it shall report pings; without numbers and checksums, as in the thesis's,
   *     a line that is lost or torn may pass for another one
   * @throws IOException if nobody is there that says who it is, in one line
   */
  public static Ranger connect(SerialLink link, Duration limit, FirmwareMode mode)
      throws IOException {
    Ranger ranger = new Ranger(link, ProtocolTable.shipped(), mode);
    try {
      ranger.settle(limit);
      return ranger;
    } catch (IOException e) {
      link.close();
      throw e;
    }
  }

  /** Returns who said that it is there, last. */
  public FrameLine.Identity identity() {
    return identity;
  }

  /**
   * Begins anew: stops the board from pinging and waits, by the board's own time, until whatever
   * was under way is over.
   *
   * @param limit how long to try
   * @throws Disturbance if nobody answers in time who says what it is
   * @throws IOException if the line is gone
   */
  public void settle(Duration limit) throws IOException {
    Deadline deadline = Deadline.in(limit);
    last = OptionalInt.empty();
    while (!answersInTurn(deadline)) {
      if (deadline.isOver()) {
        throw new Disturbance(
            "no ranger answers; is the board switched on, at 19200 baud, with this "
                + "project's firmware (./simbad flash-info)?");
      }
    }
  }

  private boolean answersInTurn(Deadline deadline) throws IOException {
    lines.clear();
    link.write(attention);
    for (int round = 0; round <= ROUNDS_TO_SILENCE; round++) {
      Optional<FrameLine.Identity> said = awaitIdentity(deadline.within(PATIENCE));
      if (said.isEmpty()) {
        return false;
      }
      identity = said.get();
      if (round < ROUNDS_TO_SILENCE) {
        link.write(new byte[] {identify});
      }
    }
    return true;
  }

  /** The identity that follows the answer to the question for it; one of a reset does not. */
  private Optional<FrameLine.Identity> awaitIdentity(Deadline deadline) throws IOException {
    boolean answered = false;
    for (Optional<String> line = next(deadline); line.isPresent(); line = next(deadline)) {
      FrameLine said = FrameLine.parse(line.get()).orElse(null);
      if (said instanceof FrameLine.Answer answer && answer.command() == identify) {
        answered = true;
      } else if (answered && said instanceof FrameLine.Identity identified) {
        return Optional.of(identified);
      }
    }
    return Optional.empty();
  }

  /**
   * Pings once.
   *
   * @param limit how long to wait for the answer
   * @throws Disturbance if none came, or one that does not fit
   * @throws IOException if the line is gone
   */
  public FrameLine.Ping ping(Duration limit) throws IOException {
    refuseUnasked();
    link.write(asking);
    Deadline deadline = Deadline.in(limit);
    for (Optional<String> line = next(deadline); line.isPresent(); line = next(deadline)) {
      FrameLine said = parse(line.get());
      if (said instanceof FrameLine.Ping ping) {
        return inTurn(ping);
      }
      refuse(said);
    }
    throw new Disturbance("no answer within " + limit.toMillis() + " ms");
  }

  /** Nothing may have come since the last ping but the answer to its command. */
  private void refuseUnasked() throws IOException {
    Deadline now = Deadline.in(Duration.ZERO);
    for (Optional<String> line = next(now); line.isPresent(); line = next(now)) {
      FrameLine said = parse(line.get());
      if (said instanceof FrameLine.Ping ping) {
        throw new Disturbance("ping " + ping.sequence() + " came without a question");
      }
      refuse(said);
    }
  }

  private void refuse(FrameLine said) throws Disturbance {
    if (said instanceof FrameLine.Identity reset) {
      throw new Disturbance("the board was reset: " + reset.reset());
    }
    if (said instanceof FrameLine.Answer answer && answer.code() != 0) {
      throw new Disturbance("the board answered with code " + answer.code());
    }
  }

  private FrameLine.Ping inTurn(FrameLine.Ping ping) throws Disturbance {
    int due = last.isPresent() ? (last.getAsInt() + 1) % NUMBERS : ping.sequence();
    if (ping.sequence() != due) {
      throw new Disturbance("ping " + due + " expected, number " + ping.sequence() + " came");
    }
    last = OptionalInt.of(ping.sequence());
    return ping;
  }

  private FrameLine parse(String line) throws Disturbance {
    Optional<FrameLine> said = FrameLine.parse(line);
    if (mode == FirmwareMode.THESIS) {
      if (said.isPresent() && said.get() instanceof FrameLine.Ping) {
        throw new Disturbance("the board has left the thesis's mode");
      }
      // It numbers nothing: what comes is taken to be what is due.
      int due = (last.orElse(0) + 1) % NUMBERS;
      said = said.or(() -> ThesisLine.ping(line, due));
    }
    return said.orElseThrow(() -> new Disturbance(garbled(line)));
  }

  private static String garbled(String line) {
    String shown = line.replaceAll("[^ -~]", ".");
    return "garbled line '" + shown.substring(0, Math.min(LONGEST_SHOWN, shown.length())) + "'";
  }

  private Optional<String> next(Deadline deadline) throws IOException {
    while (!lines.hasLine()) {
      int count = link.read(bytes, deadline.left());
      if (count == 0) {
        return Optional.empty();
      }
      lines.take(bytes, count);
    }
    return Optional.of(lines.takeLine());
  }

  @Override
  public void close() {
    link.close();
  }
}
