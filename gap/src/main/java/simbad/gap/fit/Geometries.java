package simbad.gap.fit;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
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
  }

  private Geometries(Geometries shared) {
    plain = shared.plain;
    plainly = shared.plainly;
    this.shared = shared;
  }

  /** Returns those of one fit, which begins somewhere that others may know as well. */
  Geometries ofFit() {
    return new Geometries(this);
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
    Geometry like;
    synchronized (known) {
      Geometry before = known.get(key);
      if (before != null) {
        return before;
      }
      like = known.isEmpty() && shared != null ? null : nearest(key);
    }
    Geometry now =
        like == null ? Objects.requireNonNull(shared).of(model) : model.geometryLike(like);
    synchronized (known) {
      known.put(key, now);
    }
    return now;
  }

  /** The geometry that depends on most of some changes; of equals the one that was asked last. */
  private Geometry nearest(List<Change> key) {
    Geometry nearest = plain;
    long most = 0;
    for (Map.Entry<List<Change>, Geometry> entry : known.entrySet()) {
      long shared = entry.getKey().stream().filter(key::contains).count();
      nearest = shared >= most ? entry.getValue() : nearest;
      most = Math.max(most, shared);
    }
    return nearest;
  }
}
