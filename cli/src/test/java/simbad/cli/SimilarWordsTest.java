package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SimilarWordsTest {
  private static final List<String> NAMES = List.of("square", "round", "angle", "half-round");

  @ParameterizedTest
  @CsvSource({
    "angel, angle",
    "ANGLE, angle",
    "squar, square",
    "half-rund, half-round",
    "rond, round",
    "zebra, ",
    "x, ",
    "roundabout, "
  })
  void find_mistypedName(String word, String name) {
    assertEquals(Optional.ofNullable(name), SimilarWords.find(word, NAMES));
  }

  @ParameterizedTest
  @CsvSource({"angel, '; did you mean angle?'", "zebra, ''"})
  void suggestion_isForTheEndOfASentence(String word, String suggestion) {
    assertEquals(suggestion, SimilarWords.suggestion(word, NAMES));
  }
}
