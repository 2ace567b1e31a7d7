package simbad.bench.capture;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import simbad.sonar.format.DataFormatException;

/** A short journal read whole, for tests. */
public final class JournalEntries {
  private JournalEntries() {}

  /** Returns its entries in their order, the first one too. */
  public static List<Entry> of(Path file) throws DataFormatException {
    List<Entry> entries = new ArrayList<>();
    JournalText.read(file, entries::add);
    return entries;
  }

  /** Returns the state of the sweep after its last entry. */
  public static SweepState state(Path file) throws DataFormatException {
    SweepState state = new SweepState();
    JournalText.read(file, state::take);
    return state;
  }

  /** Reads it for what it is, not for its entries. */
  static JournalText text(Path file) throws DataFormatException {
    return JournalText.read(file, entry -> {});
  }
}
