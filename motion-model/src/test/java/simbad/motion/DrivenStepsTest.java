package simbad.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

class DrivenStepsTest {
  private static final double[] FROM = {0.03, 0.2, 0.51, 0.52, 3};
  private static final double[] TO = {0.2, 0.5, 0.513, 1.9, 7.77};

  /** Straight ahead, round, and faster round than a series holds. */
  private static final List<Command> COMMANDS =
      List.of(
          new Command(0, 0.3, 0),
          new Command(0.33, 0.3, 0.8),
          new Command(0.9, 0.3, 0.8),
          new Command(1.41, -0.2, 14),
          new Command(5, 0.3, 0));

  private static final MotionRun RUN = new MotionRun("a", COMMANDS, List.of());

  private static List<Displacement> driven(DrivenSteps steps, MotionChain chain) {
    List<Displacement> all = new ArrayList<>();
    steps.drive(chain, (step, expected) -> all.add(expected));
    return all;
  }

  private static void assertAsTheWay(DrivenSteps steps, MotionChain chain, String name) {
    Way way = Way.of(RUN, chain, 0, 10);
    List<Displacement> all = driven(steps, chain);
    for (int i = 0; i < FROM.length; i++) {
      Displacement expected = way.between(FROM[i], TO[i]);
      for (int c = 0; c < 3; c++) {
        assertEquals(expected.component(c), all.get(i).component(c), 1e-9, name + ", step " + i);
      }
    }
  }

  @Test
  void drive_byEveryForm_isTheWay() {
    DrivenSteps steps = new DrivenSteps(RUN, FROM, TO);
    assertAsTheWay(steps, MotionChain.EXACT, "exact");
    for (MotionForm form : MotionForms.ALL) {
      double[] values =
          form.parameters().stream()
              .mapToDouble(p -> p.within(Double.isFinite(p.neutral()) ? p.neutral() + 0.1 : 0.25))
              .toArray();
      assertAsTheWay(steps, MotionChain.EXACT.with(form.change(values)), form.form());
    }
  }

  /** What was kept of other chains is not mixed up, whoever asks. */
  @Test
  void drive_byManyAtOnce_isTheSameAsAlone() {
    DrivenSteps steps = new DrivenSteps(RUN, FROM, TO);
    MotionForm late = MotionForms.find("actuation-latency").orElseThrow();
    MotionForm lag = MotionForms.find("actuation-lag: time constants").orElseThrow();
    List<MotionChain> chains =
        IntStream.range(0, 64)
            .mapToObj(
                i ->
                    MotionChain.EXACT
                        .with(late.change(0.1 * (i % 5)))
                        .with(lag.change(0.1 * (i % 3), 0.2)))
            .toList();
    List<List<Displacement>> alone =
        chains.stream().map(c -> driven(new DrivenSteps(RUN, FROM, TO), c)).toList();
    assertEquals(alone, chains.parallelStream().map(chain -> driven(steps, chain)).toList());
  }
}
