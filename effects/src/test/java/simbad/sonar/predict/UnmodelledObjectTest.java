package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import simbad.sonar.change.UnmodelledObject;
import simbad.sonar.change.UnmodelledPost;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.Change;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.sensing.ReadingRow;

/** Faces and posts that are not in the scene, by what can be worked out by hand. */
class UnmodelledObjectTest {
  private static final SensingSetup EMPTY =
      new SensingSetup(Sonars.noisy(0.05, 0.02, 0.1, 0.1), Scenes.of(), 6.5);

  /** Of a standard normal variable: 2 F(1.25) - 1, from a table of F. */
  private static final double WITHIN_1_25 = 0.788700;

  private static final double FAR = 9;

  private static void assertSilent(double expected, Pose pose, Change change) {
    assertEquals(expected, probability(pose, Logs.SILENCE, change), 1e-12);
  }

  private static double probability(Pose pose, OptionalDouble rangeM, Change change) {
    return Logs.likelihood(EMPTY, List.of(Logs.row(0, pose, rangeM)), List.of(change))[0];
  }

  private static UnmodelledObject face(double squareDeg, double reachM) {
    return new UnmodelledObject(2.975, 0, Math.PI, 0.5, Math.toRadians(squareDeg), reachM, 0.8);
  }

  private static UnmodelledPost post(double radiusM, double reachM, double squareDeg) {
    return new UnmodelledPost(2.975 + radiusM, 0, radiusM, reachM, Math.toRadians(squareDeg), 0.8);
  }

  /** A board across the heading 2.975 m ahead, its normal towards the sensor. */
  @Test
  void face_answersWhereItIsSeenSquarely() {
    Pose ahead = Pose.of(0, 0, 0);
    assertEquals(
        0.8 * WITHIN_1_25, probability(ahead, OptionalDouble.of(2.95), face(20, FAR)), 1e-6);
    // Beside the board a mirror shows nothing, a face its end: hypot(2.975, 0.6 - 0.5).
    assertSilent(1, Pose.of(0, 0.6, 0), face(0, FAR));
    assertSilent(0.2, Pose.of(0, 0.6, 0), face(20, FAR));
    assertSilent(0.2, Pose.of(0, 0.4, 0), face(0, FAR));
    // 25 degrees askew it is not square enough; nor is it heard from behind, or from too far.
    assertSilent(1, Pose.of(0, 0, Math.toRadians(25)), face(20, FAR));
    assertSilent(1, Pose.of(4, 0, Math.PI), face(20, FAR));
    assertSilent(0.2, ahead, face(20, 2.98));
    assertSilent(1, ahead, face(20, 2.97));
  }

  /** Of two pings with nothing of the scene in their cones, only the one that faces it hears it. */
  @Test
  void objects_hangOnThePose_withNothingElseInTheCone() {
    List<ReadingRow> rows =
        List.of(
            Logs.row(0, Pose.of(0, 0, Math.PI), Logs.SILENCE),
            Logs.row(0.1, Pose.of(0, 0, 0), Logs.SILENCE),
            Logs.row(0.2, Pose.of(0, 0, Math.PI), Logs.SILENCE));
    for (Change object : List.of(face(20, FAR), post(0.1, FAR, 90))) {
      double[] silent = Logs.likelihood(EMPTY, rows, List.of(object));
      assertArrayEquals(new double[] {1, 0.2, 1}, silent, 1e-12, object.toString());
    }
  }

  /** A post whose nearest point is 2.975 m ahead. */
  @Test
  void post_answersFromItsNearSide() {
    Pose ahead = Pose.of(0, 0, 0);
    OptionalDouble range = OptionalDouble.of(2.95);
    assertEquals(0.8 * WITHIN_1_25, probability(ahead, range, post(0.1, FAR, 90)), 1e-6);
    assertEquals(0.8 * WITHIN_1_25, probability(ahead, range, post(0, FAR, 90)), 1e-6);
    assertSilent(0.2, ahead, post(0.1, 2.98, 90));
    assertSilent(1, ahead, post(0.1, 2.97, 90));
    assertSilent(1, Pose.of(-3.1, 0, 0), post(0.1, FAR, 90));
    // From inside of it nothing is heard.
    assertSilent(1, Pose.of(3, 0, 0), post(0.1, FAR, 90));
  }

  /** The cone's border meets a thick post whose axis is out of the cone, by half a degree. */
  @Test
  void post_beside_isHeardAsFarAsTheConeReaches() {
    double half = EMPTY.sensor().coneHalfAngleRad();
    Pose askew = Pose.of(0, 0, half + Math.toRadians(0.5));
    assertSilent(1, askew, post(0, FAR, 90));
    assertSilent(0.2, askew, post(0.1, FAR, 90));
    // 3.075 cos 0.5 deg - sqrt(0.1^2 - (3.075 sin 0.5 deg)^2)
    double range = 3.075 * 0.99996192 - Math.sqrt(0.01 - Math.pow(3.075 * 0.00872654, 2));
    assertSilent(1, askew, post(0.1, range - 1e-6, 90));
    assertSilent(1, askew, post(0.1, FAR, 10));
    assertSilent(1, Pose.of(0, 0, Math.toRadians(12)), post(0.1, FAR, 10));
    assertSilent(0.2, Pose.of(0, 0, Math.toRadians(8)), post(0.1, FAR, 10));
  }

  /** Its nearest point is within the sensor's range, but what the cone's border meets is not. */
  @Test
  void post_beside_isHeardAsFarAsTheSensorReaches() {
    double most = EMPTY.sensor().maxRangeM();
    double distance = most + 0.05;
    Change post = new UnmodelledPost(distance, 0, 0.1, FAR, Math.PI / 2, 0.8);
    double half = EMPTY.sensor().coneHalfAngleRad();
    assertSilent(0.2, Pose.of(0, 0, half + Math.asin(0.05 / distance)), post);
    assertSilent(1, Pose.of(0, 0, half + Math.asin(0.0999 / distance)), post);
  }
}
