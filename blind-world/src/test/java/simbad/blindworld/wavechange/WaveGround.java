package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.random.RandomGenerator;
import simbad.blindworld.wave.Air;
import simbad.blindworld.wave.Burst;
import simbad.blindworld.wave.Counter;
import simbad.blindworld.wave.Ear;
import simbad.blindworld.wave.Gear;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.Target;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.wave.WaveWorld;
import simbad.blindworld.wavesetup.Article;
import simbad.blindworld.wavesetup.Room;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Obstacle;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sensor;
import simbad.blindworld.world.Shadow;

/**
 * A room in round numbers: at 20 degrees sound goes 343.2 m/s; a box with a table stands at the
 * origin and a pole that is believed the same all round two metres to its right. What is heard is
 * 1.0, 1.1, ... 1.9 m.
 */
final class WaveGround {

  static final Air AIR = new Air(20, 50, 101.325);
  static final double SOUND_M_PER_S = 343.2;
  static final double BOX_TURN_RAD = 0.3;
  static final double HALF_M = 0.05;
  static final List<Point> CORNERS =
      List.of(
          new Point(-HALF_M, -HALF_M),
          new Point(HALF_M, -HALF_M),
          new Point(HALF_M, HALF_M),
          new Point(-HALF_M, HALF_M));
  static final Article BOX = new Article("box", CORNERS, Outline.of(CORNERS), 0.6);
  static final Article POLE = new Article("pole", CORNERS, Outline.round(0.03), 0.6);
  static final double MOUNT_M = 0.15;
  static final Target BOX_TARGET =
      new Target(BOX.outline(), BOX.upright(MOUNT_M), new Point(0, 0), BOX_TURN_RAD);
  static final Target POLE_TARGET =
      new Target(POLE.outline(), POLE.upright(MOUNT_M), new Point(2, 0), 0);
  static final Gear GEAR =
      new Gear(
          new Burst(40_000, 8, new Burst.Resonance(40_000, 18), new Burst.Resonance(40_000, 18), 0),
          new Gear.Pistons(0.008, 0.008, 0, 0),
          new Gear.Receiver(0.004, 0.04, 0.002, 0.0005, 0.02, 0.0004),
          0);
  static final WaveWorld.Parts PARTS =
      new WaveWorld.Parts(
          GEAR, AIR, new Counter(SOUND_M_PER_S, 0, 0, 0.01), 0.3, List.of(BOX_TARGET, POLE_TARGET));
  static final Room ROOM =
      new Room(
          PARTS,
          List.of(BOX, POLE),
          List.of(BOX_TARGET, POLE_TARGET),
          List.of(BOX_TURN_RAD, 0.0),
          MOUNT_M,
          4);
  static final Scene SCENE = scene(5);
  static final Recording ROUND = round();
  static final List<Double> HEARD = List.of(1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.7, 1.8, 1.9);

  private WaveGround() {}

  static Scene scene(double noEchoM) {
    Sensor sensor = new Sensor("s", 0.3, 0.02, 4, MOUNT_M, 343, 0.01, 0, 0, 1e-6, 0.1);
    Shadow table = new Shadow(List.of(1.0, 1.5, 2.0, 1.5));
    return new Scene(
        noEchoM,
        sensor,
        List.of(
            new Obstacle("box", new Point(0, 0), BOX_TURN_RAD, CORNERS, table),
            new Obstacle("pole", new Point(2, 0), 0, CORNERS, Shadow.uniform(2))));
  }

  /** Eight places around the box, 0.8 m away, looking at it, and one that looks at the pole. */
  private static Recording round() {
    List<Row> rows = new ArrayList<>();
    for (int k = 0; k < 8; k++) {
      double angle = k * Math.PI / 4 + 0.1;
      Pose pose = new Pose(-0.8 * Math.cos(angle), 0.8 * Math.sin(angle), angle);
      rows.add(new Row("r", "s", 0.25 * k, pose));
    }
    rows.add(new Row("r", "s", 2, new Pose(1.1, 0.05, 0)));
    return new Recording(rows);
  }

  static Site site(RandomGenerator chance, double size) {
    return new Site(ROOM, PARTS, SCENE, ROUND, true, HEARD, chance, size);
  }

  /** A change of a size with the middle of every chance, and the upper one of two. */
  static WaveEffect draw(String name, double size) {
    return draw(name, size, new FixedChance(0.5));
  }

  static WaveEffect draw(String name, double size, RandomGenerator chance) {
    return WaveVocabulary.draw(name, site(chance, size));
  }

  static double number(WaveEffect effect, String name) {
    Object value = Objects.requireNonNull(effect.parameters().get(name), name);
    return Double.parseDouble(value.toString());
  }

  static Ear ear(WaveEffect effect) {
    return effect.alteration().ear(ROUND, ROUND.tracks().get(0), 1);
  }

  static Gear gear(WaveEffect effect) {
    return effect.alteration().gear("s", GEAR);
  }

  static WavePing ping(RandomGenerator chance, int index, double tS) {
    return new WavePing(chance, index, tS, 0);
  }

  /** A ping after a share of the recording. */
  static WavePing after(double share) {
    return new WavePing(new FixedChance(0.5), 0, 0, share);
  }

  /** A change does the same to echoes as other things that stand there. */
  static void assertSounds(List<? extends Reflector> expected, WaveEffect effect) {
    WaveWorld.Listening before = new WaveWorld(PARTS.with(expected), List.of()).at(ROUND);
    WaveWorld.Listening after =
        site(new FixedChance(0.5), 1).listening(List.of(effect.alteration()));
    for (int row = 0; row < ROUND.size(); row++) {
      assertEquals(before.excessDb(row), after.excessDb(row), 1e-6, "row " + row);
    }
  }
}
