package simbad.blindworld.effect;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import simbad.blindworld.effect.Form.Drawn;
import simbad.blindworld.world.Beam;
import simbad.blindworld.world.Body;
import simbad.blindworld.world.Change;
import simbad.blindworld.world.Shadow;

/** Effects of what stands where and looks where: turn, offset, shadow, beam width and axis. */
final class MapForms {

  private static final int TABLE = 72;

  private MapForms() {}

  static List<Form> all() {
    return List.of(
        new Form("obstacle-turn", "one", Circumstances::someTable, MapForms::turnOne),
        new Form("obstacle-turn", "all", Circumstances::someTable, MapForms::turnAll),
        Form.anywhere("obstacle-offset", "one", MapForms::offsetOne),
        Form.anywhere("obstacle-offset", "all", MapForms::offsetAll),
        shadow("lobes", MapForms::lobes),
        shadow("notches", MapForms::notches),
        shadow("one side", MapForms::oneSide),
        Form.anywhere("beam-width", "all", MapForms::widthAll),
        new Form("beam-width", "one", Circumstances::severalSensors, MapForms::widthOne),
        Form.anywhere("beam-misalignment", "all", MapForms::axisAll),
        new Form("beam-misalignment", "one", Circumstances::severalSensors, MapForms::axisOne));
  }

  /** A change of the obstacles, of all or of the one with the index. */
  static Change bodies(int which, UnaryOperator<Body> change) {
    return new Change() {
      @Override
      public List<Body> bodies(List<Body> bodies) {
        List<Body> changed = new ArrayList<>();
        for (int b = 0; b < bodies.size(); b++) {
          changed.add(which < 0 || which == b ? change.apply(bodies.get(b)) : bodies.get(b));
        }
        return changed;
      }
    };
  }

  private static Map<String, Object> at(Circumstances c, int which, Map<String, Object> more) {
    Map<String, Object> parameters = new LinkedHashMap<>(more);
    parameters.put("obstacle", c.scene().obstacles().get(which).name());
    return parameters;
  }

  private static Drawn turnOne(Circumstances c) {
    int[] tables =
        IntStream.range(0, c.scene().obstacles().size())
            .filter(i -> !c.scene().obstacles().get(i).shadow().isUniform())
            .toArray();
    int which = tables[c.whole(0, tables.length - 1)];
    double deg = c.eitherWay(9);
    return new Drawn(
        at(c, which, Map.of("deg", deg)), bodies(which, b -> b.turned(Math.toRadians(deg))));
  }

  private static Drawn turnAll(Circumstances c) {
    double deg = c.eitherWay(9);
    return new Drawn(Map.of("deg", deg), bodies(-1, b -> b.turned(Math.toRadians(deg))));
  }

  private static Drawn offsetOne(Circumstances c) {
    int which = c.obstacle();
    double[] by = step(c);
    return new Drawn(
        at(c, which, Map.of("dx", by[0], "dz", by[1])), bodies(which, b -> b.moved(by[0], by[1])));
  }

  private static Drawn offsetAll(Circumstances c) {
    double[] by = step(c);
    return new Drawn(Map.of("dx", by[0], "dz", by[1]), bodies(-1, b -> b.moved(by[0], by[1])));
  }

  private static double[] step(Circumstances c) {
    double metres = c.sized(0.06);
    double direction = c.between(0, 2 * Math.PI);
    return new double[] {metres * StrictMath.cos(direction), metres * StrictMath.sin(direction)};
  }

  private interface Loss {
    /** By bearing in radians, from 0 for no loss to 1 for the whole depth. */
    DoubleUnaryOperator draw(Circumstances c);
  }

  private static Form shadow(String label, Loss loss) {
    return new Form(
        "orientation-shadow",
        label,
        Circumstances::someUniform,
        c -> {
          double depth = Math.min(0.95, c.sized(0.5));
          DoubleUnaryOperator shape = loss.draw(c);
          List<Double> factors =
              IntStream.range(0, TABLE)
                  .mapToObj(i -> 1 - depth * shape.applyAsDouble(2 * Math.PI * i / TABLE))
                  .toList();
          Change change =
              bodies(-1, b -> b.shadow().isUniform() ? b.with(scaled(b.shadow(), factors)) : b);
          return new Drawn(Map.of("depth", depth, "factors", factors), change);
        });
  }

  private static Shadow scaled(Shadow uniform, List<Double> factors) {
    return new Shadow(factors.stream().map(f -> f * uniform.atM(0)).toList());
  }

  private static DoubleUnaryOperator lobes(Circumstances c) {
    int count = c.whole(1, 6);
    double phase = c.between(0, 2 * Math.PI);
    double sharp = c.between(0.5, 3);
    return b -> StrictMath.pow(0.5 + 0.5 * StrictMath.cos(count * b + phase), sharp);
  }

  private static DoubleUnaryOperator notches(Circumstances c) {
    int count = c.whole(2, 5);
    double[] at = IntStream.range(0, count).mapToDouble(i -> c.between(0, 2 * Math.PI)).toArray();
    double half = c.between(0.15, 0.5);
    return b -> {
      double deepest = 0;
      for (double centre : at) {
        double beside = Math.abs(Math.IEEEremainder(b - centre, 2 * Math.PI));
        deepest = Math.max(deepest, Math.min(1, 2 - 2 * beside / half));
      }
      return Math.max(0, deepest);
    };
  }

  private static DoubleUnaryOperator oneSide(Circumstances c) {
    double phase = c.between(0, 2 * Math.PI);
    return b -> 1 / (1 + StrictMath.exp(-4 * StrictMath.cos(b - phase)));
  }

  private static Change beams(String only, UnaryOperator<Beam> change) {
    return new Change() {
      @Override
      public Beam beam(String sensor, Beam beam) {
        return only.isEmpty() || only.equals(sensor) ? change.apply(beam) : beam;
      }
    };
  }

  private static double widening(Circumstances c) {
    double deg = c.eitherWay(4);
    double least = -0.6 * Math.toDegrees(c.sensor().halfAngleRad());
    return Math.max(least, deg);
  }

  private static Drawn widthAll(Circumstances c) {
    return width(widening(c), "");
  }

  private static Drawn widthOne(Circumstances c) {
    return width(widening(c), c.transducer());
  }

  private static Drawn width(double deg, String only) {
    double rad = Math.toRadians(deg);
    return new Drawn(
        Map.of("deg", deg, "sensor", only),
        beams(only, b -> new Beam(b.axisRad(), b.halfAngleRad() + rad)));
  }

  private static Drawn axisAll(Circumstances c) {
    return axis(c.eitherWay(5), "");
  }

  private static Drawn axisOne(Circumstances c) {
    return axis(c.eitherWay(7), c.transducer());
  }

  private static Drawn axis(double deg, String only) {
    double rad = Math.toRadians(deg);
    return new Drawn(
        Map.of("deg", deg, "sensor", only),
        beams(only, b -> new Beam(b.axisRad() + rad, b.halfAngleRad())));
  }
}
