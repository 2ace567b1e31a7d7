package simbad.kernel.drawing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;

/**
 * All that there is to see in a world: the objects, the light and the background. Light and
 * background stay as they are; objects may come, and say themselves when they change.
 */
public final class Stage {
  private final Rgb background;
  private final Lighting lighting;
  private final List<Visual> visuals = new ArrayList<>();
  private final List<Visual> visualsView = Collections.unmodifiableList(visuals);

  /**
   * Creates a stage without objects.
   *
   * @param background what is seen where nothing is
   * @param lighting the light
   */
  public Stage(Rgb background, Lighting lighting) {
    this.background = background;
    this.lighting = lighting;
  }

  /** Returns what is seen where nothing is. */
  public Rgb background() {
    return background;
  }

  /** Returns the light. */
  public Lighting lighting() {
    return lighting;
  }

  /** Adds an object, which is placed in the world's frame; one that is there already stays. */
  public void add(Visual visual) {
    if (!visuals.contains(visual)) {
      visuals.add(visual);
    }
  }

  /**
   * Returns the objects, in the order in which they were added, hidden ones included; none is ever
   * taken away. An unmodifiable view.
   */
  public List<Visual> visuals() {
    return visualsView;
  }
}
