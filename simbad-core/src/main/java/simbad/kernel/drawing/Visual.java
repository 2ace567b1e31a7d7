package simbad.kernel.drawing;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.function.Supplier;
import simbad.kernel.geometry.Placement;

/**
 * How one object looks and where it is, with the visuals of its parts. It belongs to the object,
 * which says when something changes; who draws it compares {@link #revision()} with the one drawn
 * last. The placement is shared with the object and is not part of the revision.
 *
 * <p>Not safe for use by several threads: read it while no step is under way.
 */
public final class Visual {
  private final Placement frameFromVisual;
  private final Supplier<List<Facets>> look;
  private final List<Visual> parts = new ArrayList<>();
  private final List<Visual> partsView = Collections.unmodifiableList(parts);
  private List<Facets> facets = List.of();
  private boolean present = true;
  private boolean stale = true;
  private long revision;

  /**
   * Creates a visual without parts.
   *
   * @param frameFromVisual where the object is in the frame that it stands in: the world, or the
   *     visual that it is part of; shared, not copied
   * @param look asked for the object's facets when they are first needed and after {@link
   *     #lookChanged()}
   */
  public Visual(Placement frameFromVisual, Supplier<List<Facets>> look) {
    this.frameFromVisual = frameFromVisual;
    this.look = look;
  }

  /** Returns where the object is now, in the world or in what it is part of; to be read only. */
  public Placement frameFromVisual() {
    return frameFromVisual;
  }

  /** Returns the object's own facets in its own frame, without those of its parts. */
  public List<Facets> facets() {
    if (stale) {
      stale = false;
      facets = List.copyOf(look.get());
    }
    return facets;
  }

  /** Says that the facets are not what they were. */
  public void lookChanged() {
    stale = true;
    revision++;
  }

  /** Returns a number that grows when the object's own facets or the list of its parts change. */
  public long revision() {
    return revision;
  }

  /** Shows the object with all of its parts, or hides it. */
  public void setPresent(boolean newPresent) {
    present = newPresent;
  }

  /** Returns true if the object is to be seen. */
  public boolean isPresent() {
    return present;
  }

  /** Adds a part, which moves with this object. */
  public void add(Visual part) {
    parts.add(part);
    revision++;
  }

  /** Returns the parts, in the order in which they were added; an unmodifiable view. */
  public List<Visual> parts() {
    return partsView;
  }
}
