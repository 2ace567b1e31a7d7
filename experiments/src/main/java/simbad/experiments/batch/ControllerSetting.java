package simbad.experiments.batch;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import simbad.experiments.control.Controller;
import simbad.experiments.control.ControllerMaker;
import simbad.experiments.run.Circuit;

/**
 * A kind of controller with a value for each of its parameters.
 *
 * @param maker of the kind
 * @param values by name, in the order of the parameters
 */
record ControllerSetting(ControllerMaker maker, Map<String, Double> values) {
  ControllerSetting {
    values = Collections.unmodifiableMap(new LinkedHashMap<>(values));
  }

  Controller controller(double speedMPerS) {
    return maker.make(speedMPerS, Circuit.STEP_S, values);
  }
}
