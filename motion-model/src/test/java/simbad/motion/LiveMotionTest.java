package simbad.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

/** A commanded robot as it goes, against figures worked out on paper and against recorded runs. */
class LiveMotionTest {
  private static MotionChange change(String form, double... values) {
    return MotionForms.find(form).orElseThrow().change(values);
  }

  private static LiveMotion live(MotionChange... changes) {
    return new LiveMotion(new MotionChain(List.of(changes)));
  }

  /** Drives for a second in steps of 50 ms. */
  private static double[] second(LiveMotion motion, double speed, double turn) {
    double way = 0;
    double angle = 0;
    for (int i = 0; i < 20; i++) {
      motion.step(speed, turn, 0.05);
      way += motion.wayM();
      angle += motion.turnRad();
    }
    return new double[] {way, angle};
  }

  @Test
  void exactRobot_doesWhatItIsTold_toTheBit() {
    LiveMotion motion = new LiveMotion(MotionChain.EXACT);
    motion.step(0.3, -0.7, 0.05);
    assertEquals(0.3 * 0.05, motion.wayM());
    assertEquals(-0.7 * 0.05, motion.turnRad());
  }

  /** No time, no motion, and nothing to remember: steps after it are those without it. */
  @Test
  void stepOfNoTime_changesNothing() {
    for (MotionForm form : MotionForms.ALL) {
      double[] values =
          form.parameters().stream().mapToDouble(p -> p.within(p.neutral() + 0.2)).toArray();
      LiveMotion one = live(form.change(values));
      LiveMotion other = live(form.change(values));
      for (int i = 0; i < 8; i++) {
        other.step(-1, 2, 0);
        assertEquals(0, other.wayM());
        assertEquals(0, other.turnRad());
        one.step(0.3, i, 0.05);
        other.step(0.3, i, 0.05);
        assertEquals(one.wayM(), other.wayM(), form.toString());
        assertEquals(one.turnRad(), other.turnRad(), form.toString());
      }
    }
  }

  @Test
  void scales_andBias_areThatMuch() {
    double[] way = second(live(change("speed-scale", 0.9), change("turn-bias", 0.1)), 1, 0.5);
    assertEquals(0.9, way[0], 1e-12);
    assertEquals(0.6, way[1], 1e-12);
    assertEquals(0.45, second(live(change("turn-scale", 0.9)), 1, 0.5)[1], 1e-12);
    assertEquals(0.2, second(live(change("wheel-asymmetry", 0.2)), 1, 0)[1], 1e-12);
  }

  /**
   * A quarter of a second late is a quarter of a metre short at 1 m/s, and 12.5 cm after a stop.
   */
  @Test
  void latency_holdsBackWhatWasCommanded() {
    LiveMotion motion = live(change("actuation-latency", 0.25));
    assertEquals(0.75, second(motion, 1, 0)[0], 1e-12);
    assertEquals(0.25, second(motion, 0, 0)[0], 1e-12);
    motion.stop();
    assertEquals(0.75, second(motion, 1, 0)[0], 1e-12);
    // Late by no whole number of steps.
    assertEquals(0.877, second(live(change("actuation-latency", 0.123)), 1, 0)[0], 1e-12);
  }

  /** With a time constant of half a second the way is 1 - 0.5 (1 - exp(-2)). */
  @Test
  void lag_approachesTheCommand() {
    double way = second(live(change("actuation-lag: time constants", 0.5, 0.5)), 1, 0)[0];
    assertEquals(1 - 0.5 * (1 - Math.exp(-2)), way, 1e-12);
  }

  @Test
  void deadBand_andSaturation_cutCommands() {
    assertEquals(0, second(live(change("dead-band", 0.1, 0.1)), 0.05, 0.05)[0]);
    assertEquals(0.5, second(live(change("saturation: speed", 0.5)), 1, 0)[0], 1e-12);
  }

  /** The same chain and commands as a recorded run has: the same way, however they are stepped. */
  @Test
  void everyForm_goesAsInARecordedRun() {
    Robot wheels = new Robot(true, 0.3, false, 0, 0, MotionChain.EXACT);
    for (MotionForm form : MotionForms.of(wheels)) {
      MotionChange change = form.change(tried(form));
      boolean moves = !form.clocks() && change.capture(Capture.CENTRE).equals(Capture.CENTRE);
      if (moves) {
        checkAsRecorded(form.form(), new MotionChain(List.of(change)));
      }
    }
  }

  /** What a fit tries last of each value. */
  private static double[] tried(MotionForm form) {
    CommandUse use =
        new CommandUse(
            new double[] {0.1, 0.3, 0.6}, new double[] {0.2, 1}, new double[] {0.1, 0.5});
    double[] values = form.neutralValues();
    for (int i = 0; i < values.length; i++) {
      double[] tries = form.parameters().get(i).tries().apply(use);
      values[i] = form.parameters().get(i).within(tries[tries.length - 1]);
    }
    return values;
  }

  private static void checkAsRecorded(String name, MotionChain chain) {
    Random random = new Random(3);
    List<Command> commands = new ArrayList<>();
    for (int i = 0; i < 60; i++) {
      double speed = random.nextDouble(-0.2, 0.6);
      commands.add(new Command(0.1 * i, speed, random.nextDouble(-1, 1)));
    }
    MotionRun run = new MotionRun("run", commands, List.of());
    Displacement recorded = Way.of(run, chain, 0, 6).between(0, 6);
    LiveMotion motion = new LiveMotion(chain);
    TrackPose pose = new TrackPose(0, 0, 0, 0);
    TrackPose start = pose;
    for (int i = 0; i < 300; i++) {
      Command command = commands.get(i / 5);
      motion.step(command.speedMPerS(), command.turnRadPerS(), Way.STEP_S);
      pose =
          Unicycle.advance(
              pose, motion.wayM() / Way.STEP_S, motion.turnRad() / Way.STEP_S, Way.STEP_S);
    }
    Displacement live = Displacement.between(start, pose);
    for (int c = 0; c < 3; c++) {
      assertEquals(recorded.component(c), live.component(c), 1e-9, name + " " + c);
    }
  }

  @Test
  void durations_areChecked() {
    LiveMotion motion = new LiveMotion(MotionChain.EXACT);
    assertThrows(IllegalArgumentException.class, () -> motion.step(1, 0, -1));
    assertThrows(IllegalArgumentException.class, () -> motion.step(1, 0, Double.NaN));
  }
}
