package simbad.studio.folders;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import simbad.bench.capture.CaptureSettings;
import simbad.bench.capture.CapturedReadings;
import simbad.bench.capture.Entry;
import simbad.bench.capture.JournalText;
import simbad.bench.protocol.FrameLine;
import simbad.experiments.bench.CaptureFolder;
import simbad.sonar.format.DataFormatException;
import simbad.studio.bench.LiveState;

/**
 * How far captures are that another program makes: as of their journals now. Who follows one asks
 * several times a second, so a journal that has not changed is not read again.
 */
final class CaptureStates {
  /** Pages that are left open follow different ones. */
  private static final int KEPT = 16;

  private final Map<Path, Known> known = new LinkedHashMap<>(16, 0.75f, true);

  /** What a capture came to, and of which journal that is. */
  private record Known(String stamp, String state) {}

  /**
   * Returns how far a capture is, as the page of a capture has it.
   *
   * @throws DataFormatException if its journal is damaged
   */
  synchronized String state(Path folder) throws DataFormatException {
    Path journal = Shelf.file(folder, "journal.txt");
    String stamp = stamp(journal);
    Known before = known.get(folder);
    if (before != null && before.stamp().equals(stamp)) {
      return before.state();
    }
    Known now = new Known(stamp, read(folder));
    known.put(folder, now);
    if (known.size() > KEPT) {
      known.remove(known.keySet().iterator().next());
    }
    return now.state();
  }

  private static String stamp(Path journal) {
    try {
      return Files.size(journal) + " " + Files.getLastModifiedTime(journal);
    } catch (IOException e) {
      // Who reads it says what is wrong with it.
      return "";
    }
  }

  private static String read(Path folder) throws DataFormatException {
    CapturedReadings readings = new CaptureFolder(folder).read();
    CaptureSettings settings = readings.settings();
    LiveState state = new LiveState(settings.of("obstacle"), settings.plan(), settings.ranging());
    state.show(readings.state());
    last(readings)
        .ifPresent(
            taken ->
                state.read(
                    new FrameLine.Ping(taken.sequence(), taken.status(), taken.echoUs(), 0)));
    return state.json();
  }

  /** The last reading: what stands on the page in large type. */
  private static Optional<Entry.Taken> last(CapturedReadings readings) throws DataFormatException {
    AtomicReference<Entry.Taken> last = new AtomicReference<>();
    JournalText.read(
        readings.text().file(),
        entry -> {
          if (entry instanceof Entry.Taken taken) {
            last.set(taken);
          }
        });
    return Optional.ofNullable(last.get());
  }
}
