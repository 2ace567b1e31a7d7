package simbad.gap.calibrate;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.LevelWorlds;
import simbad.gap.fixture.Worlds;
import simbad.sonar.catalogue.LevelForms;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SetupDetails;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** Poses that are known to so much, before a post whose face is 10 cm wide. */
class PoseScatterTest {
  private static final double EXACT = 1e-9;

  /** What {@link Worlds#POST} says: edges 3 cm wide, ranges to 5 mm, 2 misses in a hundred. */
  private static final double NOISE = 0.005;

  private static SensingSetup known(double poseM, double headingRad) {
    return Worlds.POST.with(
        new SetupDetails(poseM, headingRad, Map.of(), Optional.empty(), List.of()));
  }

  /** Half a metre before the face, turned aside by so much; each ping a little further on. */
  private static PingLog log(boolean heard, double... turnedDeg) {
    List<ReadingRow> rows = new ArrayList<>();
    for (double deg : turnedDeg) {
      Pose pose = Pose.of(0, 0.55, Math.PI / 2 + Math.toRadians(deg));
      rows.add(
          new ReadingRow(
              "r", "s", 0.1 * rows.size(), pose, heard ? new Echo(0.5) : NoEcho.NO_ECHO));
    }
    return new PingLog(rows);
  }

  private static double noise(SensingSetup setup, PingLog log) {
    Hypothesis believed = PoseScatter.believed(setup, log);
    assertEquals(1, believed.forms().size());
    assertArrayEquals(new double[] {0.03, 0.02}, ends(believed.values()), EXACT);
    return believed.values()[1];
  }

  private static double[] ends(double[] values) {
    return new double[] {values[0], values[2]};
  }

  @Test
  void exactPosesAddNothing() {
    assertEquals(Hypothesis.NONE, PoseScatter.believed(known(0, 0), log(true, 0)));
  }

  @Test
  void aPlaceThatIsOffAddsItsSquare() {
    assertEquals(Math.hypot(NOISE, 0.012), noise(known(0.012, 0), log(true, 0)), EXACT);
  }

  /** A turn of the sensor leaves the face's nearest point in the cone. */
  @Test
  void aHeadingAddsNothingBeforeAFace() {
    assertEquals(NOISE, noise(known(0, 0.01), log(true, 0)), EXACT);
  }

  /**
   * Turned by 23 degrees the cone's edge meets the face 3 degrees beside its nearest point: as far
   * as half a metre over the cosine. Half a degree more or less is half of the difference.
   */
  @Test
  void aHeadingMovesWhereTheConesEdgeMeetsAFace() {
    double more = 0.5 / Math.cos(Math.toRadians(3.5));
    double less = 0.5 / Math.cos(Math.toRadians(2.5));
    double turned = (more - less) / 2;
    SensingSetup setup = known(0, Math.toRadians(0.5));

    assertEquals(Math.hypot(NOISE, turned), noise(setup, log(true, 23)), EXACT);
    assertEquals(Math.hypot(NOISE, turned), noise(setup, log(true, -23)), EXACT);
    // One of two: half of the mean square. Silence says nothing.
    assertEquals(Math.hypot(NOISE, turned / Math.sqrt(2)), noise(setup, log(true, 23, 0)), EXACT);
    assertEquals(NOISE, noise(setup, log(false, 23)), EXACT);
  }

  /** At 26 degrees half a degree decides whether the face is met at all. */
  @Test
  void whatIsAnotherRangeIsLeftOut() {
    assertEquals(NOISE, noise(known(0, Math.toRadians(3)), log(true, 24)), EXACT);
  }

  /** What was put in place and read again is off by its place; its heading is left to itself. */
  @Test
  void placementsThatAreReadAgainAreOffByTheirPlace() {
    List<ReadingRow> rows = new ArrayList<>();
    for (int i = 0; i < 12; i++) {
      rows.add(
          new ReadingRow(
              "r", "s", 0, Pose.of(0, 0.5 + Math.floor(i / 3.0), Math.PI / 2), new Echo(0.5)));
    }

    PingLog log = new PingLog(rows);
    assertEquals(Math.hypot(NOISE, 0.01), noise(known(0.01, 0), log), EXACT);
    assertEquals(Math.hypot(NOISE, 0.01), noise(known(0.01, 0.1), log), EXACT);
    assertEquals(Hypothesis.NONE, PoseScatter.believed(known(0, 0.1), log));
  }

  /** Without a reference the law is the believed one, behind what poses scatter by. */
  @Test
  void aSetupWithoutReferenceIsAsBelieved() {
    PingLog log = log(true, 0);
    Calibration level = Calibration.none(LevelWorlds.POST, log);
    assertEquals(List.of(LevelForms.law(LevelWorlds.POST)), level.setup().forms());
    assertArrayEquals(LevelForms.law(LevelWorlds.POST).neutral(), level.setup().values(), 0);
    assertEquals(Hypothesis.NONE, Calibration.none(Worlds.POST, log).setup());
    Calibration scattered = Calibration.none(known(0.012, 0), log);
    assertEquals(Math.hypot(NOISE, 0.012), scattered.setup().values()[1], EXACT);
  }

  @Test
  void withoutReferenceNothingIsDoubted() {
    Calibration none = Calibration.none();
    assertArrayEquals(new double[] {1, 1}, none.blocksVary(), 0);
    assertEquals(1, none.misfitTimes(1, 100), 0);
    assertEquals(1, none.gapTimes(), 0);
    assertEquals(1, none.clumping(), 0);
    assertEquals(1, none.rangeClumping(), 0);
    assertEquals(false, none.isHeldOut());
    assertEquals(Optional.empty(), none.modelError());
    assertEquals(Optional.empty(), none.leeway());
    assertEquals(Worlds.POST, none.believed(Worlds.POST));
  }
}
