package simbad.sonar.change;

import static java.util.Objects.requireNonNull;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.OutlineLevels;
import simbad.sonar.ping.PingLog;
import simbad.sonar.predict.ChangedModel;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.SonarSpec;
import simbad.sonar.scene.StrengthDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

class OtherOutlineTest {
  private static final double RADIUS_M = 0.03;
  private static final SensingSetup SETUP = setup();
  private static final Form POST =
      Forms.find(Effect.ORIENTATION_SHADOW, "post:pole#0", SETUP, List.of("s")).orElseThrow();

  private static SensingSetup setup() {
    List<Point> corners = new ArrayList<>();
    for (int i = 0; i < 72; i++) {
      double angle = Math.toRadians(5 * i);
      corners.add(new Point(RADIUS_M * Math.sin(angle), RADIUS_M * Math.cos(angle)));
    }
    Outline round = Outline.of(corners);
    SonarSpec sensor =
        new SonarSpec("s", Math.toRadians(20), 0.02, 4, 0.1, 343, 0.01, 0.005, 0.02, 0.03, 0.05);
    Obstacle pole = new Obstacle("pole", new Placement(0, 0, 0), round, new UniformDetection(1.5));
    Obstacle other =
        new Obstacle("other", new Placement(9, 0, 0), round, new UniformDetection(1.5));
    return new SensingSetup(sensor, new Scene(List.of(pole, other)), 4)
        .under(SensorLaw.Model.LEVEL);
  }

  private static ChangedModel heard(SensingSetup setup, Change... effects) {
    Form law = LevelForms.law(setup);
    List<Change> changes = new ArrayList<>(List.of(law.with(law.neutral())));
    changes.addAll(List.of(effects));
    return new ChangedModel(setup, changes);
  }

  /** Before the pole, at a bearing of it. */
  private static PingLog ping(double bearingDeg, double distanceM) {
    double bearing = Math.toRadians(bearingDeg);
    double x = distanceM * Math.sin(bearing);
    double z = distanceM * Math.cos(bearing);
    Pose pose = Pose.of(x, z, Math.atan2(z, -x));
    return new PingLog(List.of(new ReadingRow("r", "s", 0, pose, NoEcho.NO_ECHO)));
  }

  private static double chance(double bearingDeg, double distanceM, double... values) {
    ChangedModel model = heard(SETUP, POST.with(values));
    return 1
        - model.forecast(model.geometry(ping(bearingDeg, distanceM))).get(0).noEchoProbability();
  }

  /** Where the round pole is just lost a flat side is heard and an edge is not. */
  @Test
  void squarePost_isHeardBeforeItsSidesOnly() {
    assertEquals(0.98 / 2, chance(45, 1.5, POST.neutral()), 0.01);
    assertTrue(chance(0, 1.5, 0.05, 0.05, 0) > 0.97);
    assertTrue(chance(45, 1.5, 0.05, 0.05, 0) < 0.01);
    assertTrue(chance(45, 1.5, 0.05, 0.05, 45) > 0.97, "turned");
    assertTrue(chance(0, 1.5, 0.05, 0.05, 45) < 0.01);
  }

  /** The nearest point is a side's or an edge's. */
  @Test
  void nearestPoint_isThatOfTheRealOutline() {
    ChangedModel model = heard(SETUP, POST.with(0.06, 0.04, 0));
    assertEquals(0.98, model.geometry(ping(0, 1)).nearestM(0), 1e-9);
    assertEquals(0.97, model.geometry(ping(90, 1)).nearestM(0), 1e-9);
    assertEquals(1, model.geometry(ping(90, 1.03)).nearestM(0), 1e-9);
  }

  @Test
  void neutral_changesNoBit_andNoOtherObstacleIsTouched() {
    OtherOutline same = (OtherOutline) POST.with(POST.neutral());
    assertEquals(SETUP.scene(), same.apply(SETUP.scene()));
    ChangedModel before = heard(SETUP);
    Geometry geometry = before.geometry(ping(30, 1));
    OtherOutline square = (OtherOutline) POST.with(0.05, 0.05, 10);
    assertEquals(0, square.addedDb(requireNonNull(geometry.ears()), geometry, 1));
    assertEquals(0, same.addedDb(requireNonNull(geometry.ears()), geometry, 0));
    assertEquals(SETUP.scene().obstacles().get(1), square.apply(SETUP.scene()).obstacles().get(1));
  }

  /** Two posts of one size are one to a fit, however it came to them. */
  @Test
  void equal_whereValuesAre() {
    assertEquals(POST.with(0.05, 0.04, 10), POST.with(0.05, 0.04, 10));
    OutlineLevels levels = ((OtherOutline) POST.with(0.05, 0.04, 10)).real();
    assertThrows(
        IllegalArgumentException.class,
        () -> new OtherOutline(Optional.empty(), levels, levels, Double.NaN));
  }

  /** A scene that says it: the nominal model hears what the diagnosed one does. */
  @Test
  void corrected_hasTheOutlineAndItsStrengths() {
    SensingSetup corrected =
        Definitions.of(Effect.ORIENTATION_SHADOW)
            .corrected(SETUP, POST, 0.05, 0.04, 20)
            .orElseThrow();
    Obstacle post = corrected.scene().obstacles().get(0);
    assertEquals(4, post.outline().size());
    assertTrue(post.detection() instanceof StrengthDetection);
    assertEquals(SETUP.scene().obstacles().get(1), corrected.scene().obstacles().get(1));
    ChangedModel nominal = heard(corrected);
    for (double bearing : new double[] {20, 23, 65, 110, 200}) {
      double diagnosed = chance(bearing, 1.5, 0.05, 0.04, 20);
      double own =
          1 - nominal.forecast(nominal.geometry(ping(bearing, 1.5))).get(0).noEchoProbability();
      assertEquals(diagnosed, own, 0.1, bearing + " degrees");
    }
  }
}
