package simbad.experiments.batch;

import java.nio.file.Path;
import java.util.Optional;
import simbad.experiments.run.DiagnosedFolder;
import simbad.experiments.run.SensorKind;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.scene.SonarSpec;

/**
 * A sensor of a batch.
 *
 * @param where the spec names it
 * @param kind without further effects
 */
record SensorChoice(JsonInput where, SensorKind kind) {
  static final String DIMENSION = "sensors";

  /** What comes before the folder is cut off; empty for a sensor that is known by name. */
  static Optional<Path> folder(JsonInput where) throws DataFormatException {
    Optional<String> folder = DiagnosedFolder.in(where.text());
    return folder.isPresent()
        ? Optional.of(InputPlace.name(where, folder.get()))
        : Optional.empty();
  }

  static SensorChoice read(JsonInput where, int position, InputPlace place)
      throws DataFormatException {
    Optional<Path> folder = folder(where);
    if (folder.isPresent()) {
      Path path = place.of(DIMENSION, position, folder.get());
      String name = String.valueOf(folder.get().normalize().getFileName());
      return new SensorChoice(where, SensorKind.diagnosed(name, path));
    }
    return new SensorChoice(
        where,
        SensorKind.find(where.text())
            .orElseThrow(() -> where.isNot("one of " + SensorKind.words())));
  }

  /**
   * The sensor with effects at work: the noisy one is the nominal model, the shadow sensor the same
   * without its scatter. The others are other models, on which effects are not defined.
   */
  SensorKind with(EffectList effects, SonarSpec sonar, BatchScene scene)
      throws DataFormatException {
    if (effects.isEmpty()) {
      return kind;
    }
    boolean noisy = kind.equals(SensorKind.NOISY);
    if (!noisy && !kind.equals(SensorKind.SHADOW)) {
      throw where.fault(
          "effects act on the nominal model, so on the sensors shadow and noisy only");
    }
    SonarSpec figures = noisy ? sonar : sonar.withScatter(0, 0, 0);
    return SensorKind.of(kind.word(), effects.model(figures, scene));
  }
}
