package simbad.blindworld.score;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import simbad.blindworld.file.FormatException;
import simbad.blindworld.file.JsonObject;
import simbad.blindworld.world.Beam;
import simbad.blindworld.world.Body;
import simbad.blindworld.world.Forecast;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;
import simbad.blindworld.world.Scene;
import simbad.blindworld.world.Sight;

/**
 * The sealed rows of a case as one that asks where its gap is: how much of each row's gap the true
 * world's forecast takes away.
 */
final class SealedPlaces {

  /** Of fewer rows in a place, or beside it, a mean says little. */
  private static final int LEAST_ROWS = 5;

  private static final Set<String> NAMES = Set.of("obstacle", "sensor", "run");
  private static final Set<String> NUMBERS =
      Set.of("bearing_deg", "distance_m", "off_axis_deg", "t_s");

  private final Scene scene;
  private final List<Row> rows;
  private final List<Body> bodies;
  private final double[] removableCm;

  /**
   * Takes sealed rows.
   *
   * @param scene as it is believed
   * @param rows in the order of the forecasts
   * @param nominal what the scene lets expect
   * @param real what the true world lets expect
   * @param countedM what was read
   */
  SealedPlaces(
      Scene scene, Recording rows, Forecast nominal, Forecast real, List<Double> countedM) {
    this.scene = scene;
    this.rows = rows.rows();
    bodies = scene.obstacles().stream().map(Body::of).toList();
    removableCm =
        IntStream.range(0, this.rows.size())
            .mapToDouble(i -> nominal.lossCm(i, countedM.get(i)) - real.lossCm(i, countedM.get(i)))
            .toArray();
  }

  /** Those of the places that an answer tells of which these rows can say something. */
  List<Particulars.Place> hits(List<JsonObject> where) throws FormatException {
    List<Particulars.Place> hits = new ArrayList<>();
    for (JsonObject place : where) {
      hit(place.object("slice")).ifPresent(hits::add);
    }
    return hits;
  }

  private Optional<Particulars.Place> hit(JsonObject slice) throws FormatException {
    double in = 0;
    double all = 0;
    int count = 0;
    for (int row = 0; row < rows.size(); row++) {
      Optional<Boolean> holds = holds(slice, rows.get(row));
      if (holds.isEmpty()) {
        return Optional.empty();
      }
      all += removableCm[row];
      in += holds.get() ? removableCm[row] : 0;
      count += holds.get() ? 1 : 0;
    }
    int others = rows.size() - count;
    if (count < LEAST_ROWS || others < LEAST_ROWS) {
      return Optional.empty();
    }
    boolean isLarger = in / count > (all - in) / others;
    double share = all > 0 ? in / all : 0;
    return Optional.of(new Particulars.Place(isLarger, (double) count / rows.size(), share));
  }

  /** Empty where a condition is of something that rows do not say. */
  private Optional<Boolean> holds(JsonObject slice, Row row) throws FormatException {
    boolean holds = true;
    for (String variable : slice.fields().keySet()) {
      if (NAMES.contains(variable)) {
        holds &= slice.text(variable).equals(name(variable, row));
      } else if (NUMBERS.contains(variable)) {
        List<Double> ends = slice.numbers(variable);
        if (ends.size() != 2) {
          throw new FormatException(slice.where() + ", " + variable + ": expected two numbers");
        }
        double value = number(variable, row);
        holds &= value >= ends.get(0) && value < ends.get(1);
      } else {
        return Optional.empty();
      }
    }
    return Optional.of(holds);
  }

  private String name(String variable, Row row) {
    return switch (variable) {
      case "sensor" -> row.sensor();
      case "run" -> row.run();
      default -> scene.obstacles().get(seen(row.pose()).body()).name();
    };
  }

  private double number(String variable, Row row) {
    if (variable.equals("t_s")) {
      return row.tS();
    }
    Pose pose = row.pose();
    Sight sight = seen(pose);
    if (variable.equals("distance_m")) {
      return sight.centreM();
    }
    if (variable.equals("bearing_deg")) {
      double deg = Math.toDegrees(sight.bearingRad()) % 360;
      return deg < 0 ? deg + 360 : deg;
    }
    double x = scene.obstacles().get(sight.body()).place().xM() - pose.xM();
    double z = scene.obstacles().get(sight.body()).place().zM() - pose.zM();
    double off = StrictMath.atan2(-z, x) - pose.headingRad();
    return Math.toDegrees(Math.IEEEremainder(off, 2 * Math.PI));
  }

  /** The obstacle that is nearest in the cone, or else the one whose centre is. */
  private Sight seen(Pose pose) {
    Beam beam = new Beam(0, scene.sensor().halfAngleRad());
    Sight best = bodies.get(0).seenFrom(pose, beam, 0);
    for (int i = 1; i < bodies.size(); i++) {
      Sight other = bodies.get(i).seenFrom(pose, beam, i);
      boolean nearer = other.distanceM() < best.distanceM();
      boolean closer = !best.inCone() && other.centreM() < best.centreM();
      best = nearer || closer ? other : best;
    }
    return best;
  }
}
