package simbad.sonar.model;

/**
 * A sensor model with a name for the command line: {@code --sensor NAME} of every command that
 * takes one, and {@code "sensors"} of a batch.
 *
 * <p>Found with {@link java.util.ServiceLoader}: a class that implements this interface, is public,
 * has a public constructor without parameters and stands in {@code
 * META-INF/services/simbad.sonar.model.NamedSensorModel} of its jar takes part.
 */
public interface NamedSensorModel extends SensorModel {
  /** Returns the name: letters, digits, dots, hyphens and underscores. */
  String name();

  /** Returns in a few words when this sensor hears an obstacle. */
  String meaning();
}
