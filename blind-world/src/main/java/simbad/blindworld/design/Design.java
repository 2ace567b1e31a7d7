package simbad.blindworld.design;

import java.util.List;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Scene;

/** A way of measuring: recordings drawn from one design differ only by chance. */
public interface Design {

  /** "run", "bench" or "placed". */
  String kind();

  /** The time between two pings of one transducer, in seconds. */
  double periodS();

  /** A recording of about so many rows. */
  Recording record(Scene scene, int rows, Chance random);

  /** A design drawn at random, of the kind. */
  static Design draw(String kind, Chance random) {
    return kind.equals("run") ? new Drive(random) : new Bench(random);
  }

  /** One drawn at random in which a hand puts the sonar in place and reads it several times. */
  static Design placed(Chance random) {
    return new Placed(random);
  }

  /** The kinds that are drawn where none is needed. */
  static List<String> kinds() {
    return List.of("run", "bench");
  }
}
