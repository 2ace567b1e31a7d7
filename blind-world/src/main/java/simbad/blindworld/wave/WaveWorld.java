package simbad.blindworld.wave;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;
import simbad.blindworld.check.Checks;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Repeats;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Track;

/**
 * A sonar, the air and what stands in it, with the alterations that are at work. Echoes are
 * computed once for each row; by chance come the air's flicker, noise, and what alterations do.
 */
public final class WaveWorld {

  /** Air that flickers by so many standard deviations is reckoned with. */
  private static final double RARE = 4;

  private static final double FLICKER_RAD = 0.15;

  private final Gear gear;
  private final Air air;
  private final Counter counter;
  private final double scatterDb;
  private final List<Reflector> reflectors;
  private final List<Alteration> alterations;
  private final double headroomDb;
  private final Map<String, Medium> media = new HashMap<>();
  private final Map<String, Detector> detectors = new HashMap<>();

  /**
   * What a world is made of.
   *
   * @param gear every transducer's
   * @param air on the day
   * @param counter as its user set it
   * @param scatterDb by which the air scatters an echo's level from ping to ping
   * @param reflectors the scene's obstacles, in its order, first
   */
  public record Parts(
      Gear gear, Air air, Counter counter, double scatterDb, List<Reflector> reflectors) {

    /** Copies the list. */
    public Parts {
      Checks.notNegative("scatter", scatterDb);
      reflectors = List.copyOf(reflectors);
    }

    /** The same on a day with other air. */
    public Parts in(Air other) {
      return new Parts(gear, other, counter, scatterDb, reflectors);
    }

    /** The same with another counter. */
    public Parts with(Counter other) {
      return new Parts(gear, air, other, scatterDb, reflectors);
    }

    /** The same with other things around. */
    public Parts with(List<? extends Reflector> others) {
      return new Parts(gear, air, counter, scatterDb, List.copyOf(others));
    }
  }

  /** The world of these parts with alterations, which act in the given order. */
  public WaveWorld(Parts parts, List<? extends Alteration> alterations) {
    this.alterations = List.copyOf(alterations);
    gear = parts.gear;
    counter = parts.counter;
    Air blown = parts.air;
    double scatter = parts.scatterDb;
    List<Reflector> standing = parts.reflectors;
    double room = 0;
    for (Alteration alteration : this.alterations) {
      blown = alteration.air(blown);
      scatter = alteration.scatterDb(scatter);
      standing = alteration.reflectors(standing);
      room += alteration.headroomDb();
    }
    air = blown;
    scatterDb = scatter;
    reflectors = List.copyOf(standing);
    double own = reflectors.stream().mapToDouble(Reflector::restlessDb).max().orElse(0);
    headroomDb = room + RARE * Math.max(own, scatterDb);
  }

  private Medium medium(String sensor) {
    return media.computeIfAbsent(
        sensor,
        name -> {
          Gear altered = gear;
          for (Alteration alteration : alterations) {
            altered = alteration.gear(name, altered);
          }
          return new Medium(altered, air);
        });
  }

  private Detector detector(String sensor) {
    return detectors.computeIfAbsent(sensor, name -> new Detector(medium(name).gear()));
  }

  private Sound sound(String sensor, Pose pose, double tS) {
    Medium medium = medium(sensor);
    List<Trace> echoes = new ArrayList<>();
    for (Reflector reflector : reflectors) {
      echoes.add(medium.drawn(reflector.arrivals(pose, medium, tS)));
    }
    return new Sound(echoes, detector(sensor), StrictMath.pow(10, headroomDb / 20));
  }

  /** A transducer that stands still, ready to ping any number of times. */
  public Standing standing(Pose pose) {
    return new Standing(sound("", pose, 0));
  }

  /** The world's view of a recording, ready to be heard any number of times. */
  public Listening at(Recording recording) {
    return new Listening(recording);
  }

  private double arrivalS(Sound sound, Detector detector, double louderDb, RandomGenerator random) {
    double alarm = detector.falseAlarmS(random);
    if (sound.size() == 0) {
      return alarm;
    }
    Complex[] factors = new Complex[reflectors.size()];
    for (int r = 0; r < factors.length; r++) {
      double spread = StrictMath.hypot(scatterDb, reflectors.get(r).restlessDb());
      double db = louderDb + spread * Math.max(-RARE, Math.min(RARE, random.nextGaussian()));
      factors[r] = Complex.polar(StrictMath.pow(10, db / 20), FLICKER_RAD * random.nextGaussian());
    }
    return Math.min(alarm, detector.firstS(sound, factors, random));
  }

  /** A transducer before the world, without alterations that act on pings. */
  public final class Standing {

    private final Sound sound;

    private Standing(Sound sound) {
      this.sound = sound;
    }

    /** When an echo is detected after the trigger, in seconds; infinite for none. */
    public double arrivalS(RandomGenerator random) {
      return WaveWorld.this.arrivalS(sound, detector(""), 0, random);
    }

    /** The greatest level over the threshold, without noise, in decibels. */
    public double excessDb() {
      return sound.excessDb();
    }
  }

  /** A recording before this world. */
  public final class Listening implements Repeats {

    private final Recording recording;
    private final List<Sound> sounds = new ArrayList<>();

    private Listening(Recording recording) {
      this.recording = recording;
      List<Pose> poses = recording.rows().stream().map(Row::pose).toList();
      for (Alteration alteration : alterations) {
        poses = alteration.poses(recording, poses);
      }
      for (int row = 0; row < recording.size(); row++) {
        String sensor = recording.rows().get(row).sensor();
        sounds.add(sound(sensor, poses.get(row), recording.tS(row)));
      }
    }

    /** The greatest level of a row over the threshold, without noise, in decibels. */
    public double excessDb(int row) {
      return sounds.get(row).excessDb();
    }

    @Override
    public double[] read(long seed) {
      Chance random = new Chance(seed);
      double[] readings = new double[recording.size()];
      for (Track track : recording.tracks()) {
        List<Ear> ears = alterations.stream().map(a -> a.ear(recording, track, seed)).toList();
        for (int k = 0; k < track.rows().size(); k++) {
          int row = track.rows().get(k);
          WavePing ping =
              new WavePing(random, k, recording.tS(row), (double) row / recording.size());
          readings[row] = read(row, ears, ping);
        }
      }
      return readings;
    }

    private double read(int row, List<Ear> ears, WavePing ping) {
      double louder = 0;
      for (Ear ear : ears) {
        louder += ear.louderDb(ping);
      }
      Detector detector = detector(recording.rows().get(row).sensor());
      double arrival = arrivalS(sounds.get(row), detector, louder, ping.random());
      for (Ear ear : ears) {
        arrival = ear.arrivalS(arrival, ping);
      }
      double reading = arrival < Double.POSITIVE_INFINITY ? reading(arrival, ears, ping) : arrival;
      for (Ear ear : ears) {
        reading = ear.reportedM(reading, ping);
      }
      return reading;
    }

    private double reading(double arrivalS, List<Ear> ears, WavePing ping) {
      double range = counter.rangeM(arrivalS);
      for (Ear ear : ears) {
        range = Math.max(0, ear.rangeM(range, ping));
      }
      double reading = counter.steppedM(range);
      for (Ear ear : ears) {
        reading = ear.steppedM(reading, range, ping);
      }
      return reading;
    }
  }
}
