package simbad.experiments.program;

import java.awt.HeadlessException;
import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/** A program failed; the message says where. */
public final class ProgramException extends Exception {
  private static final long serialVersionUID = 1;

  ProgramException(String message, @Nullable Throwable cause) {
    super(message, cause);
  }

  /** Names the fault and the line of the program that it comes from. */
  static ProgramException of(String where, Throwable fault) {
    String place =
        Arrays.stream(fault.getStackTrace())
            .filter(frame -> !frame.getClassName().matches("(java|javax|jdk|simbad|sun)\\..*"))
            .findFirst()
            .map(frame -> " at " + frame.getFileName() + ":" + frame.getLineNumber())
            .orElse("");
    String said =
        fault instanceof HeadlessException
            ? "opens what needs a display" + place + "; where there is one, add --window"
            : fault + place;
    return new ProgramException(where + ": " + said, fault);
  }
}
