package simbad.bench.session;

import java.nio.charset.StandardCharsets;
import java.util.ArrayDeque;
import java.util.Deque;

/** Makes lines of the bytes that come. Takes no more memory than a screenful, whatever comes. */
final class LineAssembler {
  /** The longest line of the firmware has 47 characters. */
  private static final int LONGEST = 200;

  private final StringBuilder begun = new StringBuilder();
  private final Deque<String> whole = new ArrayDeque<>();

  /** Takes bytes; CR and LF end a line, whichever and however many; empty lines are dropped. */
  void take(byte[] bytes, int count) {
    for (char c : new String(bytes, 0, count, StandardCharsets.ISO_8859_1).toCharArray()) {
      if (c == '\r' || c == '\n') {
        end();
      } else if (begun.length() < LONGEST) {
        begun.append(c);
      }
    }
  }

  private void end() {
    if (begun.length() > 0) {
      whole.add(begun.toString());
      begun.setLength(0);
    }
  }

  boolean hasLine() {
    return !whole.isEmpty();
  }

  /** The oldest whole line; there must be one. */
  String takeLine() {
    return whole.remove();
  }

  /** Forgets all that came. */
  void clear() {
    whole.clear();
    begun.setLength(0);
  }
}
