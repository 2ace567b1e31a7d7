package simbad.cli;

import java.util.Iterator;
import simbad.definition.Effect;
import simbad.sonar.effect.Definitions;

/** The names of effects, for the shell to complete. */
final class EffectWords implements Iterable<String> {
  @Override
  public Iterator<String> iterator() {
    return Definitions.effects().stream().map(Effect::word).iterator();
  }
}
