package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

/** Sets of letters, each worth what a table says; what the table lacks is worth nothing. */
class ForwardSearchTest {
  private static final double WORTH = 5;

  private static final class Letters extends ForwardSearch<String, String, String> {
    private final Map<String, Double> table;
    private String settlesTo = "";

    Letters(Map<String, Double> table) {
      super(WORTH);
      this.table = table;
    }

    String run() {
      keep("");
      return built("", grown(""));
    }

    @Nullable String kept(String... letters) {
      return fits().get(Set.of(letters));
    }

    Set<Set<String>> met() {
      return fits().keySet();
    }

    private List<String> grown(String base) {
      List<String> all = new ArrayList<>();
      for (String letter : List.of("a", "b", "c", "d")) {
        if (!base.contains(letter)) {
          all.add(String.join("", new TreeSet<>(List.of((base + letter).split("")))));
        }
      }
      all.forEach(this::keep);
      return best(all);
    }

    @Override
    protected Collection<String> effects(String set) {
      return set.isEmpty() ? List.of() : List.of(set.split(""));
    }

    @Override
    protected double worth(String set) {
      return table.getOrDefault(set, 0.0);
    }

    @Override
    protected List<String> exchanged(String set) {
      return List.copyOf(effects(set));
    }

    @Override
    protected List<String> inPlaceOf(String set, String member) {
      return grown(set.replace(member, ""));
    }

    @Override
    protected String settled(String set) {
      return settlesTo.isEmpty() ? set : settlesTo;
    }

    @Override
    protected boolean isLast(String set) {
      return set.length() >= 3;
    }

    @Override
    protected List<String> beside(String set, List<String> added, String before) {
      return grown(set);
    }
  }

  /** The best single one soaks up what two others do together. */
  @Test
  void built_exchangesWhatSoakedUp() {
    Letters search = new Letters(Map.of("a", 20.0, "b", 12.0, "ab", 26.0, "bc", 40.0));
    assertEquals("bc", search.run());
    assertTrue(search.met().contains(Set.of("a", "b")));
  }

  @Test
  void built_stopsWhereNoMoreIsWorthIt() {
    assertEquals("a", new Letters(Map.of("a", 20.0, "ab", 25.0)).run());
    assertEquals("", new Letters(Map.of("a", 5.0)).run());
  }

  @Test
  void built_isNoLargerThanItMayBe() {
    Letters search = new Letters(Map.of("a", 20.0, "ab", 40.0, "abc", 60.0, "abcd", 90.0));
    assertEquals("abc", search.run());
  }

  /** Two that have the same letters in another order are one set: the better one stays. */
  @Test
  void keep_takesTheBetterOfOneSet() {
    Letters search = new Letters(Map.of("ab", 5.0, "ba", 7.0));
    search.keep("ab");
    search.keep("ba");
    assertEquals("ba", search.kept("a", "b"));
    search.keep("ab");
    assertEquals("ba", search.kept("a", "b"));
    Letters alike = new Letters(Map.of("ab", 5.0, "ba", 5.0));
    alike.keep("ba");
    alike.keep("ab");
    assertEquals("ba", alike.kept("a", "b"), "of equal ones the first");
    assertEquals(List.of("ba", "ab", "c"), search.best(List.of("c", "ab", "ba")));
  }

  /** What is added must be worth it beyond what the set had become, not before. */
  @Test
  void built_settlesBeforeItBuilds() {
    Letters search = new Letters(Map.of("a", 20.0, "ab", 26.0, "abc", 30.0));
    search.settlesTo = "d";
    assertEquals("d", search.run(), "nothing was worth it beside what it settled to");
  }
}
