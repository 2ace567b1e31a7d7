package simbad.experiments.cli;

import java.util.Iterator;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Effect;

/** The names of effects, for the shell to complete. */
final class EffectWords implements Iterable<String> {
  @Override
  public Iterator<String> iterator() {
    return Definitions.effects().stream().map(Effect::word).iterator();
  }
}
