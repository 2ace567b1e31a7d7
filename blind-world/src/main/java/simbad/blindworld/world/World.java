package simbad.blindworld.world;

import java.util.ArrayList;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * A set-up with the changes that are at work in it. It hears a recording's pings one after another,
 * by chance; what can be computed before, the geometry, is computed once per recording.
 */
public final class World {

  private final Sensor sensor;
  private final Setup setup;
  private final List<Change> changes;
  private final List<Body> bodies;

  /** The world of a scene, a set-up and changes, which act in the given order. */
  public World(Scene scene, Setup setup, List<? extends Change> changes) {
    this.sensor = scene.sensor();
    this.setup = setup;
    this.changes = List.copyOf(changes);
    List<Body> standing = scene.obstacles().stream().map(Body::of).toList();
    for (Change change : this.changes) {
      standing = change.bodies(standing);
    }
    bodies = List.copyOf(standing);
  }

  /** The world's view of a recording, ready to be heard any number of times. */
  public Listening at(Recording recording) {
    return new Listening(recording);
  }

  /** A recording before this world. */
  public final class Listening implements Repeats {

    private final Recording recording;
    private final List<Ping.Motion> motions;
    private final boolean restless;
    private List<Pose> poses = List.of();
    private List<List<Sight>> sights = List.of();

    private Listening(Recording recording) {
      this.recording = recording;
      motions = Motions.of(recording);
      restless = changes.stream().anyMatch(Change::restless);
      look(new Chance(0));
    }

    private void look(RandomGenerator random) {
      List<Pose> truth = recording.rows().stream().map(Row::pose).toList();
      for (Change change : changes) {
        truth = change.poses(recording, truth, random);
      }
      poses = truth;
      List<List<Sight>> seen = new ArrayList<>(recording.size());
      for (int row = 0; row < recording.size(); row++) {
        Beam beam = beam(recording.rows().get(row).sensor());
        List<Sight> before = new ArrayList<>(bodies.size());
        for (int b = 0; b < bodies.size(); b++) {
          before.add(bodies.get(b).seenFrom(poses.get(row), beam, b));
        }
        seen.add(before);
      }
      sights = seen;
    }

    /** Each row's obstacles, as this world has them. */
    public List<List<Sight>> sights() {
      return sights;
    }

    /** The chance that an obstacle is heard when no change acts on thresholds and echoes. */
    public double chance(int row, Sight sight) {
      Row believed = recording.rows().get(row);
      double threshold = setup.thresholdM(sight, beam(believed.sensor()).halfAngleRad());
      return hearable(sight, believed.tS()) ? chanceAt(threshold, sight) : 0;
    }

    @Override
    public double[] read(long seed) {
      Chance root = new Chance(seed);
      Chance chance = root.split();
      Chance changing = root.split();
      if (restless) {
        look(root.split());
      }
      double[] readings = new double[recording.size()];
      for (Track track : recording.tracks()) {
        List<Hearing> hearings =
            changes.stream().map(change -> change.hearing(recording, track, seed)).toList();
        Ping ping = new Ping(recording, changing, bodies.size());
        Luck luck = new Luck(chance, bodies.size());
        for (int k = 0; k < track.rows().size(); k++) {
          int row = track.rows().get(k);
          ping.begin(row, k, poses.get(row), motions.get(row));
          readings[row] = read(hearings, ping, luck);
          ping.end(readings[row]);
        }
      }
      return readings;
    }

    private double read(List<Hearing> hearings, Ping ping, Luck luck) {
      luck.draw(setup);
      double distance = nearest(hearings, ping, luck);
      for (Hearing hearing : hearings) {
        distance = hearing.echoM(distance, ping);
      }
      double reading = distance;
      if (reading < Double.POSITIVE_INFINITY) {
        reading = range(distance, hearings, ping, luck);
      }
      for (Hearing hearing : hearings) {
        reading = hearing.reportedM(reading, ping);
      }
      return reading;
    }

    private double range(double distanceM, List<Hearing> hearings, Ping ping, Luck luck) {
      double range = distanceM;
      for (Hearing hearing : hearings) {
        range = hearing.rangeM(range, ping);
      }
      range = Math.max(0, range + luck.noiseM());
      double step = sensor.resolutionM();
      double reading = step > 0 ? Math.floor(range / step) * step : range;
      for (Hearing hearing : hearings) {
        reading = hearing.steppedM(reading, range, ping);
      }
      return reading;
    }

    private double nearest(List<Hearing> hearings, Ping ping, Luck luck) {
      List<Sight> before = sights.get(ping.row());
      String name = recording.rows().get(ping.row()).sensor();
      double halfAngle = before.isEmpty() ? 0 : beam(name).halfAngleRad();
      boolean[] heard = new boolean[before.size()];
      for (int b = 0; b < heard.length; b++) {
        Sight sight = before.get(b);
        if (hearable(sight, ping.tS())) {
          double threshold = setup.thresholdM(sight, halfAngle);
          for (Hearing hearing : hearings) {
            threshold = hearing.thresholdM(threshold, sight, ping);
          }
          heard[b] = luck.uniform(b) < chanceAt(threshold, sight);
        }
      }
      return ping.nearest(before, heard);
    }
  }

  private Beam beam(String name) {
    Beam beam = new Beam(0, sensor.halfAngleRad() + setup.wideningRad());
    for (Change change : changes) {
      beam = change.beam(name, beam);
    }
    return beam;
  }

  private boolean hearable(Sight sight, double tS) {
    return sight.distanceM() >= sensor.minRangeM()
        && sight.distanceM() <= sensor.maxRangeM()
        && bodies.get(sight.body()).isThereAt(tS);
  }

  private double chanceAt(double thresholdM, Sight sight) {
    double beyondM = sight.centreM() - thresholdM;
    double share = beyondM == 0 ? 0 : beyondM / setup.edgeWidthM();
    return thresholdM > 0 ? (1 - setup.missRate()) / (1 + StrictMath.exp(share)) : 0;
  }
}
