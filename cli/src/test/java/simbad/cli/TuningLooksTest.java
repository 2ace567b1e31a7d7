package simbad.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.figures.plot.SeriesRole;

class TuningLooksTest {
  private static final List<String> SENSORS =
      List.of("diagnosed-a", "noisy", "original", "shadow", "diagnosed-b", "ray");

  /** Every number of sensors, with few curves each and with many. */
  @Test
  void noTwoSensorsShareAColour_noTwoCurvesTheirLooks() {
    for (int sensors = 1; sensors <= SENSORS.size(); sensors++) {
      for (int most = 1; most <= 8; most++) {
        check(counts(sensors, most));
      }
    }
  }

  /** One sensor has one curve only, as where its error is the same everywhere. */
  private static Map<String, Integer> counts(int sensors, int most) {
    Map<String, Integer> counts = new LinkedHashMap<>();
    SENSORS.subList(0, sensors).forEach(sensor -> counts.put(sensor, most));
    counts.replace("noisy", 1);
    return counts;
  }

  private static void check(Map<String, Integer> counts) {
    TuningLooks looks = new TuningLooks(counts);
    Map<SeriesRole, String> owners = new HashMap<>();
    Set<String> seen = new HashSet<>();
    counts.forEach(
        (sensor, count) -> {
          for (int i = 0; i < count; i++) {
            SeriesRole role = looks.role(sensor, i);
            assertEquals(sensor, owners.computeIfAbsent(role, any -> sensor), counts.toString());
            assertTrue(seen.add(role + " " + looks.pattern(sensor, i)), counts.toString());
          }
        });
  }

  /** As in every other picture. */
  @Test
  void firstCurve_hasItsSensorsColour() {
    TuningLooks looks = new TuningLooks(counts(6, 5));
    assertEquals(SeriesRole.ORIGINAL, looks.role("original", 0));
    assertEquals(SeriesRole.SHADOW, looks.role("shadow", 4));
    assertEquals(SeriesRole.NOISY, looks.role("noisy", 0));
    assertEquals(SeriesRole.RAY, looks.role("ray", 0));
  }
}
