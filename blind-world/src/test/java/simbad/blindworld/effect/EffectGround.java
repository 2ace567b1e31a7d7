package simbad.blindworld.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.random.RandomGenerator;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Shadow;
import simbad.blindworld.world.Sight;
import simbad.blindworld.world.TestWorlds;

/**
 * A scene in round numbers: two transducers of a robot hear a post, which is believed the same all
 * round, at 1.0 to 1.9 m, each five times, once a second; a box with a table is far away.
 */
final class EffectGround {

  static final Sensor SENSOR = new Sensor("ranger", 0.3, 0.02, 4, 0.15, 343, 0.01, 0, 0, 1e-6, 0.1);
  static final Obstacle POST = TestWorlds.post("post", 0, 0, 3);
  static final Obstacle BOX =
      new Obstacle(
          "box",
          new Point(0, 50),
          0,
          List.of(new Point(-0.1, -0.1), new Point(0.1, -0.1), new Point(0, 0.1)),
          new Shadow(List.of(1.0, 2.0, 1.5)));
  static final Scene SCENE = new Scene(5, SENSOR, List.of(POST, BOX));
  static final Recording ROWS = rows();

  private EffectGround() {}

  private static Recording rows() {
    List<Row> rows = new ArrayList<>();
    for (int k = 0; k < 10; k++) {
      Pose pose = new Pose(-1.02 - 0.1 * k, 0, 0);
      rows.add(new Row("r", k < 5 ? "s" : "t", k % 5, pose));
    }
    return new Recording(rows);
  }

  static Circumstances circumstances(RandomGenerator chance, double strength) {
    return new Circumstances(SCENE, ROWS, true, chance, strength);
  }

  /** An effect of a size, with chance that always says the upper one and the middle. */
  static Effect draw(String name, String form, double strength) {
    return draw(name, form, strength, new FixedChance(0.5));
  }

  static Effect draw(String name, String form, double strength, RandomGenerator chance) {
    return Vocabulary.draw(name, form, circumstances(chance, strength));
  }

  /** Chance that says the lower one. */
  static FixedChance down() {
    return new FixedChance(0.5).coins(false);
  }

  static double number(Effect effect, String name) {
    Object value = Objects.requireNonNull(effect.parameters().get(name), name);
    return Double.parseDouble(value.toString());
  }

  /** What it does to the pings of the first transducer. */
  static Hearing hearing(Effect effect) {
    return effect.change().hearing(ROWS, ROWS.tracks().get(0), 7);
  }

  /** One before the axis of a transducer. */
  static Sight sight(double bearingRad, double distanceM, double offAxisRad) {
    return new Sight(0, distanceM, bearingRad, distanceM, offAxisRad, 3);
  }
}
