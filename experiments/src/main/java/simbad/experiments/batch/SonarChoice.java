package simbad.experiments.batch;

import java.util.Optional;
import simbad.obstacles.Catalogue;
import simbad.sonar.scene.SonarSpec;

/**
 * Figures of a sonar.
 *
 * @param label how a row names them
 * @param spec of a file; empty: those of the scene, or of the SRF04
 */
record SonarChoice(String label, Optional<SonarSpec> spec) {
  static final SonarChoice OWN = new SonarChoice("", Optional.empty());

  SonarSpec in(BatchScene scene) {
    return spec.or(scene::sonar).orElseGet(Catalogue::srf04);
  }
}
