package simbad.bench.board;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;

/**
 * What may befall the board besides the obstacle: a fault that lasts as long as the script's row,
 * or something that happens once, when the row begins.
 */
public enum BoardEvent {
  /** Nothing. */
  NONE,
  /** Lasting: no echo ever. */
  NO_ECHO,
  /** Lasting: the echo line stays high. */
  STUCK_HIGH,
  /** Lasting: the echo line stays low. */
  STUCK_LOW,
  /** Lasting: the trigger is too short for this sensor, so that it does not ping. */
  TRIGGER_REFUSED,
  /** Lasting: the far end listens and speaks at half the speed. */
  WRONG_BAUD,
  /** Lasting: the far end hears nothing. */
  SILENCE,
  /** Once: 64 bytes that nobody sent. */
  GARBAGE,
  /** Once: the supply is switched on. */
  POWER_ON,
  /** Once: the supply falls for a moment. */
  BROWN_OUT,
  /** Once: the watchdog runs out. */
  WATCHDOG,
  /** Once: the reset pin is pulled low. */
  MASTER_CLEAR;

  private static final double BAUD = 19200;
  private static final double LEAST_TRIGGER_S = 10e-6;
  private static final double REFUSING_TRIGGER_S = 1;
  private static final double FOR_EVER_S = 1e6;
  private static final int GARBAGE_BYTES = 64;

  /** Returns the word in a script. */
  public String word() {
    return name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  static Optional<BoardEvent> find(String word) {
    return Arrays.stream(values()).filter(event -> event.word().equals(word)).findFirst();
  }

  static String words() {
    return Arrays.stream(values()).map(BoardEvent::word).collect(Collectors.joining(", "));
  }

  /** What begins this event and ends whichever lasted before. */
  List<BoardOrder> orders() {
    List<BoardOrder> orders = new ArrayList<>();
    orders.add(BoardOrder.fault(fault()));
    orders.add(
        BoardOrder.leastTrigger(this == TRIGGER_REFUSED ? REFUSING_TRIGGER_S : LEAST_TRIGGER_S));
    orders.add(BoardOrder.baud(this == WRONG_BAUD ? BAUD / 2 : BAUD));
    orders.add(BoardOrder.silence(this == SILENCE ? FOR_EVER_S : 0));
    if (this == GARBAGE) {
      orders.add(BoardOrder.garbage(GARBAGE_BYTES));
    }
    ResetCause.find(word()).ifPresent(cause -> orders.add(BoardOrder.reset(cause, 0)));
    return orders;
  }

  private SensorFault fault() {
    return switch (this) {
      case NO_ECHO -> SensorFault.NO_ECHO;
      case STUCK_HIGH -> SensorFault.STUCK_HIGH;
      case STUCK_LOW -> SensorFault.STUCK_LOW;
      default -> SensorFault.NONE;
    };
  }
}
