package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.DoubleRange;
import simbad.definition.Parameter;
import simbad.sonar.effect.Form;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** A world that lies turned on the page is the same world, whatever is changed in it. */
class TurnedWorldTest {
  private static final List<String> SENSORS = List.of("sonar");
  private static final int PINGS = 8;

  @Property(tries = 400, seed = "20140617")
  void anyForm_readsTheSame(
      @ForAll long seed, @ForAll @DoubleRange(min = -3, max = 3) double turnRad) {
    Random random = new Random(seed);
    Scene scene = Scenes.any(random);
    List<ReadingRow> rows = rows(random);
    List<Form> forms = Logs.forms(setup(scene), SENSORS);
    int which = random.nextInt(forms.size());
    double[] values =
        forms.get(which).parameters().stream().mapToDouble(p -> value(p, random)).toArray();
    double[] there = Logs.likelihood(setup(scene), rows, List.of(forms.get(which).with(values)));
    Scene turned = new Scene(scene.obstacles().stream().map(one -> turned(one, turnRad)).toList());
    Form same = Logs.forms(setup(turned), SENSORS).get(which);
    double[] found =
        Logs.likelihood(
            setup(turned),
            rows.stream().map(row -> turned(row, turnRad)).toList(),
            List.of(same.with(turned(same, values, turnRad))));
    assertArrayEquals(there, found, 1e-7, same.toString());
  }

  /** Of metres and degrees mostly those that matter in so small a world. */
  private static double value(Parameter parameter, Random random) {
    double low = Math.max(-3, parameter.low());
    double high = Math.min(3, parameter.high());
    return low < high
        ? random.nextDouble(low, high)
        : random.nextDouble(parameter.low(), parameter.high());
  }

  private static SensingSetup setup(Scene scene) {
    return new SensingSetup(Sonars.noisy(0.05, 0.03, 0.1, 0.1), scene, 6.5);
  }

  private static List<ReadingRow> rows(Random random) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < PINGS; i++) {
      Pose pose =
          Pose.of(random.nextDouble(-2, 2), random.nextDouble(-2, 2), random.nextDouble(-4, 4));
      OptionalDouble range =
          random.nextInt(3) == 0 ? Logs.SILENCE : OptionalDouble.of(0.05 * random.nextInt(2, 60));
      rows.add(Logs.row(0.1 * i, pose, range));
    }
    return rows;
  }

  private static ReadingRow turned(ReadingRow row, double turnRad) {
    Pose pose = row.pose();
    double[] place = turned(pose.position().xM(), pose.position().zM(), turnRad);
    return new ReadingRow(
        row.run(),
        row.sensor(),
        row.timeS(),
        Pose.of(place[0], place[1], pose.heading().radians() + turnRad),
        row.reading());
  }

  private static Obstacle turned(Obstacle one, double turnRad) {
    Placement at = one.worldFromObstacle();
    double[] place = turned(at.xM(), at.zM(), turnRad);
    return new Obstacle(
        one.name(),
        new Placement(place[0], place[1], at.turnRad() + turnRad),
        one.outline(),
        one.detection());
  }

  /** The values that are places or directions on the page; the others stay. */
  private static double[] turned(Form form, double[] values, double turnRad) {
    double[] turned = values.clone();
    List<String> names = form.parameters().stream().map(Parameter::name).toList();
    if (names.contains("x_m")) {
      int x = names.indexOf("x_m");
      int z = names.indexOf("z_m");
      double[] place = turned(values[x], values[z], turnRad);
      turned[x] = place[0];
      turned[z] = place[1];
    }
    if (names.contains("normal_deg")) {
      turned[names.indexOf("normal_deg")] += Math.toDegrees(turnRad);
    }
    return turned;
  }

  private static double[] turned(double xM, double zM, double turnRad) {
    double cos = Math.cos(turnRad);
    double sin = Math.sin(turnRad);
    return new double[] {xM * cos + zM * sin, zM * cos - xM * sin};
  }
}
