package simbad.sonar.predict;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.Set;
import java.util.random.RandomGenerator;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import simbad.definition.Effect;
import simbad.sonar.change.Absorption;
import simbad.sonar.change.BeamEdge;
import simbad.sonar.change.BeamMisalignment;
import simbad.sonar.change.BeamPattern;
import simbad.sonar.change.BeamWidth;
import simbad.sonar.change.BearingFactor;
import simbad.sonar.change.Burst;
import simbad.sonar.change.CoarseResolution;
import simbad.sonar.change.CoarseResolution.Reported;
import simbad.sonar.change.Crosstalk;
import simbad.sonar.change.DeadZone;
import simbad.sonar.change.Dropout;
import simbad.sonar.change.EarlyCrosstalk;
import simbad.sonar.change.EarlyTimeout;
import simbad.sonar.change.FloorEcho;
import simbad.sonar.change.Gain;
import simbad.sonar.change.GhostReading;
import simbad.sonar.change.Hysteresis;
import simbad.sonar.change.Latency;
import simbad.sonar.change.MixedMultipath;
import simbad.sonar.change.Multipath;
import simbad.sonar.change.NearClamp;
import simbad.sonar.change.NearLimit;
import simbad.sonar.change.NoiseTails;
import simbad.sonar.change.ObstacleOffset;
import simbad.sonar.change.ObstacleTurn;
import simbad.sonar.change.OrientationShadow;
import simbad.sonar.change.OrientationShadows;
import simbad.sonar.change.RangeNoise;
import simbad.sonar.change.RangeOffset;
import simbad.sonar.change.ScatteredLatency;
import simbad.sonar.change.ScatteredOffset;
import simbad.sonar.change.SensorScatter;
import simbad.sonar.change.SoundSpeed;
import simbad.sonar.change.TailedMultipath;
import simbad.sonar.change.TwoFloorEchoes;
import simbad.sonar.change.WalkingCrosstalk;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.fixture.Scenes;
import simbad.sonar.fixture.Sonars;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Pose;
import simbad.sonar.model.ReadingDistribution;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.Mixture;
import simbad.sonar.ping.Moment;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.RangeChange;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.TableDetection;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.ReadingRow;
import simbad.sonar.shape.ThresholdTable;

/**
 * Each effect on one ping at one box, with figures that can be worked out on paper.
 *
 * <p>The box is 0.25 m wide, its centre 1 m ahead of the sensor, its face 0.875 m; it is lost at
 * 1.2 m. The sensor hears 27.5 degrees either side, from 0.03 m to 6 m, misses a tenth of all
 * echoes, loses them over 0.1 m, scatters by 0.02 m and reports steps of 0.05 m: the face lies in
 * the middle of the step from 0.85 m to 0.9 m, 1.25 standard deviations from both ends.
 */
class EffectsClosedFormTest {
  private static final SensingSetup SETUP = setup(1.2);

  /** Of a standard normal variable: 2 F(1.25) - 1, from a table of F. */
  private static final double WITHIN_1_25 = 0.788700;

  private static final double P = echo(1, 1.2);

  private static SensingSetup setup(double thresholdM) {
    return setup(Scenes.of(Scenes.box(1, 0, thresholdM)));
  }

  private static SensingSetup setup(Scene scene) {
    return new SensingSetup(Sonars.noisy(0.05, 0.02, 0.1, 0.1), scene, 6.5);
  }

  private static double echo(double distanceM, double thresholdM) {
    return 0.9 / (1 + Math.exp((distanceM - thresholdM) / 0.1));
  }

  private static double probability(
      SensingSetup setup, Pose pose, OptionalDouble rangeM, Change... changes) {
    return Logs.likelihood(setup, List.of(Logs.row(0, pose, rangeM)), List.of(changes))[0];
  }

  private static void assertEcho(double expected, Change... changes) {
    double silent = probability(SETUP, Pose.of(0, 0, 0), Logs.SILENCE, changes);
    assertEquals(1 - expected, silent, 1e-6, List.of(changes).toString());
  }

  private static void assertReads(double expected, double rangeM, Change... changes) {
    OptionalDouble range = OptionalDouble.of(rangeM);
    double found = probability(SETUP, Pose.of(0, 0, 0), range, changes);
    assertEquals(expected, found, 1e-6, rangeM + " " + List.of(changes));
  }

  @Test
  void withoutChange() {
    assertEcho(P);
    assertReads(P * WITHIN_1_25, 0.85);
    // Beyond 1.25 deviations, up to 3.75: F(3.75) = 0.9999116.
    assertReads(P * (0.9999116 - 0.8943502), 0.9);
  }

  /**
   * Scaled by 343/unknown so that the face moves from 0.875 m to 0.975 m, again a step's middle.
   */
  @Test
  void soundSpeed_scales() {
    assertReads(P * WITHIN_1_25, 0.95, new SoundSpeed(0.975 / 0.875));
    Form form = Forms.find(Effect.SOUND_SPEED, "scale", SETUP, List.of()).orElseThrow();
    // Time is right, range is what the assumed 343 m/s make of it: slower sound reads longer.
    assertReads(P * WITHIN_1_25, 0.95, form.with(343 * 0.875 / 0.975));
  }

  @Test
  void rangeOffset_shifts_afterTheScale() {
    assertReads(P * WITHIN_1_25, 0.8, new RangeOffset(-0.05));
    // 0.875 doubled is 1.75, and 0.025 more is the middle of a step; the sum doubled were 1.8.
    assertReads(P * WITHIN_1_25, 1.75, new RangeOffset(0.025), new SoundSpeed(2));
    assertEcho(P, new RangeOffset(-0.05));
  }

  @Test
  void rangeOffset_scattersByAShareOfItsSize() {
    // 0.02 and 0.3 times 0.05 make 0.025: the step's ends are 1 deviation away.
    RangeOffset nearer = new RangeOffset(-0.05);
    assertReads(P * 0.6826895, 0.8, new ScatteredOffset(nearer, 0.3));
    assertReads(P * WITHIN_1_25, 0.8, new ScatteredOffset(nearer, 0));
    assertReads(P * WITHIN_1_25, 0.85, new ScatteredOffset(new RangeOffset(0), 0.3));
  }

  /** A range that would fall below 0 is 0. */
  @Test
  void rangeOffset_belowZero_readsZero() {
    assertReads(P, 0, new RangeOffset(-1));
  }

  @Test
  void rangeNoise_addsInSquares() {
    // 0.02 and 0.015 make 0.025: the step's ends are 1 deviation away.
    assertReads(P * 0.6826895, 0.85, new RangeNoise(0.015, 0));
    assertReads(P * 0.6826895, 0.85, new RangeNoise(0, 0.015 / 0.875));
    // 0.02, 0.012 and 0.009 make 0.025 too.
    assertReads(P * 0.6826895, 0.85, new RangeNoise(0.012, 0.009 / 0.875));
    assertEcho(P, new RangeNoise(0.3, 0.1));
  }

  @Test
  void noiseTails_areAShare() {
    double mixed = 0.7 * WITHIN_1_25 + 0.3 * 0.6826895;
    assertReads(P * mixed, 0.85, new NoiseTails(0.3, 0.015));
    assertEcho(P, new NoiseTails(0.3, 0.1));
  }

  /** Steps of 0.25 m: the face lies in the one from 0.75 m, its ends 6.25 deviations away. */
  @Test
  void coarseResolution_readsTheStartOrTheCentre() {
    assertReads(P, 0.75, new CoarseResolution(0.25, Reported.START));
    assertReads(0, 0.85, new CoarseResolution(0.25, Reported.START));
    // The centre, 0.875 m, is rounded down to the sensor's own steps.
    assertReads(P, 0.85, new CoarseResolution(0.25, Reported.CENTRE));
    // 0.85 m is nearer to 0.9 m than to 0.6 m, in steps of 0.3 m.
    assertReads(P, 0.9, new CoarseResolution(0.3, Reported.NEAREST));
    assertReads(0, 0.6, new CoarseResolution(0.3, Reported.NEAREST));
  }

  @Test
  void nearClamp_readsTheLeast() {
    // What is below 1 m, which all is, reads 1 m.
    assertReads(P, 1, new NearClamp(1));
    // Below the face's middle half of it: half reads 0.875 m itself, in the same step.
    double above = P * (0.9999116 - 0.8943502);
    assertReads(above, 0.9, new NearClamp(0.875));
    assertReads(P * 0.8943502, 0.85, new NearClamp(0.875));
    // So does a near limit, and it hears what the sensor is believed to be blind to.
    assertReads(P, 1, new NearLimit(1));
    assertEquals(0, new NearLimit(1).apply(SETUP.sensor()).minRangeM());
    assertEquals(SETUP.sensor(), new NearLimit(0).apply(SETUP.sensor()));
    // Clamped first, then in steps of 0.25 m.
    assertReads(P, 1, new CoarseResolution(0.25, Reported.START), new NearClamp(1.1));
  }

  /** What is drawn is what is reported, not what was measured. */
  @Test
  void drawnReadings_areReported() {
    List<ReadingRow> ping = List.of(Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE));
    RandomGenerator random = new Random(3);
    Map<Change, Double> reports =
        Map.of(
            new NearClamp(1), 1.0,
            new CoarseResolution(0.25, Reported.START), 0.75,
            new CoarseResolution(0.3, Reported.NEAREST), 0.9);
    reports.forEach(
        (change, rangeM) -> {
          ReadingDistribution reading = Logs.forecast(SETUP, ping, List.of(change)).get(0);
          for (int i = 0; i < 50; i++) {
            if (reading.sample(random) instanceof Echo echo) {
              assertEquals(rangeM, echo.rangeM(), 1e-9, change.toString());
            }
          }
        });
  }

  /** So many boxes at one place are silent when each of them is. */
  @Test
  void manyObstacles_areAllAsked() {
    Obstacle[] boxes = new Obstacle[20];
    Arrays.fill(boxes, Scenes.box(1, 0, 1.2));
    SensingSetup crowd = setup(Scenes.of(boxes));
    Pose pose = Pose.of(0, 0, 0);
    Change gain = new Gain(0.9);
    double p = echo(1, 0.9 * 1.2);
    assertEquals(Math.pow(1 - p, 20), probability(crowd, pose, Logs.SILENCE, gain), 1e-9);
  }

  /** Parameters that say more than one thing: what a form makes of them. */
  @Test
  void forms_spreadTheirValues() {
    checkMade(new Multipath(0.3, 1, 0.6, 0.06), Effect.MULTIPATH, "added", 0.3, 0.6, 0.1);
    checkMade(new Multipath(0.3, 1.5, 0, 0.05), Effect.MULTIPATH, "factor", 0.3, 1.5, 0.1);
    checkMade(new Hysteresis(0.9, 1.1), Effect.HYSTERESIS, "both", 0.2);
    checkMade(new Hysteresis(0.8, 1), Effect.HYSTERESIS, "pick-up", 0.2);
    checkMade(new Hysteresis(1, 1.2), Effect.HYSTERESIS, "hold", 0.2);
    checkMade(new Crosstalk(0.2, 0.5, 2.5, false), Effect.CROSSTALK, "any", 0.2, 0.5, 2);
  }

  private static void checkMade(Change expected, Effect effect, String name, double... values) {
    Form form = Forms.find(effect, name, SETUP, List.of()).orElseThrow();
    assertEquals(expected, form.with(values));
    // A form is its name, whatever set-up it was made for.
    assertEquals(form, Forms.find(effect, name, setup(2), List.of("left")).orElseThrow());
    Form other = Forms.find(Effect.GAIN, "factor", SETUP, List.of()).orElseThrow();
    assertNotEquals(form, other);
    assertEquals(2, Set.of(form, other).size());
  }

  @Test
  void crosstalk_ofAnyPing_hidesTheEcho() {
    Change crosstalk = new Crosstalk(0.2, 0.5, 4.5, false);
    assertEcho(0.8 * P + 0.2, crosstalk);
    assertReads(0.8 * P * WITHIN_1_25 + 0.2 * 0.05 / 4, 0.85, crosstalk);
    assertReads(0.2 * 0.05 / 4, 3, crosstalk);
    assertReads(0, 4.55, crosstalk);
  }

  @Test
  void crosstalk_ofSilentPings_leavesTheEcho() {
    Change crosstalk = new Crosstalk(0.2, 0.5, 4.5, true);
    assertEcho(P + 0.2 * (1 - P), crosstalk);
    assertReads(P * WITHIN_1_25 + 0.2 * (1 - P) * 0.05 / 4, 0.85, crosstalk);
  }

  /** Half of the band from 0.375 m to 1.375 m lies before the face. */
  @Test
  void earlyCrosstalk_bandBeginsWhereItSays() {
    Change crosstalk = new EarlyCrosstalk(0.2, 0.375, 1.375);
    double foreign = 0.1 * P * 0.025 / 0.5 + 0.2 * (1 - P) * 0.05;
    assertReads(0.9 * P * WITHIN_1_25 + foreign, 0.85, crosstalk);
    assertReads(0.1 * P * 0.05 / 0.5 + 0.2 * (1 - P) * 0.05, 0.5, crosstalk);
  }

  /** What a range was before a change is what it is a change of. */
  @Test
  void rangeChanges_areUndone() {
    List<RangeChange> changes =
        List.of(
            new SoundSpeed(1.1),
            new RangeOffset(-0.05),
            new ScatteredOffset(new RangeOffset(0.3), 0.1),
            new RangeNoise(0.1, 0.1));
    for (RangeChange change : changes) {
      assertEquals(0.875, change.rangeM(change.meanM(0.875)), 1e-12, change.toString());
    }
    assertEquals(
        new RangeOffset(0.3).order(), new ScatteredOffset(new RangeOffset(0.3), 0.1).order());
    assertReads(
        P * WITHIN_1_25, 1.75, new ScatteredOffset(new RangeOffset(0.025), 0), new SoundSpeed(2));
  }

  /** Even parts are drawn evenly: of 10,000 the mean lies within 5 of its deviations. */
  @Test
  void evenParts_areDrawnEvenly() {
    Mixture mixture = new Mixture();
    mixture.addEven(1, 2, 1);
    RandomGenerator random = new Random(5);
    DoubleSummaryStatistics drawn =
        DoubleStream.generate(() -> mixture.drawM(0, random)).limit(10_000).summaryStatistics();
    assertTrue(drawn.getMin() >= 1 && drawn.getMin() < 1.01, drawn.toString());
    assertTrue(drawn.getMax() <= 2 && drawn.getMax() > 1.99, drawn.toString());
    assertEquals(1.5, drawn.getAverage(), 5 * Math.sqrt(1 / 12.0 / 10_000));
  }

  @Test
  void crosstalk_thatComesEarlier_hidesTheEcho() {
    Change crosstalk = new EarlyCrosstalk(0.2, 0, 3.5);
    // A quarter of the span lies before the face.
    assertEcho(P + 0.2 * (1 - P), crosstalk);
    double density = 0.2 / 3.5;
    assertReads(0.05 * density, 0.5, crosstalk);
    assertReads((1 - P) * 0.05 * density, 2, crosstalk);
    double half = 0.025 * density;
    assertReads(P * (0.95 * WITHIN_1_25 + half) + (1 - P) * 0.05 * density, 0.85, crosstalk);
  }

  @Test
  void multipath_isAShareOfTheEchoes() {
    Change added = new Multipath(0.4, 1, 0.3, 0);
    assertReads(0.6 * P * WITHIN_1_25, 0.85, added);
    assertReads(0.4 * P * WITHIN_1_25, 1.15, added);
    assertReads(0.4 * P * WITHIN_1_25, 1.75, new Multipath(0.4, 2, 0.025, 0));
    assertReads(0.4 * P * 0.6826895, 1.15, new Multipath(0.4, 1, 0.3, 0.015));
    assertEcho(P, added);
    Change both = new MixedMultipath(new Multipath(0.4, 1, 0.3, 0), new Multipath(0.5, 2, 0, 0));
    assertReads(0.4 * P * WITHIN_1_25, 1.15, both);
    assertReads(0.6 * 0.5 * P * WITHIN_1_25, 0.85, both);
    assertEcho(P, both);
  }

  /** The sensor of the set-up listens up to its greatest range. */
  @Test
  void multipath_beyondTheGreatestRangeIsLost() {
    double most = SETUP.sensor().maxRangeM();
    Change beyond = new Multipath(0.4, 1, most, 0);
    assertEcho(0.6 * P, beyond);
    assertReads(0.6 * P * WITHIN_1_25, 0.85, beyond);
    assertEcho(0.6 * P, new MixedMultipath(new Multipath(0, 1, 0, 0), new Multipath(0.4, 9, 0, 0)));
    Mixture mixture = new Mixture();
    mixture.add(most - 0.3, 0, 1);
    Moment any = new Moment(new Geometry(new PingLog(List.of()), SETUP, List.of()));
    new TailedMultipath(1, 0.3).apply(any, mixture);
    assertEquals(1 - Math.exp(-1), mixture.echoShare(), 0.03);
  }

  /** Of an exponential distribution of mean 0.3 m: mean and variance as they are. */
  @Test
  void multipath_withATail_keepsTheMoments() {
    Mixture mixture = new Mixture();
    mixture.add(1, 0.02, 0.5);
    Moment any = new Moment(new Geometry(new PingLog(List.of()), SETUP, List.of()));
    new TailedMultipath(0.4, 0.3).apply(any, mixture);
    double share = 0;
    double mean = 0;
    double square = 0;
    for (int part = 1; part < mixture.size(); part++) {
      double from = mixture.meanM(part);
      share += mixture.share(part);
      mean += mixture.share(part) * from;
      square += mixture.share(part) * (from * from + Math.pow(mixture.deviationM(part), 2));
    }
    assertEquals(0.3, mixture.share(0), 1e-12);
    assertEquals(0.2, share, 1e-12);
    assertEquals(1.3, mean / share, 1e-12);
    assertEquals(0.3 * 0.3 + 0.02 * 0.02, square / share - 1.3 * 1.3, 1e-12);
    // A quarter of the detours is shorter than 0.3 ln(4/3) = 0.0863 m, half than 0.2079 m.
    assertEquals(0.25, (mixture.within(1, 1.0863) - 0.3 / 2) / 0.2, 0.06);
    assertEquals(0.5, (mixture.within(1, 1.2079) - 0.3 / 2) / 0.2, 0.06);
    assertEcho(P, new TailedMultipath(0.4, 0.3));
  }

  /** 0.225 m, 0.525 m, and 0.825 m, which is 0.225 m again: all are the middles of steps. */
  @Test
  void crosstalk_thatWalks_isReadWhereItComesFirst() {
    Change crosstalk = new WalkingCrosstalk(0.3, 0, 0.6, 0.3, 0.225, 0.015);
    double[] expected = {0.2, 0.5, 0.2};
    for (int ping = 0; ping < expected.length; ping++) {
      OptionalDouble[] read = {Logs.SILENCE, Logs.SILENCE, Logs.SILENCE};
      read[ping] = OptionalDouble.of(expected[ping]);
      double found = sequence(List.of(crosstalk), read)[ping];
      assertEquals(0.3 * 0.6826895, found, 1e-6, "ping " + ping);
    }
    assertEcho(0.3 + 0.7 * P, crosstalk);
    assertReads(0.7 * P * WITHIN_1_25, 0.85, crosstalk);
    // Of the band from 0.3 m to 0.9 m: 0.225 m lies before it, which is 0.825 m, and then 0.525 m.
    Change farther = new WalkingCrosstalk(0.3, 0.3, 0.6, 0.3, 0.225, 0.015);
    assertReads(0.3 * 0.6826895 + 0.7 * P * (0.1056498 - 0.0000884), 0.8, farther);
    double next = sequence(List.of(farther), Logs.SILENCE, OptionalDouble.of(0.5))[1];
    assertEquals(0.3 * 0.6826895, next, 1e-6);
  }

  /** Pings from the same place, 0.1 s apart. */
  private static double[] sequence(List<Change> changes, OptionalDouble... read) {
    List<ReadingRow> rows = new ArrayList<>();
    for (int ping = 0; ping < read.length; ping++) {
      rows.add(Logs.row(0.1 * ping, Pose.of(0, 0, 0), read[ping]));
    }
    return Logs.likelihood(SETUP, rows, changes);
  }

  /** The ghost of a reading of 0.85 m is read at 2 * 0.85 - 1.175 = 0.525, or 0.4 farther. */
  @Test
  void ghostReading_isMadeOfTheReadingBefore() {
    OptionalDouble before = OptionalDouble.of(0.85);
    for (boolean onlyNearer : new boolean[] {true, false}) {
      List<Change> near = List.of(new GhostReading(0.3, 2, 1.175, 0.016, onlyNearer));
      double ghost = 0.3 * (2 * 0.940915 - 1); // 0.025 / 0.016 is 1.5625 deviations.
      assertEquals(ghost, sequence(near, before, OptionalDouble.of(0.5))[1], 1e-5);
      double own = 0.7 * P * WITHIN_1_25;
      assertEquals(own, sequence(near, before, OptionalDouble.of(0.85))[1], 1e-6);
      assertEquals(0.7 * (1 - P), sequence(near, before, Logs.SILENCE)[1], 1e-6);
      assertEquals(1 - P, sequence(near, Logs.SILENCE, Logs.SILENCE)[1], 1e-6);
      List<Change> far = List.of(new GhostReading(0.3, 2, 0.425, 0.001, onlyNearer));
      double taken = onlyNearer ? 0.3 * (1 - P) : 0.3;
      assertEquals(taken, sequence(far, before, OptionalDouble.of(1.25))[1], 1e-6);
      double left = (onlyNearer ? 1 : 0.7) * P * WITHIN_1_25;
      assertEquals(left, sequence(far, before, OptionalDouble.of(0.85))[1], 1e-6);
    }
  }

  /** A ghost of nearly the range before would be any reading that resembles the one before. */
  @Test
  void ghostReading_thatComesAgain_isNone() {
    OptionalDouble before = OptionalDouble.of(0.85);
    List<Change> again = List.of(new GhostReading(0.3, 0.9, -0.06, 0.001, false));
    assertEquals(P * WITHIN_1_25, sequence(again, before, before)[1], 1e-6);
    List<Change> away = List.of(new GhostReading(0.3, 0.9, 0.14, 0.001, false));
    assertEquals(0.3, sequence(away, before, OptionalDouble.of(0.6))[1], 1e-6);
  }

  /** Twice with a ghost whatever was read: silent only when no ghost and no echo comes. */
  @Test
  void ghostReading_runsForward() {
    List<ReadingRow> rows =
        List.of(
            Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE),
            Logs.row(0.1, Pose.of(0, 0, 0), Logs.SILENCE));
    Change ghost = new GhostReading(0.3, 1, 0.5, 0, false);
    double silent = Logs.forecast(SETUP, rows, List.of(ghost)).get(1).noEchoProbability();
    assertEquals((1 - P) * (1 - P) + P * 0.7 * (1 - P), silent, 1e-6);
  }

  @Test
  void dropout_losesPings() {
    assertEcho(0.7 * P, new Dropout(0.3));
    assertEcho(P * (1 - 0.4 * 0.5), new Burst(0.4, 5, 0.5));
    assertEcho(0.7 * P * (1 - 0.4 * 0.5), new Dropout(0.3), new Burst(0.4, 5, 0.5));
  }

  @Test
  void gain_scalesTheThreshold() {
    assertEcho(echo(1, 0.96), new Gain(0.8));
    assertReads(echo(1, 0.96) * WITHIN_1_25, 0.85, new Gain(0.8));
  }

  @ParameterizedTest
  @CsvSource({"0.3, EXPONENTIAL", "0.3, HYPERBOLIC", "0.3, BALANCED", "-0.1, HYPERBOLIC"})
  void absorption_shrinksTheThreshold(double perM, Absorption.Law law) {
    double threshold =
        switch (law) {
          case EXPONENTIAL -> 1.2 * Math.exp(-0.36);
          case HYPERBOLIC -> 1.2 / (1 + 1.2 * perM);
          case BALANCED -> balanced(perM);
        };
    assertEcho(echo(1, threshold), new Absorption(perM, law));
  }

  /** The t of t exp(a t) = 1.2, by halving. */
  private static double balanced(double perM) {
    double low = 0;
    double high = 1.2;
    for (int i = 0; i < 60; i++) {
      double middle = (low + high) / 2;
      if (middle * Math.exp(perM * middle) < 1.2) {
        low = middle;
      } else {
        high = middle;
      }
    }
    return low;
  }

  /** Newton's steps are enough for the strongest loss over the farthest threshold of a table. */
  @Test
  void absorption_balance_isReached() {
    double threshold = 100;
    SensingSetup far = setup(threshold);
    PingLog log = new PingLog(List.of(Logs.row(0, Pose.of(0, 0, 0), Logs.SILENCE)));
    double factor =
        new Absorption(1.5, Absorption.Law.BALANCED).factor(new Geometry(log, far, List.of()), 0);
    double t = factor * threshold;
    assertEquals(threshold, t * Math.exp(1.5 * t), 1e-6);
  }

  /** The sensor looks 10 degrees past the box. */
  @ParameterizedTest
  @CsvSource({"BELL, 20, 1.5, 0.882497", "COSINE, 20, 2, 0.5", "RAMP, 20, 2, 0.25"})
  void beamPattern_tapers(BeamPattern.Law law, double widthDeg, double power, double factor) {
    // exp(-0.5^3), cos^2(45 degrees), (1 - 0.5)^2.
    Pose aside = Pose.of(0, 0, Math.toRadians(-10));
    Change taper = new BeamPattern(Math.toRadians(widthDeg), power, law, BeamPattern.Angle.CENTRE);
    double silent = probability(SETUP, aside, Logs.SILENCE, taper);
    assertEquals(1 - echo(1, 1.2 * factor), silent, 1e-6);
    Change narrow = new BeamPattern(Math.toRadians(5), 1, law, BeamPattern.Angle.CENTRE);
    if (law != BeamPattern.Law.BELL) {
      assertEquals(1, probability(SETUP, aside, Logs.SILENCE, narrow), 1e-12);
    }
  }

  /**
   * From (0, 0.3) the nearest point is the corner at 0.875, 0.125: atan(0.175 / 0.875) to the left.
   * Turned 45 degrees to the left, the sensor has it out of its cone of 27.5 degrees.
   */
  @Test
  void nearestOffAxis_isTheCornersOrTheBorders() {
    double toCornerRad = Math.atan2(0.175, 0.875);
    for (double turnedRad : new double[] {0, Math.toRadians(20), Math.toRadians(-5)}) {
      Geometry geometry = geometry(Pose.of(0, 0.3, turnedRad));
      assertEquals(Math.abs(toCornerRad - turnedRad), Math.abs(geometry.echoOffAxisRad(0)), 1e-9);
    }
    Geometry aside = geometry(Pose.of(0, 0.3, Math.toRadians(45)));
    assertEquals(Math.toRadians(27.5), aside.echoOffAxisRad(0), 1e-9);
  }

  private static Geometry geometry(Pose pose) {
    return new Geometry(new PingLog(List.of(Logs.row(0, pose, Logs.SILENCE))), SETUP, List.of());
  }

  /** 40 degrees aside the near corner is at 40 - atan(0.125 / 0.875) = 31.87 degrees. */
  @Test
  void beamWidth_movesTheBorder() {
    Pose aside = Pose.of(0, 0, Math.toRadians(40));
    assertEquals(1, probability(SETUP, aside, Logs.SILENCE));
    Change wider = new BeamWidth(Math.toRadians(10));
    assertEquals(1 - P, probability(SETUP, aside, Logs.SILENCE, wider), 1e-12);
    Pose lessAside = Pose.of(0, 0, Math.toRadians(30));
    Change narrower = new BeamWidth(Math.toRadians(-10));
    assertEquals(1 - P, probability(SETUP, lessAside, Logs.SILENCE), 1e-12);
    assertEquals(1, probability(SETUP, lessAside, Logs.SILENCE, narrower));
  }

  @Test
  void beamEdge_isHalfAtTheBorder() {
    // The corner at 0.875, 0.125 lies atan(1/7) to the right; here 27.5 degrees from the heading.
    Pose atBorder = Pose.of(0, 0, -Math.toRadians(27.5) - Math.atan2(0.125, 0.875));
    Change soft = new BeamEdge(Math.toRadians(2));
    assertEquals(1 - P / 2, probability(SETUP, atBorder, Logs.SILENCE, soft), 1e-9);
    Pose ahead = Pose.of(0, 0, 0);
    double inside = 1 / (1 + Math.exp(-27.5 / 2));
    assertEquals(1 - P * inside, probability(SETUP, ahead, Logs.SILENCE, soft), 1e-9);
    Pose beyond = Pose.of(0, 0, -Math.toRadians(27.5 + 2 * Math.log(9)) - Math.atan2(0.125, 0.875));
    assertEquals(1 - P / 10, probability(SETUP, beyond, Logs.SILENCE, soft), 1e-9);
  }

  @Test
  void beamMisalignment_turnsTheCone() {
    Change left = new BeamMisalignment(Math.toRadians(40), Optional.empty());
    assertEcho(0, left);
    Pose right = Pose.of(0, 0, Math.toRadians(-40));
    assertEquals(1 - P, probability(SETUP, right, Logs.SILENCE, left), 1e-12);
    assertEcho(P, new BeamMisalignment(Math.toRadians(40), Optional.of("another")));
    assertEcho(0, new BeamMisalignment(Math.toRadians(40), Optional.of("sonar")));
  }

  @Test
  void floorEcho_answersWhenNothingNearerDoes() {
    Change beyond = new FloorEcho(1.475, 0, 0.6);
    assertReads(P * WITHIN_1_25, 0.85, beyond);
    assertReads((1 - P) * 0.6 * WITHIN_1_25, 1.45, beyond);
    Change before = new FloorEcho(0.475, 0.015, 0.6);
    assertReads(0.6 * 0.6826895, 0.45, before);
    assertReads(0.4 * P * WITHIN_1_25, 0.85, before);
    assertEcho(P + (1 - P) * 0.6, beyond);
    Change two = new TwoFloorEchoes(new FloorEcho(1.475, 0, 0.6), 0.2, 0.5);
    assertReads((1 - P) * 0.4 * 0.5 * WITHIN_1_25, 1.65, two);
  }

  @Test
  void deadZone_losesNearEchoes() {
    assertEcho(0, new DeadZone(0.9, 0));
    assertEcho(P, new DeadZone(0.87, 0));
    assertEcho(P / (1 + Math.exp((0.9 - 0.875) / 0.05)), new DeadZone(0.9, 0.05));
  }

  @Test
  void earlyTimeout_losesFarEchoes() {
    assertEcho(0, new EarlyTimeout(0.87, 0));
    assertEcho(P, new EarlyTimeout(0.88, 0));
    assertEcho(P / (1 + Math.exp((0.875 - 0.85) / 0.05)), new EarlyTimeout(0.85, 0.05));
  }

  @Test
  void obstacleOffset_movesTheBox() {
    assertEcho(echo(1.1, 1.2), new ObstacleOffset(0.1, 0, Optional.empty()));
    assertReads(echo(1.1, 1.2) * WITHIN_1_25, 0.95, new ObstacleOffset(0.1, 0, Optional.of("box")));
    assertEcho(P, new ObstacleOffset(0.1, 0, Optional.of("post")));
    // Moved towards the eye's lower edge of the page the centre is hypot(1, 0.3) away.
    assertEcho(echo(Math.hypot(1, 0.3), 1.2), new ObstacleOffset(0, 0.3, Optional.empty()));
  }

  /** Turned by a quarter clockwise the bearing of the sensor grows by 90 degrees. */
  @Test
  void obstacleTurn_showsAnotherSide() {
    ThresholdTable four = ThresholdTable.of(0.9, 1.0, 1.1, 1.3);
    Obstacle box = Scenes.box(new Placement(1, 0, 0), new TableDetection(four));
    SensingSetup sided = setup(Scenes.of(box));
    Pose pose = Pose.of(0, 0, 0);
    // The sensor stands on the box's -x side: bearing 270 degrees.
    assertEquals(1 - echo(1, 1.3), probability(sided, pose, Logs.SILENCE), 1e-9);
    Change clockwise = new ObstacleTurn(-Math.PI / 2, Optional.empty());
    assertEquals(1 - echo(1, 0.9), probability(sided, pose, Logs.SILENCE, clockwise), 1e-9);
    Change counter = new ObstacleTurn(Math.PI / 2, Optional.of("box"));
    assertEquals(1 - echo(1, 1.1), probability(sided, pose, Logs.SILENCE, counter), 1e-9);
  }

  @Test
  void orientationShadow_replacesTheUniformThreshold() {
    ThresholdTable four = ThresholdTable.of(0.9, 1.0, 1.1, 1.3);
    assertEcho(echo(1, 1.3), new OrientationShadow(Optional.of("box"), four));
    assertEcho(P, new OrientationShadow(Optional.of("post"), four));
    assertEcho(
        echo(1, 1.1), new OrientationShadow(Optional.empty(), ThresholdTable.uniform(4, 1.1)));
    OrientationShadow post = new OrientationShadow(Optional.of("post"), four);
    OrientationShadow box = new OrientationShadow(Optional.of("box"), four);
    assertEcho(echo(1, 1.3), new OrientationShadows(List.of(post, box)));
    assertEcho(P, new OrientationShadows(List.of(post)));
    assertTrue(new OrientationShadows(List.of(post, post)).isIdle(List.of("box")));
    assertFalse(new OrientationShadows(List.of(post, box)).isIdle(List.of("box")));
  }

  /** 5 cm nearer from ping to ping and 0.3 periods uncertain: 0.015 m, with 0.02 m 0.025 m. */
  @Test
  void scatteredLatency_scattersAsTheRangeChanges() {
    List<ReadingRow> rows =
        List.of(
            Logs.row(0, Pose.of(-0.05, 0, 0), OptionalDouble.of(0.9)),
            Logs.row(0.1, Pose.of(0, 0, 0), OptionalDouble.of(0.85)));
    List<Change> changes = List.of(new ScatteredLatency(new Latency(0), 0.3));
    double[] found = Logs.likelihood(SETUP, rows, changes);
    assertEquals(echo(1.05, 1.2) * WITHIN_1_25, found[0], 1e-6);
    assertEquals(P * 0.6826895, found[1], 1e-6);
  }

  /**
   * Calibrations of the set-up: absolute scatter, and a factor that goes round with the bearing.
   */
  @Test
  void calibration() {
    double softer = 0.8 / (1 + Math.exp((1 - 1.2) / 0.2));
    assertEcho(softer, new SensorScatter(0.2, 0.02, 0.2));
    assertReads(softer * 0.6826895, 0.85, new SensorScatter(0.2, 0.025, 0.2));
    // At bearing 270: cos is 0, sin -1, cos 2b is -1, sin 2b 0.
    List<Double> series = List.of(0.1, 9.0, 0.02, 0.05, 9.0);
    assertEcho(
        echo(1, 1.2 * (1 + 0.1 - 0.02 - 0.05)), new BearingFactor(Optional.of("box"), series));
    assertEcho(P, new BearingFactor(Optional.of("post"), series));
    assertEcho(echo(1, 1.2 * (1 + 0.1 - 0.02 - 0.05)), new BearingFactor(Optional.empty(), series));
    assertEcho(0, new BearingFactor(Optional.of("box"), List.of(-2.0)));
  }
}
