package simbad.bench.capture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.bench.protocol.PingStatus;
import simbad.sonar.format.DataFormatException;

class JournalTest {
  @TempDir Path folder = Path.of("");

  private static final Entry.Begun BEGUN =
      new Entry.Begun(Map.of("format", "bench-journal/1", "obstacle", "a post, round"));

  private static final CaptureSettings SETTINGS =
      new CaptureSettings(
          SweepPlan.ofBearings(12), OptionalDouble.of(20), Map.of("obstacle", "angle"));

  private static Entry.Taken taken(int number) {
    return new Entry.Taken(
        1e9 + number / 8.0,
        number % 72,
        new TriedDistance(0.02 * (1 + number), Approach.OUT),
        number,
        number % 3 == 0 ? PingStatus.NO_ECHO : PingStatus.ECHO,
        number % 5 == 0 ? OptionalInt.empty() : OptionalInt.of(100 + number),
        number % 7 == 0 ? OptionalDouble.empty() : OptionalDouble.of(19.5));
  }

  private static List<Entry> entries() {
    List<Entry> entries = new ArrayList<>();
    for (int i = 0; i < 30; i++) {
      entries.add(taken(i));
    }
    entries.add(new Entry.Note(1e9, "the board was reset: brown-out"));
    entries.add(new Entry.Undone(3));
    entries.add(new Entry.Repeated(4));
    entries.add(new Entry.Done(5));
    return entries;
  }

  private Path written() throws IOException {
    Path file = folder.resolve("journal.txt");
    try (Journal journal = Journal.create(file, BEGUN)) {
      journal.append(entries().subList(0, 10));
      for (Entry entry : entries().subList(10, entries().size())) {
        journal.append(List.of(entry));
      }
    }
    return file;
  }

  @Test
  void whatIsAppended_isReadAgain() throws Exception {
    Path file = written();
    JournalText text = JournalEntries.text(file);
    List<Entry> read = JournalEntries.of(file);
    assertEquals(entries(), read.subList(1, read.size()));
    assertEquals(read.size(), text.lines());
    assertEquals("a post  round", text.begun().settings().get("obstacle"));
    assertEquals("", text.torn());
  }

  /** Cut anywhere: the whole lines stay, the rest is set aside, and the next lines fit on. */
  @Test
  void cutAtAnyByte_losesNoWholeLine() throws Exception {
    byte[] all = Files.readAllBytes(written());
    int firstLine = new String(all, StandardCharsets.UTF_8).indexOf('\n') + 1;
    for (int cut = firstLine; cut < all.length; cut += 7) {
      Path file = folder.resolve("cut" + cut);
      Files.write(file, Arrays.copyOf(all, cut));
      JournalText text = JournalEntries.text(file);
      List<Entry> before = JournalEntries.of(file);
      long whole =
          new String(all, 0, cut, StandardCharsets.UTF_8).chars().filter(c -> c == '\n').count();
      assertEquals(whole, text.lines());
      assertEquals(whole, before.size());
      assertEquals(cut, text.wholeBytes() + text.torn().length());
      try (Journal journal = Journal.resume(text)) {
        journal.append(List.of(taken(77)));
      }
      List<Entry> after = JournalEntries.of(file);
      assertEquals(before, after.subList(0, (int) whole));
      assertEquals(taken(77), after.get((int) whole));
      Path torn = folder.resolve("cut" + cut + ".torn");
      assertEquals(!text.torn().isEmpty(), Files.exists(torn));
      if (Files.exists(torn)) {
        assertEquals(
            text.torn() + "\n", new String(Files.readAllBytes(torn), StandardCharsets.ISO_8859_1));
      }
    }
  }

  @Test
  void lineThatIsChangedMissingOrThereTwice_isNamed() throws Exception {
    List<String> lines = Files.readAllLines(written());
    List<String> changed = new ArrayList<>(lines);
    changed.set(4, changed.get(4).replace("echo", "ecko"));
    checkDamaged(changed, ":5: line: damaged");
    List<String> missing = new ArrayList<>(lines);
    missing.remove(7);
    checkDamaged(missing, ":8: line: damaged");
    List<String> twice = new ArrayList<>(lines);
    twice.add(3, lines.get(3));
    checkDamaged(twice, ":5: line: damaged");
    checkDamaged(List.of("bearing_deg,threshold_m", "0,1"), "damaged");
    checkDamaged(List.of(), "is not a journal");
  }

  /** Well summed up, but no capture wrote it: who computes checksums can write anything. */
  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {
        "0, time_s, -1",
        "0, time_s, NaN",
        "0, time_s, 1e13",
        "1, bearing, -1",
        "1, bearing, 3600",
        "1, bearing, 99999999999",
        "2, distance_m, -0.04",
        "2, distance_m, 0",
        "2, distance_m, 1e5",
        "2, distance_m, Infinity",
        "3, approach, sideways",
        "4, sequence, 65536",
        "4, sequence, -1",
        "5, status, maybe",
        "6, echo_us, -100",
        "6, echo_us, 100000",
        "6, echo_us, 1e3",
        "7, temperature_c, 1e9",
        "7, temperature_c, -51",
        "7, temperature_c, warm"
      })
  void fieldOutOfItsRange_isNamed(int index, String name, String value) throws Exception {
    List<String> lines = new ArrayList<>(Files.readAllLines(written()));
    List<String> fields = new ArrayList<>(EntryFields.of(taken(1)));
    fields.set(index, value);
    lines.set(2, new JournalLine(3, "ping", fields).text().strip());
    checkDamaged(lines, ":3: " + name + ": '" + value + "' is n");
  }

  /** Nor is it taken for a torn line where it is the last one. */
  @ParameterizedTest
  @CsvSource(
      quoteCharacter = '`',
      value = {
        "ping, , `time_s: '' is not a number`",
        "ping, 1.5, `bearing: is missing`",
        "done, 1.5, `bearing: '1.5' is not a whole number in [0, 3599]`",
        "undone, -1, `bearing: '-1' is not a whole number`",
        "repeated, x, `bearing: 'x' is not a whole number`",
        "note, 5, `note: is missing`",
        "sung, 5, `kind: 'sung' is not a kind of entry`"
      })
  void lastLineThatSaysNothing_isNamed(String kind, String field, String message) throws Exception {
    List<String> lines = new ArrayList<>(Files.readAllLines(written()));
    String told = field == null ? "" : field;
    lines.set(lines.size() - 1, new JournalLine(lines.size(), kind, List.of(told)).text().strip());
    checkDamaged(lines, ":" + lines.size() + ": " + message);
  }

  /** The first line says how many there are. */
  @Test
  void bearingThatTheCaptureDoesNotHave_isNamed() throws Exception {
    Entry.Begun begun = new Entry.Begun(Map.of("bearings", "12"));
    List<String> lines =
        List.of(begun.line(1).text().strip(), new Entry.Done(12).line(2).text().strip());
    checkDamaged(lines, ":2: bearing: '12' is not a whole number in [0, 11]");
  }

  @ParameterizedTest
  @CsvSource({
    "bearings, 3.5, bearings: '3.5' is not a whole number",
    "bearings, many, bearings: 'many' is not a number",
    "pings, 1e9, pings = 1.0E9 is not in",
    "step_m, NaN, stepM = NaN is not in",
    "far_m, 1e5, farM = 100000.0 is not in",
    "temperature_c, 1e9, temperatureC = 1.0E9 is not in",
    "mode, loud, mode = 'loud' is none"
  })
  void settingOutOfItsRange_isNamed(String name, String value, String message) throws Exception {
    Map<String, String> settings = new LinkedHashMap<>(SETTINGS.entry().settings());
    settings.put(name, value);
    Path file = folder.resolve("begun");
    Journal.create(file, new Entry.Begun(settings)).close();
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> CapturedReadings.of(file));
    assertTrue(String.valueOf(fault.getMessage()).contains(message), fault.getMessage());
  }

  @Test
  void settingOnTwoLines_isNamed() throws Exception {
    JournalLine line = new JournalLine(1, "begun", List.of("obstacle=a\rb"));
    Path file = Files.writeString(folder.resolve("two"), line.text());
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> JournalEntries.text(file));
    assertTrue(
        String.valueOf(fault.getMessage()).contains(":1: begun: 'obstacle=a b' is not NAME=TEXT"),
        fault.getMessage());
  }

  private void checkDamaged(List<String> lines, String message) throws IOException {
    Path file = Files.write(folder.resolve("damaged"), lines);
    DataFormatException fault =
        assertThrows(DataFormatException.class, () -> JournalEntries.text(file));
    assertTrue(String.valueOf(fault.getMessage()).contains(message), fault.getMessage());
  }

  @Test
  void secondWriter_isRefused() throws Exception {
    Path file = written();
    JournalText text = JournalEntries.text(file);
    try (Journal held = Journal.resume(text)) {
      assertThrows(IOException.class, () -> Journal.resume(text));
      held.append(List.of(taken(1)));
    }
    assertThrows(DataFormatException.class, () -> Journal.resume(text), "it grew");
    assertThrows(IOException.class, () -> Journal.create(file, BEGUN));
  }

  @Test
  void fullDisk_isSaidAndNothingMoreIsWritten() throws Exception {
    Path full = Files.createSymbolicLink(folder.resolve("full"), Path.of("/dev/full"));
    JournalText text = new JournalText(full, BEGUN, 1, 0, "", "");
    try (Journal journal = Journal.resume(text)) {
      IOException fault = assertThrows(IOException.class, () -> journal.append(List.of(taken(1))));
      assertTrue(String.valueOf(fault.getMessage()).contains("full: cannot be written"));
      IOException again = assertThrows(IOException.class, () -> journal.append(List.of(taken(1))));
      assertTrue(String.valueOf(again.getMessage()).contains("nothing more is written"));
    }
  }

  /** The names are known before: what somebody left there is not followed. */
  @Test
  void linksThatWereLeftThere_areNotFollowed() throws Exception {
    Path theirs = Files.writeString(folder.resolve("theirs"), "theirs");
    Path file = folder.resolve("new.txt");
    Files.createSymbolicLink(Journal.beginning(file), theirs);
    assertThrows(IOException.class, () -> Journal.create(file, BEGUN));
    Files.delete(Journal.beginning(file));
    Journal.create(file, BEGUN).close();
    Files.createSymbolicLink(folder.resolve("new.txt.torn"), theirs);
    String whole = Files.readString(file);
    Files.writeString(file, whole + "torn");
    JournalText text = JournalText.read(file, entry -> {});
    assertThrows(IOException.class, () -> Journal.resume(text));
    assertEquals("theirs", Files.readString(theirs));
  }
}
