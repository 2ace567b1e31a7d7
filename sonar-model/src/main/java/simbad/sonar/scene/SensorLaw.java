package simbad.sonar.scene;

import java.util.Optional;
import simbad.sonar.level.LevelFigures;

/**
 * By which law a sensor is believed to hear, and what is known of its level law.
 *
 * @param model that the scene says it believes; empty where it does not say
 * @param level what is known of the level law, whether it is believed or not
 */
public record SensorLaw(Optional<Model> model, LevelFigures level) {
  /** Nothing is said. */
  public static final SensorLaw UNSTATED = new SensorLaw(Optional.empty(), LevelFigures.NONE);

  /** The laws that a scene can name. */
  public enum Model {
    /** Heard in the cone up to the threshold: {@code simbad.sonar.model.NominalModel}. */
    THRESHOLD("threshold"),
    /** Heard where the echo is strong enough: {@code simbad.sonar.model.LevelModel}. */
    LEVEL("level");

    private final String word;

    Model(String word) {
      this.word = word;
    }

    /** Returns the name in files. */
    public String word() {
      return word;
    }
  }

  /** Tells whether the level model is believed. */
  public boolean isLevel() {
    return model.isPresent() && model.get() == Model.LEVEL;
  }
}
