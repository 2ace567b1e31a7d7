package simbad.gap.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fixture.Ladders;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.Outline;

/** What physics, symmetry and the design of a log forbid. */
class GatesTest {
  private static Set<Effect> closed(SensingSetup setup, List<ReadingRow> rows) {
    CalibratedLog given = new CalibratedLog(setup, List.of(), new PingLog(rows));
    Set<Effect> closed = new TreeSet<>(Definitions.effects());
    Gates.open(given, Forms.all(setup, List.of("s"))).stream()
        .map(Form::effect)
        .forEach(closed::remove);
    return closed;
  }

  private static SensingSetup pole(Point centre) {
    Outline round =
        Outline.of(
            IntStream.range(0, 24)
                .mapToObj(i -> Math.toRadians(-15 * i))
                .map(
                    angle ->
                        new Point(
                            centre.xM() + 0.05 * Math.sin(angle),
                            centre.zM() + 0.05 * Math.cos(angle)))
                .collect(Collectors.toList()));
    Obstacle pole = new Obstacle("pole", new Placement(0, 0, 0), round, new UniformDetection(1.5));
    return new SensingSetup(Worlds.POST.sensor(), new Scene(List.of(pole)), 4);
  }

  private static List<ReadingRow> every(double seconds) {
    return IntStream.range(0, 20)
        .mapToObj(
            i -> {
              ReadingRow row = Worlds.poses(20, 0.3, 1.3, 1).get(i);
              return new ReadingRow(
                  row.run(), row.sensor(), seconds * i, row.pose(), row.reading());
            })
        .toList();
  }

  /** A sensor that turns on its spot before a post: what makes it read 5 cm more may be any. */
  @Test
  void atOneDistance_scaleAndOffsetAndSlant_areOne() {
    List<ReadingRow> drive = Worlds.poses(40, 0.3, 1.3, 1);
    assertEquals(Set.of(), twins(drive, Effect.SOUND_SPEED));
    List<ReadingRow> sweep =
        IntStream.range(0, 40)
            .mapToObj(
                i ->
                    new ReadingRow(
                        "r", "s", i, Pose.of(0, 0.8, Math.toRadians(60 + i)), NoEcho.NO_ECHO))
            .toList();
    assertEquals(
        Set.of(
            Effect.RANGE_OFFSET,
            Effect.VERTICAL_BEAM,
            Effect.COARSE_RESOLUTION,
            Effect.OBSTACLE_OFFSET),
        twins(sweep, Effect.SOUND_SPEED));
    assertEquals(
        Set.of(
            Effect.SOUND_SPEED,
            Effect.VERTICAL_BEAM,
            Effect.COARSE_RESOLUTION,
            Effect.OBSTACLE_OFFSET),
        twins(sweep, Effect.RANGE_OFFSET));
    assertEquals(Set.of(), twins(sweep, Effect.GAIN));
  }

  private static Set<Effect> twins(List<ReadingRow> rows, Effect effect) {
    return Gates.twins(Worlds.given(rows)).getOrDefault(effect, Set.of());
  }

  @Test
  void drive_hasNoPlacements_andStepsHideWaves() {
    assertEquals(
        Set.of(Effect.NO_ECHO_CODE, Effect.PLACEMENT_ERROR, Effect.WAVE_HOP, Effect.RANGE_WALK),
        closed(Worlds.POST, every(0.05)));
  }

  /** Of a sensor that hears to 4 m nothing comes back over 16 m, in 93 ms. */
  @Test
  void echoOfThePingBefore_diesAway() {
    assertEquals(false, closed(Worlds.POST, every(0.09)).contains(Effect.PREVIOUS_PING));
    assertEquals(true, closed(Worlds.POST, every(0.1)).contains(Effect.PREVIOUS_PING));
  }

  @Test
  void roundPole_looksTheSameFromAllSides_unlessItTurnsRoundAnotherAxis() {
    assertEquals(
        Set.of(
            Effect.NO_ECHO_CODE,
            Effect.PLACEMENT_ERROR,
            Effect.WAVE_HOP,
            Effect.RANGE_WALK,
            Effect.ORIENTATION_SHADOW,
            Effect.OBSTACLE_TURN),
        closed(pole(new Point(0, 0)), every(0.05)));
    assertEquals(
        Set.of(Effect.NO_ECHO_CODE, Effect.PLACEMENT_ERROR, Effect.WAVE_HOP, Effect.RANGE_WALK),
        closed(pole(new Point(0.02, 0)), every(0.05)));
  }

  /** Where strengths are known, a post with flat sides may stand where a round one was. */
  @Test
  void roundPole_mayBeAnotherPost_underTheLevelLaw() {
    SensingSetup pole = pole(new Point(0, 0)).under(SensorLaw.Model.LEVEL);
    assertEquals(false, closed(pole, every(0.05)).contains(Effect.ORIENTATION_SHADOW));
    assertEquals(
        true,
        closed(pole, Ladders.read((range, lot) -> range, 1)).contains(Effect.ORIENTATION_SHADOW));
  }

  /**
   * Noise is what scatters at one placement; what differs from place to place is the tape. A board
   * that is seen from one side only shows nothing of its other sides.
   */
  @Test
  void ladder_mayHavePlacementsThatAreOff_andNoiseWhereItShows() {
    assertEquals(
        Set.of(
            Effect.NO_ECHO_CODE, Effect.RANGE_NOISE, Effect.RANGE_WALK, Effect.ORIENTATION_SHADOW),
        closed(Ladders.BOARD, Ladders.read((range, lot) -> range, 1)));
    assertEquals(
        Set.of(Effect.NO_ECHO_CODE, Effect.RANGE_WALK, Effect.ORIENTATION_SHADOW),
        closed(Ladders.BOARD, Ladders.read((range, lot) -> range + 0.02 * lot, 1)));
  }

  /**
   * Its middle is in the cone of who aims at it; who drives past or looks past it tells nothing.
   */
  @Test
  void turnedBeforeASensor_itStandsWhereThatAims() {
    double coneM = 0.8 * Math.tan(Worlds.POST.sensor().coneHalfAngleRad());
    assertEquals(coneM, mostAsideM(turned(0)), 1e-9);
    assertEquals(1, mostAsideM(turned(60)), 0);
    assertEquals(1, mostAsideM(past()), 0);
  }

  /** A sensor that goes round the post at 0.8 m and looks past its middle by an angle. */
  private static List<ReadingRow> turned(double pastDeg) {
    Placement place = Worlds.POST.scene().obstacles().get(0).worldFromObstacle();
    return IntStream.range(0, 40)
        .mapToObj(
            i -> {
              double x = place.xM() + 0.8 * Math.cos(Math.toRadians(i));
              double z = place.zM() - 0.8 * Math.sin(Math.toRadians(i));
              double headingRad = Math.toRadians(180 + i + pastDeg);
              return new ReadingRow("r", "s", i, Pose.of(x, z, headingRad), NoEcho.NO_ECHO);
            })
        .toList();
  }

  private static List<ReadingRow> past() {
    return IntStream.range(0, 40)
        .mapToObj(i -> new ReadingRow("r", "s", i, Pose.of(0.02 * i - 0.4, 0.8, 0), NoEcho.NO_ECHO))
        .toList();
  }

  private static double mostAsideM(List<ReadingRow> rows) {
    return Gates.open(Worlds.given(rows), Forms.all(Worlds.POST, List.of("s"))).stream()
        .filter(form -> form.effect() == Effect.OBSTACLE_OFFSET)
        .findFirst()
        .orElseThrow()
        .parameters()
        .get(0)
        .high();
  }

  /** A number that stands for "no echo" is read more often than no echo is. */
  @Test
  void numberForNothing_isLookedForWhereItIsReadOftenEnough() {
    assertEquals(true, closed(Worlds.POST, zeros(9)).contains(Effect.NO_ECHO_CODE));
    assertEquals(false, closed(Worlds.POST, zeros(10)).contains(Effect.NO_ECHO_CODE));
  }

  /** Twenty pings of which some read 0 and the others nothing. */
  private static List<ReadingRow> zeros(int count) {
    List<ReadingRow> rows = new ArrayList<>(every(0.05));
    for (int i = 0; i < rows.size(); i++) {
      ReadingRow row = rows.get(i);
      Reading reading = i < count ? new Echo(0) : NoEcho.NO_ECHO;
      rows.set(i, new ReadingRow(row.run(), row.sensor(), row.timeS(), row.pose(), reading));
    }
    return rows;
  }
}
