package simbad.sonar.format;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class OneLineTest {
  @ParameterizedTest
  @ValueSource(strings = {"a\nb", "a \r\n  b", "a\u0000b", "a\u2028b", "a\tb", "a\u0085\u2029b"})
  void break_isABlank(String text) {
    assertEquals("a b", OneLine.of(text));
    assertFalse(OneLine.isName(text) || OneLine.isText(text));
  }

  @Test
  void blanksWithoutABreak_stay() {
    assertEquals(" a  b ", OneLine.of(" a  b "));
    assertTrue(OneLine.isName(" a  b "));
  }

  @Test
  void middle_isLeftOut() {
    assertEquals("abcdef", OneLine.of("abcdef", 6));
    assertEquals("ab...fg", OneLine.of("abcdefg", 5));
    assertEquals("a ... g", OneLine.of("a\ncde\ng", 4));
  }

  @Test
  void lengths_haveABound() {
    assertTrue(OneLine.isName("") && OneLine.isName("n".repeat(200)));
    assertFalse(OneLine.isName("n".repeat(201)));
    assertTrue(OneLine.isText("n".repeat(10_000)));
    assertFalse(OneLine.isText("n".repeat(10_001)));
  }

  /** Blanks by the million take no time to speak of. */
  @Test
  void manyBlanks_areNoTrouble() {
    String blanks = " ".repeat(1_000_000);
    assertEquals(blanks, OneLine.of(blanks));
    assertEquals(323, OneLine.of(blanks, 320).length());
  }
}
