package simbad.bench.capture;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import simbad.bench.protocol.FrameLine;

/**
 * The sweep that a person does: says what to do, takes the distance that the person read from the
 * tape, pings there, and says whether the echo is lost. Not thread-safe.
 */
public final class GuidedSweep {
  private static final double CM = 100;

  /** One may be missed, or be of something else. */
  private static final int LOOKS = 3;

  private final SweepPlan plan;
  private final Recorder recorder;
  private final PingSource pings;
  private final Operator operator;
  private final Surface surface;
  private final InstantSource clock;
  private OptionalInt chosen = OptionalInt.empty();
  private OptionalDouble doubtedM = OptionalDouble.empty();
  private Duration paused = Duration.ZERO;

  /**
   * Prepares a sweep.
   *
   * @param plan what is to be done
   * @param recorder keeps what was done, and tells the time
   * @param pings gives the readings
   * @param operator the person
   * @param surface of the obstacle, by which a slip on the tape is noticed
   */
  public GuidedSweep(
      SweepPlan plan, Recorder recorder, PingSource pings, Operator operator, Surface surface) {
    this.plan = plan;
    this.recorder = recorder;
    this.pings = pings;
    this.operator = operator;
    this.surface = surface;
    clock = recorder.clock();
  }

  /**
   * Goes on until all bearings are done, or the person ends it.
   *
   * @return whether all are done
   * @throws IOException if there are no readings any more, or they cannot be recorded
   * @throws InterruptedException if the thread is interrupted
   */
  public boolean run() throws IOException, InterruptedException {
    Instant begun = clock.instant();
    int doneBefore = recorder.state().doneCount();
    for (OptionalInt bearing = next(); bearing.isPresent(); bearing = next()) {
      int at = bearing.getAsInt();
      operator.show(new SweepView(plan, recorder.state(), at, left(begun, doneBefore)));
      if (!obey(at, operator.ask(pings).strip())) {
        return false;
      }
    }
    return true;
  }

  private Optional<Duration> left(Instant begun, int doneBefore) {
    int done = recorder.state().doneCount();
    if (done <= doneBefore) {
      return Optional.empty();
    }
    Duration worked = Duration.between(begun, clock.instant()).minus(paused);
    Duration each = worked.dividedBy(done - doneBefore);
    return Optional.of(each.multipliedBy(plan.bearings() - done));
  }

  private OptionalInt next() {
    return chosen.isPresent() ? chosen : recorder.state().nextBearing(plan);
  }

  /** Carries out what was typed; false for the end. */
  private boolean obey(int bearing, String typed) throws IOException, InterruptedException {
    String[] words = typed.split(" +", 2);
    OptionalDouble number = number(words.length > 1 ? words[1] : words[0]);
    switch (words[0]) {
      case "q" -> {
        return false;
      }
      case "", "d" -> accept(bearing);
      case "u" -> undo(bearing);
      case "r" -> repeat(number);
      case "p" -> pause();
      case "t" -> warm(number);
      default -> take(bearing, number(typed), typed);
    }
    return true;
  }

  private void accept(int bearing) throws IOException {
    List<Level> levels = recorder.state().levels(bearing);
    boolean lost = levels.stream().anyMatch(plan::isLost);
    boolean heard = levels.stream().anyMatch(level -> !plan.isLost(level));
    if (!lost || !heard) {
      operator.say(
          "not done: this bearing needs a distance where the echo is heard and one where "
              + "it is lost");
      return;
    }
    recorder.record(new Entry.Done(bearing));
    chosen = OptionalInt.empty();
    operator.say("bearing done: " + ThresholdFit.of(levels, plan).text());
  }

  /** Of the bearing that is under way, or else of the one before. */
  private void undo(int bearing) throws IOException {
    int at = recorder.state().levels(bearing).isEmpty() && bearing > 0 ? bearing - 1 : bearing;
    if (recorder.state().levels(at).isEmpty()) {
      operator.say("nothing to undo");
      return;
    }
    recorder.record(new Entry.Undone(at));
    chosen = OptionalInt.of(at);
    operator.say("the last distance no longer counts");
  }

  private void repeat(OptionalDouble bearingDeg) throws IOException {
    double index = bearingDeg.orElse(-1) * plan.bearings() / 360;
    int at = (int) Math.rint(index);
    if (at < 0 || at >= plan.bearings() || Math.abs(index - at) > 1e-6) {
      operator.say("r and a bearing of the sweep in degrees, such as: r 35");
      return;
    }
    recorder.record(new Entry.Repeated(at));
    chosen = OptionalInt.of(at);
    operator.say("the readings of this bearing no longer count: measure it again");
  }

  private void pause() throws IOException {
    Instant begun = clock.instant();
    operator.pause();
    paused = paused.plus(Duration.between(begun, clock.instant()));
    operator.say("going on");
  }

  private void warm(OptionalDouble degreesC) throws IOException {
    try {
      recorder.setTemperature(degreesC.orElse(Double.NaN));
      recorder.note("air temperature " + degreesC.orElseThrow() + " C");
    } catch (IllegalArgumentException e) {
      operator.say("t and the temperature of the air in degrees C, such as: t 21.5");
    }
  }

  private void take(int bearing, OptionalDouble distanceCm, String typed)
      throws IOException, InterruptedException {
    // To a tenth of a millimetre, of which there must be one.
    double distanceM = Math.rint(distanceCm.orElse(-1) * CM) / (CM * CM);
    if (!(distanceM > 0 && distanceM <= SweepPlan.FURTHEST_M)) {
      operator.say("'" + typed + "' is neither a distance in cm nor one of u, r, p, t, q");
      return;
    }
    if (isDoubtful(distanceM)) {
      return;
    }
    TriedDistance probe = new TriedDistance(distanceM, approach(bearing, distanceM));
    for (int ping = 0; ping < plan.pings(); ping++) {
      Entry.Taken taken = recorder.record(bearing, probe, pings.ping());
      recorder.sync();
      operator.heard(taken);
    }
    List<Level> levels = recorder.state().levels(bearing);
    Level level = levels.get(levels.size() - 1);
    if (plan.isLost(level)) {
      operator.lost(level);
    } else {
      operator.say(
          level.heard() + " of " + level.pings() + " heard at " + distanceCm.getAsDouble() + " cm");
    }
  }

  /** A distance that the readings contradict is asked for again; typed again, it is believed. */
  private boolean isDoubtful(double distanceM) throws IOException, InterruptedException {
    // One for the air to become still.
    pings.ping();
    OptionalDouble contradictionM = surface.findContradiction(looks(), distanceM);
    boolean insisted = doubtedM.isPresent() && doubtedM.getAsDouble() == distanceM;
    if (contradictionM.isEmpty() || insisted) {
      doubtedM = OptionalDouble.empty();
      return false;
    }
    doubtedM = OptionalDouble.of(distanceM);
    operator.say(
        String.format(
            Locale.ROOT,
            "not taken: axis at %.1f cm, but the sensor reads %.1f cm to the surface; type "
                + "the distance again (if you repeat it, it is believed)",
            CM * distanceM,
            CM * contradictionM.getAsDouble()));
    return true;
  }

  private List<FrameLine.Ping> looks() throws IOException, InterruptedException {
    List<FrameLine.Ping> looks = new ArrayList<>();
    for (int look = 0; look < LOOKS; look++) {
      looks.add(pings.ping());
    }
    return looks;
  }

  private Approach approach(int bearing, double distanceM) {
    List<Level> levels = recorder.state().levels(bearing);
    boolean in = !levels.isEmpty() && distanceM < levels.get(levels.size() - 1).distanceM();
    return in ? Approach.IN : Approach.OUT;
  }

  private static OptionalDouble number(String text) {
    try {
      return OptionalDouble.of(Double.parseDouble(text.replace(',', '.')));
    } catch (NumberFormatException e) {
      return OptionalDouble.empty();
    }
  }
}
