package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.motion.Command;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;

/** Events among 400 steps that are off by one to either side; the way's command changes at 40 s. */
class EventsTest {
  private static final double EXACT = 1e-9;
  private static final int ALONG = 0;
  private static final int TURN = 2;
  private static final List<Command> AHEAD = List.of(new Command(0, 0.2, 0), new Command(40, 1, 0));
  private static final List<Command> BACK = List.of(new Command(0, -0.2, 1));

  /** Over one scale all are. */
  private static final Noise PLAIN = new Noise(1e-6, 0.02, 60);

  private record Spike(int component, int step, double times) {}

  private static Events events(List<Command> commands, Spike... spikes) {
    List<TrackPose> track = new ArrayList<>();
    double[][] residuals = new double[3][400];
    for (int i = 0; i < 400; i++) {
      track.add(new TrackPose(i / 5.0, 0, 0, 0));
      residuals[ALONG][i] = i % 2 == 0 ? 1e-2 : -1e-2;
      residuals[TURN][i] = residuals[ALONG][i];
    }
    track.add(new TrackPose(80, 0, 0, 0));
    MotionSteps given = new MotionSteps(List.of(new MotionRun("a", commands, track)));
    for (int i = 0; i < 400; i++) {
      // In units of what the filter takes a step to scatter by, all are of one size.
      residuals[ALONG][i] *= Math.sqrt(given.loads()[i]);
      residuals[TURN][i] *= Math.sqrt(given.loads()[i]);
    }
    for (Spike spike : spikes) {
      residuals[spike.component][spike.step] =
          1e-2 * spike.times * Math.sqrt(given.loads()[spike.step]);
    }
    MotionHypothesis none = new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0]);
    Noise[] noises = {PLAIN, PLAIN, PLAIN};
    return Events.of(given, new MotionFit(none, residuals, noises, 0));
  }

  private static void assertCounts(int shorter, int late, int other, Events events) {
    assertEquals(
        List.of(shorter, late, other), List.of(events.shorter(), events.late(), events.other()));
  }

  /** The median size is 0.6745 deviations: 4.7 of these are 6.968 times as far. */
  @Test
  void farIsBeyondWhatGaussiansReach() {
    assertCounts(0, 0, 0, events(AHEAD, new Spike(ALONG, 100, 6.9)));
    assertCounts(0, 0, 1, events(AHEAD, new Spike(ALONG, 100, 7.1)));
    assertCounts(1, 0, 0, events(AHEAD, new Spike(ALONG, 100, -7.1)));
    assertCounts(0, 0, 0, events(AHEAD, new Spike(ALONG, 100, -6.9)));
  }

  /** Short is against the way that is expected; without a turn nothing is short of one. */
  @Test
  void shortIsAgainstWhatIsExpected() {
    assertCounts(1, 0, 0, events(BACK, new Spike(ALONG, 100, 9)));
    assertCounts(0, 0, 1, events(BACK, new Spike(ALONG, 100, -9)));
    assertCounts(1, 0, 0, events(BACK, new Spike(TURN, 100, -9)));
    assertCounts(0, 0, 1, events(AHEAD, new Spike(TURN, 100, -9)));
    // Of both the way tells the kind.
    assertCounts(0, 0, 1, events(BACK, new Spike(ALONG, 100, -9), new Spike(TURN, 100, -9)));
  }

  /** The command has changed up to 0.8 s before a step begins, or within it. */
  @Test
  void lateIsWhereItsOwnCommandHasChanged() {
    assertCounts(0, 0, 1, events(AHEAD, new Spike(ALONG, 198, 9)));
    assertCounts(0, 1, 0, events(AHEAD, new Spike(ALONG, 199, 9)));
    assertCounts(0, 1, 0, events(AHEAD, new Spike(ALONG, 203, 9)));
    assertCounts(0, 0, 1, events(AHEAD, new Spike(ALONG, 205, 9)));
    assertCounts(1, 0, 0, events(AHEAD, new Spike(ALONG, 202, -9)));
    assertCounts(0, 0, 1, events(AHEAD, new Spike(TURN, 202, 9)));
  }

  /** What goes on for longer than 0.8 s is not only late. */
  @Test
  void whatLastsIsNotLate() {
    Spike first = new Spike(ALONG, 200, 9);
    assertCounts(0, 1, 0, events(AHEAD, first, new Spike(ALONG, 203, 9)));
    assertCounts(0, 0, 1, events(AHEAD, first, new Spike(ALONG, 204, 9)));
    assertCounts(1, 0, 0, events(AHEAD, new Spike(ALONG, 100, -9), new Spike(ALONG, 105, -9)));
  }

  /** Within 1.2 s of the end of the one the next is the same. */
  @Test
  void whatFollowsSoonIsTheSameEvent() {
    Events one = events(AHEAD, new Spike(ALONG, 100, -9), new Spike(ALONG, 106, -9));
    assertCounts(1, 0, 0, one);
    assertEquals(20, one.slips().get(0).fromS(), EXACT);
    assertEquals(21.4 + 1.2, one.slips().get(0).toS(), EXACT);
    assertEquals(0, one.slips().get(0).run());
    Events two = events(AHEAD, new Spike(ALONG, 100, -9), new Spike(ALONG, 108, -9));
    assertCounts(2, 0, 0, two);
    assertEquals(21.4, two.slips().get(0).toS(), EXACT);
    // The kind is that of the first.
    assertCounts(0, 0, 1, events(AHEAD, new Spike(ALONG, 100, 9), new Spike(ALONG, 103, -9)));
    assertEquals(
        List.of(), events(AHEAD, new Spike(ALONG, 100, 9), new Spike(ALONG, 103, -9)).slips());
  }

  /**
   * All off by the median are 0.6745 squared; one of 400 that is 20 times as far adds its share.
   */
  @Test
  void howHeavyIsTheMeanSquareOfTheWorse() {
    double median = 0.6745 * 0.6745;

    assertEquals(median, events(AHEAD).heavy(), 1e-4);
    assertEquals(median * (399 + 400) / 400, events(AHEAD, new Spike(TURN, 100, 20)).heavy(), 1e-4);
    assertEquals(
        median * (399 + 400) / 400,
        events(AHEAD, new Spike(ALONG, 100, 20), new Spike(TURN, 50, 10)).heavy(),
        1e-4);
  }
}
