package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import simbad.blindworld.wave.Air;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.Ear;
import simbad.blindworld.wave.Gear;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Track;

/** Alterations of one thing. */
final class Alterations {

  private Alterations() {}

  /** What a time or a range becomes. */
  interface Value {
    double of(double value, WavePing ping);
  }

  static Alteration gear(UnaryOperator<Gear> change) {
    return new Alteration() {
      @Override
      public Gear gear(String sensor, Gear gear) {
        return change.apply(gear);
      }
    };
  }

  static Alteration air(UnaryOperator<Air> change) {
    return new Alteration() {
      @Override
      public Air air(Air air) {
        return change.apply(air);
      }
    };
  }

  static Alteration reflectors(UnaryOperator<List<Reflector>> change) {
    return new Alteration() {
      @Override
      public List<Reflector> reflectors(List<Reflector> reflectors) {
        return change.apply(reflectors);
      }
    };
  }

  /** One of the obstacles is another. */
  static Alteration instead(int index, UnaryOperator<Reflector> change) {
    return reflectors(
        all -> {
          List<Reflector> others = new ArrayList<>(all);
          others.set(index, change.apply(all.get(index)));
          return others;
        });
  }

  /** Something more is there. */
  static Alteration more(List<? extends Reflector> added) {
    return reflectors(
        all -> {
          List<Reflector> others = new ArrayList<>(all);
          others.addAll(added);
          return others;
        });
  }

  /** An ear for each track, with a memory of its own. */
  static Alteration ear(Supplier<Ear> ears) {
    return new Alteration() {
      @Override
      public Ear ear(Recording recording, Track track, long repeatSeed) {
        return ears.get();
      }
    };
  }

  static Alteration arrival(Supplier<Value> perTrack) {
    return ear(
        () -> {
          Value value = perTrack.get();
          return new Ear() {
            @Override
            public double arrivalS(double arrivalS, WavePing ping) {
              return value.of(arrivalS, ping);
            }
          };
        });
  }

  static Alteration range(Value value) {
    return ear(
        () ->
            new Ear() {
              @Override
              public double rangeM(double rangeM, WavePing ping) {
                return value.of(rangeM, ping);
              }
            });
  }

  static Alteration report(Supplier<Value> perTrack) {
    return ear(
        () -> {
          Value value = perTrack.get();
          return new Ear() {
            @Override
            public double reportedM(double readingM, WavePing ping) {
              return value.of(readingM, ping);
            }
          };
        });
  }

  /** A level that changes, never louder than the headroom. */
  static Alteration louder(double headroomDb, Value db) {
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
            return Math.min(headroomDb, db.of(0, ping));
          }
        };
      }
    };
  }

  static boolean isEcho(double value) {
    return value < Double.POSITIVE_INFINITY;
  }
}
