package simbad.cli;

import java.util.Iterator;
import simbad.experiments.run.SensorKind;

/** The names of sensor models, for the shell to complete. */
final class SensorWords implements Iterable<String> {
  @Override
  public Iterator<String> iterator() {
    return SensorKind.all().stream().map(SensorKind::word).iterator();
  }
}
