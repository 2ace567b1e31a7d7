package simbad.gap.audit;

import java.util.List;

/**
 * Something that the audit found in a data set.
 *
 * @param check that check found it
 * @param file in which of the data set's files it stands
 * @param what was found, a sentence without its full stop
 * @param rows of that file that show it, counted from 0 below the header, ascending; empty where it
 *     is of the whole file
 * @param suggestion what to do, a sentence without its full stop; empty where there is nothing to
 *     do
 * @param mend options of {@code dataset mend} that undo it; empty where no transformation does
 * @param severity what it means for the diagnosis
 */
public record AuditFinding(
    AuditCheck check,
    File file,
    String what,
    List<Integer> rows,
    String suggestion,
    String mend,
    Severity severity) {
  /** Copies the list. */
  public AuditFinding {
    rows = List.copyOf(rows);
  }

  /** A file of a data set. */
  public enum File {
    /** What the simulator believes. */
    SCENE("scene.json"),
    /** What was read. */
    READINGS("readings.csv"),
    /** What was read while the simulation was trusted. */
    REFERENCE("reference.csv"),
    /** What was commanded. */
    COMMANDS("commands.csv"),
    /** Where the robot was. */
    TRACK("track.csv");

    private final String fileName;

    File(String fileName) {
      this.fileName = fileName;
    }

    /** Returns its name in the data set's folder. */
    public String fileName() {
      return fileName;
    }
  }

  /** Returns whether the data cannot be believed. */
  public boolean refuses() {
    return severity == Severity.REFUSE;
  }

  AuditFinding in(File other) {
    return new AuditFinding(check, other, what, rows, suggestion, mend, severity);
  }
}
