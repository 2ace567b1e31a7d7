package simbad.cli;

import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.NoSuchFileException;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.concurrent.ExecutionException;
import picocli.CommandLine.ParameterException;
import simbad.obstacles.ObstacleOverlapException;
import simbad.sonar.format.DataFormatException;

/** Which exception means which exit status; a class that is not named has its superclass's. */
final class ExitStatus {
  /** The work is done. */
  static final int DONE = 0;

  /**
   * The work failed, though it was asked for rightly: a port that is gone, a full disk, a fault in
   * the program.
   */
  static final int FAILED = 1;

  /** Wrong usage or bad input: the caller can mend it. */
  static final int BAD_INPUT = 2;

  private final Map<Class<? extends Throwable>, Integer> statusByClass;

  private ExitStatus(Map<Class<? extends Throwable>, Integer> statusByClass) {
    this.statusByClass = Map.copyOf(statusByClass);
  }

  /** The rules of the command line. A new kind of bad input is one line more here. */
  static ExitStatus rules() {
    return new ExitStatus(
        Map.of(
            Throwable.class, FAILED,
            ParameterException.class, BAD_INPUT,
            DataFormatException.class, BAD_INPUT,
            // A world of the user's own demo.
            ObstacleOverlapException.class, BAD_INPUT,
            // A jar of the user's own that names what it does not hold.
            ServiceConfigurationError.class, BAD_INPUT,
            // A file that the user named and that cannot be read, or would be overwritten.
            NoSuchFileException.class, BAD_INPUT,
            AccessDeniedException.class, BAD_INPUT,
            FileAlreadyExistsException.class, BAD_INPUT));
  }

  /** The exit status for what a command ended with; wrappers count as what they wrap. */
  int of(Throwable fault) {
    Class<?> type = unwrapped(fault).getClass();
    while (!statusByClass.containsKey(type)) {
      type = type.getSuperclass();
    }
    return statusByClass.get(type);
  }

  /** The fault without the wrappers that other threads and streams put round it. */
  static Throwable unwrapped(Throwable fault) {
    Throwable cause = fault.getCause();
    boolean wrapper =
        fault instanceof UncheckedIOException
            || fault instanceof ExecutionException
            || fault instanceof ExceptionInInitializerError;
    return wrapper && cause != null ? unwrapped(cause) : fault;
  }
}
