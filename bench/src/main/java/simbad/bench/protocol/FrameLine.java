package simbad.bench.protocol;

import java.util.Optional;
import java.util.OptionalInt;

/** A line of the firmware's frame mode whose checksum fits. */
public sealed interface FrameLine {
  /**
   * A ping.
   *
   * @param sequence number of the ping since the reset, from 1, in [0, 65535]: it wraps
   * @param status what became of it
   * @param echoUs length of the sensor's pulse in microseconds; empty when stuck
   * @param sinceMs from the trigger of the ping before to this one's, in milliseconds; 65535 for
   *     that long or longer, or when there was none
   */
  record Ping(int sequence, PingStatus status, OptionalInt echoUs, int sinceMs)
      implements FrameLine {}

  /**
   * An answer to a command.
   *
   * @param code as in docs/protocol.csv
   * @param command the byte that is answered, in [0, 255]
   * @param periodMs the ping period now in force
   */
  record Answer(int code, int command, int periodMs) implements FrameLine {}

  /**
   * Who speaks.
   *
   * @param name of the firmware
   * @param version of the firmware
   * @param build names the sources it was made from
   * @param reset cause of the last reset, a word of docs/protocol.csv
   */
  record Identity(String name, String version, String build, String reset) implements FrameLine {}

  /**
   * Reads a line.
   *
   * @param line without its line end
   * @return empty for all that is not a line of frame mode with a checksum that fits, such as what
   *     noise or a reset left over
   */
  static Optional<FrameLine> parse(String line) {
    int star = line.length() - 5;
    if (star < 0 || line.charAt(star) != '*') {
      return Optional.empty();
    }
    String text = line.substring(0, star);
    if (!Checksum.of(text).equals(line.substring(star + 1))) {
      return Optional.empty();
    }
    return LineForm.parse(text);
  }
}
