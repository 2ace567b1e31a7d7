package simbad.bench.protocol;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.format.DataFormatException;

class ProtocolTableTest {
  private static final ProtocolTable TABLE = ProtocolTable.shipped();

  @Test
  void commands_haveTheirBytes() {
    assertEquals('p', TABLE.command("period"));
    assertEquals('i', TABLE.command("identify"));
    assertThrows(IllegalArgumentException.class, () -> TABLE.command("dance"));
  }

  @Test
  void statuses_areTheEnums() {
    List<String> words =
        TABLE.entries().stream()
            .filter(entry -> entry.kind() == ProtocolTable.Kind.STATUS)
            .map(ProtocolTable.Entry::word)
            .toList();
    assertEquals(Arrays.stream(PingStatus.values()).map(PingStatus::word).toList(), words);
  }

  @Test
  void find_byWhatGoesOverTheLine() {
    assertEquals("bad-period", TABLE.find(ProtocolTable.Kind.ANSWER, "17").orElseThrow().word());
    assertTrue(TABLE.find(ProtocolTable.Kind.RESET, "17").isEmpty());
  }

  @Test
  void entries_areUniqueAndExplained() {
    var seen = new HashSet<String>();
    for (ProtocolTable.Entry entry : TABLE.entries()) {
      assertTrue(seen.add(entry.kind() + entry.code()), entry.toString());
      assertTrue(entry.meaning().length() > 10, entry.toString());
    }
  }

  @Test
  void parse_unknownKind_isRefused() {
    DataFormatException fault =
        assertThrows(
            DataFormatException.class,
            () -> ProtocolTable.parse(Path.of("p.csv"), "kind,code,word,meaning\nstatue,1,a,b\n"));
    assertTrue(String.valueOf(fault.getMessage()).startsWith("p.csv:2: kind: "));
  }
}
