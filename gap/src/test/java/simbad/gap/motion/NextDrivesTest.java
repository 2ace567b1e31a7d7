package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** Drives for a robot that was told up to 0.4 m/s and 0.8 rad/s. */
class NextDrivesTest {
  private static final double EXACT = 1e-9;
  private static final Noise TRACKER = Noise.believed(0.001);
  private static final Noise[] NOISES = {TRACKER, TRACKER, TRACKER};

  /** In which steps do not hang together. */
  private static final Noise[] ROUGH = rough(0.02);

  private static Noise[] rough(double process) {
    Noise noise = new Noise(1e-6, process, Noise.GAUSSIAN);
    return new Noise[] {noise, noise, noise};
  }

  private static final List<MotionRun> RUNS =
      List.of(
          new MotionRun(
              "a",
              List.of(new Command(0, 0.4, -0.8), new Command(2, 0.1, 0.2)),
              List.of(new TrackPose(0, 0, 0, 0), new TrackPose(5, 0, 0, 0))));

  private static ScoredMotion set(Noise[] noises, String name, double... values) {
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    MotionForm form = MotionForms.find(name).orElseThrow();
    MotionSteps given = new MotionSteps(RUNS);
    MotionHypothesis set = none.with(form, values);
    double[][] residuals = given.residuals(set.chain());
    return ScoredMotion.of(given, new MotionFit(set, residuals, noises, 0));
  }

  private static Optional<MotionDiagnosis.NextDrive> between(double one, double other, String of) {
    return new NextDrives(CommandUse.of(RUNS, 0))
        .between(set(NOISES, of, one), set(NOISES, of, other), List.of("b", "c"));
  }

  /** The longest ways at the greatest speed. */
  @Test
  void scalesOfTheWayAreToldApartStraightOn() {
    MotionDiagnosis.NextDrive drive = between(1, 1.02, "speed-scale").orElseThrow();
    List<Command> straight = new ArrayList<>();
    for (int i = 0; i < 8; i++) {
      straight.add(new Command(4 * i, i < 4 ? 0.4 : 0.4 / 3, 0));
    }
    straight.add(new Command(32, 0, 0));

    assertEquals(List.of("b", "c"), drive.separates());
    assertEquals(straight, drive.commands());
  }

  private static Optional<MotionDiagnosis.NextDrive> rough(Noise[] noises, double factor) {
    return new NextDrives(CommandUse.of(RUNS, 0))
        .between(
            set(noises, "speed-scale", 1), set(noises, "speed-scale", factor), List.of("b", "c"));
  }

  /** Twice as far apart is four times as much, and scatter twice as large a quarter. */
  @Test
  void whatADriveTellsGrowsByTheSquare() {
    double one = rough(ROUGH, 1.1).orElseThrow().expectedLogOdds();
    double two = rough(ROUGH, 1.2).orElseThrow().expectedLogOdds();
    double vague = rough(rough(0.04), 1.1).orElseThrow().expectedLogOdds();

    assertEquals(4, two / one, 1e-3);
    assertEquals(0.25, vague / one, 1e-3);
  }

  /** Below a nat it is not worth while. */
  @Test
  void whatTellsNextToNothingIsNoDrive() {
    double nats = rough(ROUGH, 1.1).orElseThrow().expectedLogOdds();
    double even = 0.1 / Math.sqrt(nats);

    assertTrue(rough(ROUGH, 1 + 0.99 * even).isEmpty());
    assertTrue(rough(ROUGH, 1 + 1.01 * even).isPresent());
    assertTrue(rough(ROUGH, 1).isEmpty());
  }

  /** A ladder of turns by turns to either side, on the spot or on the way. */
  @Test
  void scalesOfTheTurnAreToldApartByTurning() {
    List<Command> commands = between(1, 1.02, "turn-scale").orElseThrow().commands();

    assertEquals(9, commands.size());
    for (int i = 0; i < 8; i++) {
      double part = (i + 1) / 8.0;
      double side = i % 2 == 0 ? -1 : 1;
      assertEquals(2 * i, commands.get(i).timeS(), EXACT);
      assertEquals(0.4 * part, commands.get(i).speedMPerS(), EXACT);
      assertEquals(side * (1 - part / 2) * 0.8, commands.get(i).turnRadPerS(), EXACT);
    }
    assertEquals(new Command(16, 0, 0), commands.get(8));
  }

  /** A robot that was never told to move is told 0.2 m/s and 0.5 rad/s. */
  @Test
  void whatWasNeverToldIsTaken() {
    MotionRun stands = new MotionRun("a", List.of(Command.STAND), RUNS.get(0).track());
    NextDrives next = new NextDrives(CommandUse.of(List.of(stands), 0));
    List<String> names = List.of("b", "c");
    List<Command> ways =
        next.between(set(NOISES, "speed-scale", 1), set(NOISES, "speed-scale", 1.1), names)
            .orElseThrow()
            .commands();
    List<Command> turns =
        next.between(set(NOISES, "turn-scale", 1), set(NOISES, "turn-scale", 1.1), names)
            .orElseThrow()
            .commands();

    assertEquals(new Command(0, 0.2, 0), ways.get(0));
    assertEquals(0.2, turns.get(7).speedMPerS(), EXACT);
    assertEquals(0.25, turns.get(7).turnRadPerS(), EXACT);
  }
}
