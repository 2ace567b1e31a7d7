package simbad.gap.fit;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.predict.ChangedModel;

/**
 * The last few geometries of a log, by the changes that they depend on. Safe for use by several
 * threads: two that ask for the same find the same.
 */
final class Geometries {
  private static final int REMEMBERED = 6;

  private final Map<List<Change>, Geometry> known =
      new LinkedHashMap<>(2 * REMEMBERED, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<List<Change>, Geometry> eldest) {
          return size() > REMEMBERED;
        }
      };

  private final List<Change> plainly;
  private final Geometry plain;

  /** Where the first one is asked for. */
  private final @Nullable Geometries shared;

  /** Of which pings, null for all. */
  private final boolean @Nullable [] only;

  /**
   * Remembers nothing yet.
   *
   * @param plain geometry where nothing else is changed
   * @param calibration that it was computed with
   */
  Geometries(Geometry plain, List<Change> calibration) {
    this.plain = plain;
    plainly = deciding(calibration);
    shared = null;
    only = null;
  }

  private Geometries(Geometries shared, boolean @Nullable [] only) {
    plain = shared.plain;
    plainly = shared.plainly;
    this.shared = shared;
    this.only = only;
  }

  /**
   * Returns those of one fit, which begins somewhere that others may know as well.
   *
   * @param only the pings that count, null for all: what is left for others means nothing
   */
  Geometries ofFit(boolean @Nullable [] only) {
    return new Geometries(this, only);
  }

  private static List<Change> deciding(List<Change> changes) {
    return changes.stream().filter(Geometry::dependsOn).toList();
  }

  /** Returns the geometry of a model. */
  Geometry of(ChangedModel model) {
    List<Change> key = deciding(model.changes());
    if (key.equals(plainly)) {
      return plain;
    }
    Geometry before = known(key);
    if (before != null) {
      return before;
    }
    Geometry now = made(model, key);
    synchronized (known) {
      known.put(key, now);
    }
    return now;
  }

  private @Nullable Geometry known(List<Change> key) {
    synchronized (known) {
      return known.get(key);
    }
  }

  private Geometry made(ChangedModel model, List<Change> key) {
    Geometries first = shared;
    if (first == null || !isEmpty()) {
      return model.geometryLike(nearest(key), only);
    }
    if (only == null) {
      return first.of(model);
    }
    // Others begin there with all pings, if at all.
    Geometry whole = first.known(key);
    return whole == null ? model.geometryLike(first.nearest(key), only) : whole;
  }

  private boolean isEmpty() {
    synchronized (known) {
      return known.isEmpty();
    }
  }

  /** The geometry that depends on most of some changes; of equals the one that was asked last. */
  private Geometry nearest(List<Change> key) {
    Geometry nearest = plain;
    long most = 0;
    synchronized (known) {
      for (Map.Entry<List<Change>, Geometry> entry : known.entrySet()) {
        long shared = entry.getKey().stream().filter(key::contains).count();
        nearest = shared >= most ? entry.getValue() : nearest;
        most = Math.max(most, shared);
      }
    }
    return nearest;
  }
}
