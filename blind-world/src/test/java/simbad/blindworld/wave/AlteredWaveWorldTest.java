package simbad.blindworld.wave;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.DoubleUnaryOperator;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Track;

/** What alterations do to a world whose one echo is of a known level at a known time. */
class AlteredWaveWorldTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final Air AIR = new Air(20, 50, 101.325);
  private static final Burst.Resonance RESONANCE = new Burst.Resonance(40_000, 18);
  private static final Gear GEAR =
      new Gear(
          new Burst(40_000, 8, RESONANCE, RESONANCE, 0),
          new Gear.Pistons(0.008, 0.008, 0, 0),
          new Gear.Receiver(1, 1, 1, 0.0005, 0.02, 1e-6),
          0);

  /** 233 whole cycles after the trigger: 0.9995 m away. */
  private static final double AWAY_M = 233 * 343.2 / 80_000;

  private static WaveWorld.Parts parts(double excessDb, double resolutionM) {
    return new WaveWorld.Parts(
        GEAR,
        AIR,
        new Counter(343.2, 0, 0, resolutionM),
        0,
        List.of(new FixedEcho(AWAY_M, excessDb, 0)));
  }

  private static Recording rows() {
    return new Recording(
        List.of(
            new Row("a", "s", 0, new Pose(0, 0, 0)),
            new Row("a", "t", 0.5, new Pose(0, 0, 0)),
            new Row("a", "s", 1, new Pose(0, 0, 0)),
            new Row("b", "s", 2, new Pose(0, 0, 0))));
  }

  private static WaveWorld.Listening listening(double excessDb, Alteration... alterations) {
    return new WaveWorld(parts(excessDb, 0), List.of(alterations)).at(rows());
  }

  private static Alteration louder(String sensor, double db) {
    return new Alteration() {
      @Override
      public Gear gear(String name, Gear gear) {
        return name.equals(sensor) ? gear.louder(db) : gear;
      }
    };
  }

  /** The level is that of the echo, row by row, with what the alterations do to its sonar. */
  @Test
  void excess_isOfEachRow() {
    WaveWorld.Listening listening = listening(6, louder("t", 3), louder("t", 4));
    assertEquals(6, listening.excessDb(0), 1e-6);
    assertEquals(13, listening.excessDb(1), 1e-6);
    assertEquals(6, listening.excessDb(3), 1e-6);
    double standing =
        new WaveWorld(parts(6, 0), List.of(louder("", 2))).standing(new Pose(0, 0, 0)).excessDb();
    assertEquals(8, standing, 1e-6);
  }

  /** An echo far over the threshold is found in its first cycles. */
  @Test
  void echo_isReadWhereItIs() {
    double[] read = listening(30).read(1);
    for (double reading : read) {
      assertEquals(AWAY_M, reading, 0.02);
      assertTrue(reading > AWAY_M);
    }
    assertEquals(NONE, listening(-30).read(1)[0]);
    assertEquals(NONE, listening(30, louder("s", -60)).read(1)[0]);
  }

  /** Things that scatter in level by themselves, and air that does, are heard now and then. */
  @Test
  void scatter_isOfTheAirAndOfThings() {
    assertEquals(0, heard(-3, 0, 0));
    assertTrue(heard(-3, 3, 0) > 5);
    assertTrue(heard(-3, 0, 3) > 5);
    // A level of 4 standard deviations under the threshold is out of reach.
    assertEquals(0, heard(-13, 3, 0));
    assertEquals(100, heard(13, 3, 0));
    // Of 3 and 4 dB together 5 dB: at 5 dB under the threshold one in six.
    assertEquals(16, heard(-5, 3, 4), 12);
  }

  private static int heard(double excessDb, double airDb, double thingDb) {
    WaveWorld.Parts parts =
        new WaveWorld.Parts(
            GEAR,
            AIR,
            new Counter(343.2, 0, 0, 0),
            airDb,
            List.of(new FixedEcho(AWAY_M, excessDb, thingDb)));
    WaveWorld.Standing standing = new WaveWorld(parts, List.of()).standing(new Pose(0, 0, 0));
    Chance random = new Chance(3);
    int heard = 0;
    for (int i = 0; i < 100; i++) {
      heard += standing.arrivalS(random) < NONE ? 1 : 0;
    }
    return heard;
  }

  private static Alteration ear(DoubleUnaryOperator each, double louderDb, double headroomDb) {
    return new Alteration() {
      @Override
      public double headroomDb() {
        return headroomDb;
      }

      @Override
      public Ear ear(Recording recording, Track track, long repeatSeed) {
        return new Ear() {
          @Override
          public double louderDb(WavePing ping) {
            return louderDb;
          }

          @Override
          public double arrivalS(double arrivalS, WavePing ping) {
            return each.applyAsDouble(arrivalS);
          }

          @Override
          public double rangeM(double rangeM, WavePing ping) {
            return each.applyAsDouble(rangeM);
          }

          @Override
          public double steppedM(double readingM, double rangeM, WavePing ping) {
            return each.applyAsDouble(readingM);
          }

          @Override
          public double reportedM(double readingM, WavePing ping) {
            return each.applyAsDouble(readingM);
          }
        };
      }
    };
  }

  /** Twice and half more, in that order, at the arrival, the range, the step and the report. */
  @Test
  void ears_actInTheirOrder() {
    double plain = listening(30).read(1)[0];
    double arrival = 2 * plain / 343.2;
    double read = listening(30, ear(x -> 2 * x, 0, 0), ear(x -> x + 0.5, 0, 0)).read(1)[0];
    double range = (2 * arrival + 0.5) * 343.2 / 2;
    assertEquals(8 * range + 4 * 0.5 + 2 * 0.5 + 0.5, read, 1e-6);
  }

  /** What an ear makes louder is heard as far as its alteration has said that it may. */
  @Test
  void louderPings_needHeadroom() {
    assertEquals(NONE, listening(-15, ear(x -> x, 30, 0)).read(1)[0]);
    assertTrue(listening(-15, ear(x -> x, 30, 30)).read(1)[0] < NONE);
    assertTrue(listening(-15, ear(x -> x, 15, 15), ear(x -> x, 15, 15)).read(1)[0] < NONE);
    assertEquals(NONE, listening(15, ear(x -> x, -30, 0)).read(1)[0]);
  }

  /** Not below nothing, and in whole steps. */
  @Test
  void ranges_areStepped() {
    WaveWorld.Listening stepped = new WaveWorld(parts(30, 0.05), List.of()).at(rows());
    assertEquals(1, stepped.read(1)[0], 1e-9);
    Alteration below =
        new Alteration() {
          @Override
          public Ear ear(Recording recording, Track track, long repeatSeed) {
            return new Ear() {
              @Override
              public double rangeM(double rangeM, WavePing ping) {
                return -3;
              }
            };
          }
        };
    assertEquals(0, listening(30, below).read(1)[0]);
  }

  /** Which ping it is: how many came before of its track, when, and after which share of all. */
  @Test
  void ping_knowsWhereItIs() {
    List<String> pings = new ArrayList<>();
    List<String> tracks = new ArrayList<>();
    Alteration looks =
        new Alteration() {
          @Override
          public Ear ear(Recording recording, Track track, long repeatSeed) {
            tracks.add(track.run() + track.sensor() + repeatSeed);
            return new Ear() {
              @Override
              public double reportedM(double readingM, WavePing ping) {
                pings.add(ping.indexInTrack() + " " + ping.tS() + " " + ping.share());
                return readingM;
              }
            };
          }
        };
    listening(30, looks).read(7);
    assertEquals(List.of("as7", "at7", "bs7"), tracks);
    assertEquals(List.of("0 0.0 0.0", "1 1.0 0.5", "0 0.5 0.25", "0 2.0 0.75"), pings);
  }

  /** Air, scatter, things and poses are those of the alterations, one after the other. */
  @Test
  void world_isMadeByItsAlterations() {
    List<String> asked = new ArrayList<>();
    Alteration all =
        new Alteration() {
          @Override
          public Air air(Air air) {
            return air.warmer(10);
          }

          @Override
          public double scatterDb(double scatterDb) {
            asked.add("scatter " + scatterDb);
            return scatterDb + 1;
          }

          @Override
          public List<Reflector> reflectors(List<Reflector> reflectors) {
            asked.add("things " + reflectors.size());
            List<Reflector> more = new ArrayList<>(reflectors);
            more.add(new FixedEcho(0.5, 30, 0));
            return more;
          }

          @Override
          public List<Pose> poses(Recording recording, List<Pose> poses) {
            asked.add("poses " + poses.get(0).xM());
            return poses.stream().map(p -> p.at(p.xM() + 1, 0)).toList();
          }
        };
    double[] read = listening(30, all, all).read(1);
    assertEquals(
        List.of("scatter 0.0", "things 1", "scatter 1.0", "things 2", "poses 0.0", "poses 1.0"),
        asked);
    double speed = AIR.warmer(20).soundSpeedMPerS();
    // The nearer thing is found earlier in warm air, and converted with the speed of cold air.
    assertEquals(0.5 * 343.2 / speed, read[0], 0.02);
  }

  @Test
  void alterationOfNothing_leavesAll() {
    Alteration nothing = new Alteration() {};
    assertSame(GEAR, nothing.gear("s", GEAR));
    assertSame(AIR, nothing.air(AIR));
    assertEquals(2, nothing.scatterDb(2));
    assertEquals(List.of(), nothing.reflectors(List.of()));
    assertEquals(0, nothing.headroomDb());
    List<Pose> poses = List.of(new Pose(1, 2, 3));
    assertSame(poses, nothing.poses(rows(), poses));
    Ear ear = nothing.ear(rows(), rows().tracks().get(0), 1);
    WavePing ping = new WavePing(new FixedChance(0.5), 0, 0, 0);
    double[] same = {
      ear.louderDb(ping),
      ear.arrivalS(1, ping),
      ear.rangeM(2, ping),
      ear.steppedM(3, 9, ping),
      ear.reportedM(4, ping),
    };
    assertArrayEquals(new double[] {0, 1, 2, 3, 4}, same);
    assertArrayEquals(listening(30).read(5), listening(30, nothing).read(5));
  }

  @Test
  void parts_areChangedInOneThing() {
    WaveWorld.Parts parts = parts(6, 0);
    Air warm = AIR.warmer(5);
    assertEquals(warm, parts.in(warm).air());
    assertEquals(parts.counter(), parts.in(warm).counter());
    Counter counter = new Counter(340, 0, 0, 0);
    assertEquals(counter, parts.with(counter).counter());
    assertEquals(AIR, parts.with(counter).air());
    List<FixedEcho> others = List.of(new FixedEcho(1, 2, 3));
    assertEquals(others, parts.with(others).reflectors());
    assertEquals(0, parts.with(others).scatterDb());
    assertFalse(parts.reflectors().equals(others));
    assertNotEquals(listening(30).read(5)[0], listening(30).read(6)[0]);
  }
}
