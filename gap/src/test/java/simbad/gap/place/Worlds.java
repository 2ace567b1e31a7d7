package simbad.gap.place;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import simbad.gap.fit.Evidence;
import simbad.gap.fit.Hypothesis;
import simbad.sonar.effect.DiagnosedModel;
import simbad.sonar.effect.Effect;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.PingLog;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** A sensor round a square post of 10 cm at the origin, and logs that models themselves draw. */
final class Worlds {
  static final SensingSetup POST = setup();

  private Worlds() {}

  private static SensingSetup setup() {
    Outline square =
        Outline.of(
            List.of(
                new Point(0.05, 0.05),
                new Point(0.05, -0.05),
                new Point(-0.05, -0.05),
                new Point(-0.05, 0.05)));
    Obstacle post = new Obstacle("post", new Placement(0, 0, 0), square, new UniformDetection(1.5));
    SonarSpec sensor =
        new SonarSpec("s", Math.toRadians(20), 0.02, 4, 0.1, 343, 0.01, 0.005, 0.02, 0.03, 0.05);
    return new SensingSetup(sensor, new Scene(List.of(post)), 4);
  }

  /** Poses on a grid of bearings and distances, facing the post, in an order drawn by lot. */
  static List<ReadingRow> poses(int count, double fromM, double toM, long seed) {
    Random random = new Random(seed);
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      double bearing = random.nextDouble() * 2 * Math.PI;
      double distance = fromM + random.nextDouble() * (toM - fromM);
      double x = distance * Math.sin(bearing);
      double z = distance * Math.cos(bearing);
      rows.add(
          new ReadingRow("r", "s", 0.05 * i, Pose.of(x, z, Math.atan2(z, -x)), NoEcho.NO_ECHO));
    }
    return rows;
  }

  /** The same rows with readings that a hypothesis draws. */
  static List<ReadingRow> read(List<ReadingRow> poses, Hypothesis truth, long seed) {
    PingLog log = new PingLog(poses);
    DiagnosedModel model = new Evidence(POST, List.of(), log).model(truth);
    List<ReadingDistribution> forecast = model.forecast(model.geometry(log));
    Random random = new Random(seed);
    List<ReadingRow> rows = new ArrayList<>();
    for (int ping = 0; ping < log.size(); ping++) {
      ReadingRow row = poses.get(log.row(ping));
      rows.add(
          new ReadingRow(
              row.run(), row.sensor(), row.timeS(), row.pose(), forecast.get(ping).sample(random)));
    }
    return rows;
  }

  static Evidence evidence(List<ReadingRow> rows) {
    return new Evidence(POST, List.of(), new PingLog(rows));
  }

  static Hypothesis effect(Effect effect, String form, double... values) {
    Form of = Forms.find(effect, form, POST, List.of("s")).orElseThrow();
    return Hypothesis.NONE.and(of, values);
  }
}
