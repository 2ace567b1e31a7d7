package simbad.blindworld.generate;

import java.util.List;
import java.util.Optional;
import simbad.blindworld.effect.Effect;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Setup;

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
    int draws) {

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
