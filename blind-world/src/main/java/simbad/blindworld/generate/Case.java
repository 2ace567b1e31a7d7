package simbad.blindworld.generate;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import simbad.blindworld.effect.Effect;
import simbad.blindworld.effect.Vocabulary;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Repeats;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;
import simbad.blindworld.world.World;

/**
 * A case as it was drawn and read.
 *
 * @param assignment what was asked
 * @param design "run" or "bench"
 * @param scene what the simulator believes
 * @param setup the set-up's own physics
 * @param effects what is at work
 * @param readings the rows of the data set
 * @param reference rows without the effects, where the set-up is off
 * @param sealed fresh rows of the same world
 * @param oracle the world's own forecast of the sealed rows
 * @param gaps of the sealed rows, in centimetres
 * @param shown where sizes were asked for: what they are, and how plainly the effects show
 * @param draws how many draws it took until every effect showed
 */
record Case(
    Plan.Assignment assignment,
    String design,
    Scene scene,
    Setup setup,
    List<Effect> effects,
    Sheet readings,
    Optional<Sheet> reference,
    Sheet sealed,
    Forecast oracle,
    Gaps gaps,
    Optional<Shown> shown,
    int draws)
    implements DrawnWorld {

  @Override
  public Repeats at(Recording rows) {
    return new World(scene, setup, effects.stream().map(Effect::change).toList()).at(rows);
  }

  @Override
  public CaseFiles.Content content() {
    return new CaseFiles.Content(assignment, scene, readings, reference, sealed, oracle, truth());
  }

  private Map<String, Object> truth() {
    Map<String, Object> named = new LinkedHashMap<>();
    for (Effect effect : effects) {
      named.put(effect.name(), effect.parameters());
    }
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("case", assignment.id());
    json.put("kind", assignment.kind().name().toLowerCase(Locale.ROOT));
    json.put("effects", named);
    json.put(
        "outside_vocabulary",
        named.keySet().stream().filter(n -> !Vocabulary.contains(n)).toList());
    json.put("design", design);
    json.put("reference", reference.isPresent());
    json.put("rows", readings.recording().size());
    json.put("echo_share", readings.echoShare());
    json.put("no_echo_m", scene.noEchoM());
    json.put("draws", draws);
    shown.ifPresent(
        s -> {
          json.put("sizes", s.sizes());
          json.put("z", s.z());
        });
    json.put("setup", setup.toString());
    json.put("sealed_gap_nominal_cm", gaps.nominalCm());
    json.put("sealed_gap_setup_cm", gaps.setupCm());
    json.put("sealed_gap_oracle_cm", gaps.oracleCm());
    return json;
  }

  /**
   * How large effects are, and how plainly they show.
   *
   * @param sizes of each effect, 1 for a practical one
   * @param z standard errors by which the true world forecasts the readings better than without the
   *     effect that shows least; 0 without effects
   */
  record Shown(List<Double> sizes, double z) {
    /** Copies the list. */
    Shown {
      sizes = List.copyOf(sizes);
    }
  }

  /** Rows with what was read on them; an infinite reading is a no-echo. */
  record Sheet(Recording recording, List<Double> rangesM) {

    /** The share of rows with an echo. */
    double echoShare() {
      long echoes = rangesM.stream().filter(r -> r < Double.POSITIVE_INFINITY).count();
      return (double) echoes / rangesM.size();
    }
  }

  /**
   * Gaps of the sealed rows, in centimetres.
   *
   * @param nominalCm from what the scene says
   * @param setupCm from the set-up without effects
   * @param oracleCm from the world itself
   */
  record Gaps(double nominalCm, double setupCm, double oracleCm) {}
}
