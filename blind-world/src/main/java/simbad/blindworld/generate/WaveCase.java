package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.wavechange.WaveEffect;
import simbad.blindworld.wavesetup.Article;
import simbad.blindworld.wavesetup.Room;
import simbad.blindworld.wavesetup.User;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Repeats;
import simbad.blindworld.world.Sensor;

/**
 * A case of a world of waves as it was drawn and read.
 *
 * @param assignment what was asked
 * @param design "run" or "bench"
 * @param room what was there before the change
 * @param calibration what its user made of it
 * @param day the world on the day of the readings, before the change
 * @param effects what is at work
 * @param sheets what was read
 * @param oracle the world's own forecast of the sealed rows
 * @param figures how large things are
 */
record WaveCase(
    Plan.Assignment assignment,
    String design,
    Room room,
    User.Calibration calibration,
    WaveWorld.Parts day,
    List<WaveEffect> effects,
    Sheets sheets,
    Forecast oracle,
    Figures figures)
    implements DrawnWorld {

  /** The rows of the data set, those without the effects, and the fresh ones. */
  record Sheets(Case.Sheet readings, Case.Sheet reference, Case.Sheet sealed) {}

  /**
   * Gaps in centimetres, and what it took.
   *
   * @param sealed of the sealed rows
   * @param setupCm what the scene says against the reference
   * @param floorCm the unchanged world's own scatter on the reference
   * @param z by how many standard errors the true world forecasts the readings better than the
   *     unchanged one; 0 without effects
   * @param size of each effect, 1 for a practical one
   * @param draws how many draws it took
   */
  record Figures(
      Case.Gaps sealed, double setupCm, double floorCm, double z, List<Double> size, int draws) {}

  @Override
  public Repeats at(Recording rows) {
    return new WaveWorld(day, effects.stream().map(WaveEffect::alteration).toList()).at(rows);
  }

  @Override
  public CaseFiles.Content content() {
    return new CaseFiles.Content(
        assignment,
        calibration.scene(),
        sheets.readings(),
        Optional.of(sheets.reference()),
        sheets.sealed(),
        oracle,
        truth());
  }

  private Map<String, Object> truth() {
    Map<String, Object> named = new LinkedHashMap<>();
    for (WaveEffect effect : effects) {
      named.put(effect.name(), effect.parameters());
    }
    List<String> outside = named.keySet().stream().filter(n -> !Vocabulary.contains(n)).toList();
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("case", assignment.id());
    json.put("kind", assignment.kind().name().toLowerCase(Locale.ROOT));
    json.put("effects", named);
    json.put("outside_vocabulary", outside);
    json.put("public", named.keySet().stream().filter(Vocabulary::contains).toList());
    json.put("unknown", outside);
    json.put("accept", lists(together(true)));
    Set<Set<String>> also = new LinkedHashSet<>(effects.isEmpty() ? Set.of() : together(false));
    also.removeAll(together(true));
    json.put("also", lists(also));
    json.put("design", design);
    json.put("reference", true);
    json.put("rows", sheets.readings().recording().size());
    json.put("echo_share", sheets.readings().echoShare());
    json.put("no_echo_m", calibration.scene().noEchoM());
    json.put("draws", figures.draws());
    json.put("sizes", figures.size());
    json.put("z", figures.z());
    json.put("sealed_gap_nominal_m", figures.sealed().nominalCm() / 100);
    json.put("sealed_gap_oracle_m", figures.sealed().oracleCm() / 100);
    json.put("sealed_gap_unchanged_m", figures.sealed().setupCm() / 100);
    json.put("setup_gap_m", figures.setupCm() / 100);
    json.put("setup_floor_m", figures.floorCm() / 100);
    json.put(
        "kinds",
        room.articles().stream().map(a -> List.<Object>of(a.kind(), a.heightM())).toList());
    json.put("calibration", calibrated());
    return json;
  }

  private Map<String, Object> calibrated() {
    Sensor sensor = calibration.scene().sensor();
    Map<String, Object> json = new LinkedHashMap<>(calibration.notes());
    json.put("half", Math.toDegrees(sensor.halfAngleRad()));
    json.put("noise", sensor.rangeNoiseM());
    json.put("miss", sensor.missRate());
    json.put("edge", sensor.edgeWidthM());
    json.put("min", sensor.minRangeM());
    return json;
  }

  /** One name or set of names for each effect, in every way of choosing. */
  private Set<Set<String>> together(boolean accepted) {
    Set<Set<String>> all = new LinkedHashSet<>();
    all.add(Set.of());
    for (WaveEffect effect : effects) {
      Set<Set<String>> longer = new LinkedHashSet<>();
      for (Set<String> begun : all) {
        for (Set<String> names : accepted ? effect.accept() : effect.also()) {
          Set<String> both = new TreeSet<>(begun);
          both.addAll(names);
          longer.add(both);
        }
      }
      all = longer;
    }
    return all;
  }

  private static List<Object> lists(Iterable<Set<String>> sets) {
    List<Object> lists = new ArrayList<>();
    sets.forEach(set -> lists.add(set.stream().sorted().toList()));
    return lists;
  }

  /** A word for each article, for messages. */
  List<String> kinds() {
    return room.articles().stream().map(Article::kind).toList();
  }
}
