package simbad.sonar.format;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A process, so described that another one with its number is not taken for it.
 *
 * @param pid the process's number
 * @param start when it began: the system's ticks since it booted, elsewhere than on Linux
 *     milliseconds since 1970
 * @param boot which boot of the machine that was, a hash
 * @param machine which machine, or which container of it, a hash
 */
record Owner(long pid, long start, String boot, String machine) {
  /** As {@link #mark} writes it. */
  static final String FORM = "(\\d{1,10})-(\\d{1,18})-([0-9a-f]{6})-([0-9a-f]{6})";

  private static final Pattern MARK = Pattern.compile(FORM);
  private static final Path PROCESSES = Path.of("/proc");

  /** What stands in a process's line of /proc after its name: its state first, its start here. */
  private static final int START_FIELD = 19;

  private static final class Current {
    static final Owner OWNER = read();

    private static Owner read() {
      long pid = ProcessHandle.current().pid();
      String machine =
          content(Path.of("/etc/machine-id"))
              + " "
              + content(PROCESSES.resolve("sys/kernel/hostname"))
              + " "
              + target(PROCESSES.resolve("self/ns/pid"));
      String boot = content(PROCESSES.resolve("sys/kernel/random/boot_id"));
      return new Owner(pid, startOf(pid).orElse(0L), hash(boot), hash(machine));
    }
  }

  /** Returns this process. */
  static Owner current() {
    return Current.OWNER;
  }

  /** Reads what {@link #mark} wrote; empty for all else. */
  static Optional<Owner> parse(String mark) {
    Matcher matcher = MARK.matcher(mark);
    return matcher.matches()
        ? Optional.of(
            new Owner(
                Long.parseLong(matcher.group(1)),
                Long.parseLong(matcher.group(2)),
                matcher.group(3),
                matcher.group(4)))
        : Optional.empty();
  }

  /** Returns a text for a file's name; the launcher writes the same. */
  String mark() {
    return pid + "-" + start + "-" + boot + "-" + machine;
  }

  /**
   * Tells whether it certainly runs no more. Of another machine, or another container, that cannot
   * be known.
   */
  boolean isGone() {
    Owner here = current();
    if (!machine.equals(here.machine)) {
      return false;
    }
    return !boot.equals(here.boot) || startOf(pid).filter(now -> now == start).isEmpty();
  }

  /** When the process with a number began; empty when there is none, or only what is left of it. */
  private static Optional<Long> startOf(long pid) {
    if (Files.exists(PROCESSES.resolve("self/stat"))) {
      String line = content(PROCESSES.resolve(pid + "/stat"));
      // The name may hold blanks and brackets.
      String[] fields = line.substring(line.lastIndexOf(')') + 1).strip().split(" ", -1);
      boolean runs = fields.length > START_FIELD && !fields[0].equals("Z");
      return runs ? Optional.of(Long.parseLong(fields[START_FIELD])) : Optional.empty();
    }
    return ProcessHandle.of(pid)
        .map(process -> process.info().startInstant().map(Instant::toEpochMilli).orElse(0L));
  }

  private static String content(Path file) {
    try {
      return Files.readString(file).strip();
    } catch (IOException | UncheckedIOException e) {
      return "";
    }
  }

  private static String target(Path link) {
    try {
      return Files.readSymbolicLink(link).toString();
    } catch (IOException | UnsupportedOperationException e) {
      return "";
    }
  }

  private static String hash(String text) {
    return Sha256.hex(text.getBytes(StandardCharsets.UTF_8)).substring(0, 6);
  }
}
