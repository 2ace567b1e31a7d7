package simbad.blindworld.effect;

import java.util.function.Supplier;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Hearing;
import simbad.blindworld.world.Ping;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Sight;
import simbad.blindworld.world.Track;

/** Changes of a single step in the way of a ping. */
final class Changes {

  private Changes() {}

  /** What a threshold becomes. */
  interface Threshold {
    double of(double thresholdM, Sight sight, Ping ping);
  }

  /** What a distance, a range or a reading becomes. */
  interface Length {
    double of(double lengthM, Ping ping);
  }

  /** What a reading in steps becomes. */
  interface Step {
    double of(double rangeM);
  }

  static Change threshold(Threshold threshold) {
    return hearing(
        new Hearing() {
          @Override
          public double thresholdM(double thresholdM, Sight sight, Ping ping) {
            return threshold.of(thresholdM, sight, ping);
          }
        });
  }

  static Change echo(Length length) {
    return hearing(onEcho(length));
  }

  /** A change of echoes with a memory, one for each track. */
  static Change echoes(Supplier<Length> perTrack) {
    return perTrack(() -> onEcho(perTrack.get()));
  }

  static Hearing onEcho(Length length) {
    return new Hearing() {
      @Override
      public double echoM(double distanceM, Ping ping) {
        return length.of(distanceM, ping);
      }
    };
  }

  static Change range(Length length) {
    return hearing(
        new Hearing() {
          @Override
          public double rangeM(double rangeM, Ping ping) {
            return length.of(rangeM, ping);
          }
        });
  }

  static Change step(Step step) {
    return hearing(
        new Hearing() {
          @Override
          public double steppedM(double readingM, double rangeM, Ping ping) {
            return step.of(rangeM);
          }
        });
  }

  static Change report(Length length) {
    return hearing(onReport(length));
  }

  /** A change of reports with a memory, one for each track. */
  static Change reports(Supplier<Length> perTrack) {
    return perTrack(() -> onReport(perTrack.get()));
  }

  private static Hearing onReport(Length length) {
    return new Hearing() {
      @Override
      public double reportedM(double readingM, Ping ping) {
        return length.of(readingM, ping);
      }
    };
  }

  static Change hearing(Hearing hearing) {
    return perTrack(() -> hearing);
  }

  static Change perTrack(Supplier<Hearing> hearings) {
    return new Change() {
      @Override
      public Hearing hearing(Recording recording, Track track, long repeatSeed) {
        return hearings.get();
      }
    };
  }

  /** True for an echo. */
  static boolean isEcho(double lengthM) {
    return lengthM < Double.POSITIVE_INFINITY;
  }
}
