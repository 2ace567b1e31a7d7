package simbad.blindworld.score;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A diagnosis may know effects that the vocabulary lacks, as those of somebody's jar. */
class KnownNamesTest {
  @TempDir
  @SuppressWarnings("NullAway.Init")
  private Path folder;

  @BeforeEach
  void write() throws Exception {
    Path one = Files.createDirectories(folder.resolve("ramp"));
    Files.writeString(
        one.resolve("truth.json"), "{\"effects\": {\"slow-ramp\": {}}, \"no_echo_m\": 4}");
    Files.writeString(
        one.resolve("sealed.csv"),
        "run,sensor,t_s,x_m,z_m,heading_deg,range_m\nr,s,0,1,0,180,0.98\n");
  }

  private Truth read(Set<String> withheld, Set<String> known) throws Exception {
    return new Truths(folder, withheld, known).read().get(0);
  }

  @Test
  void nameThatIsKnown_isAskedFor_oneThatIsNot_isOutside() throws Exception {
    assertEquals("outside", read(Set.of(), Set.of()).kind());
    Truth known = read(Set.of(), Set.of("slow-ramp"));
    assertEquals("single", known.kind());
    assertEquals(Verdict.EXPLAINED, known.verdict());
  }

  @Test
  void nameThatIsKnownAndWithheld_isStrange() throws Exception {
    assertEquals(Verdict.UNEXPLAINED, read(Set.of("slow-ramp"), Set.of("slow-ramp")).verdict());
  }
}
