package simbad.scene3d;

import java.util.Collections;
import java.util.EnumSet;
import java.util.Set;

/**
 * How a scene is shown. Immutable.
 *
 * @param dark whether floor and background are dark, unless the program has chosen their colours
 * @param layers what is drawn besides the world itself
 */
public record Look(boolean dark, Set<Layer> layers) {
  /** Light, with all layers. */
  public static final Look LIGHT = new Look(false, EnumSet.allOf(Layer.class));

  /** Copies the layers. */
  public Look {
    layers = layers.isEmpty() ? Set.of() : Collections.unmodifiableSet(EnumSet.copyOf(layers));
  }

  /** Returns the same layers on a dark or a light floor. */
  public Look withDark(boolean wanted) {
    return new Look(wanted, layers);
  }

  /** Returns this look with a layer that is drawn or left out. */
  public Look with(Layer layer, boolean drawn) {
    Set<Layer> changed = EnumSet.noneOf(Layer.class);
    changed.addAll(layers);
    if (drawn) {
      changed.add(layer);
    } else {
      changed.remove(layer);
    }
    return new Look(dark, changed);
  }

  /** Returns true if a layer is drawn. */
  public boolean draws(Layer layer) {
    return layers.contains(layer);
  }
}
