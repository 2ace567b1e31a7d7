package simbad.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.motion.effect.MotionParameter;

class StagesTest {
  private static final Command COMMAND = new Command(3, 0.31, -0.7);

  static List<MotionForm> forms() {
    return MotionForms.ALL;
  }

  /** Each form behind a scale of everything, so that the order counts too. */
  @ParameterizedTest(name = "{0}")
  @MethodSource("forms")
  void stages_sayWhatTheChainSays(MotionForm form) {
    MotionChain chain = MotionChain.EXACT.with(new Halving()).with(form.change(values(form)));
    Stages stages = Stages.of(chain);

    Held taken = Held.of(List.of(COMMAND)).taken(List.of(stages.commands()));
    Command expected = COMMAND;
    for (MotionChange change : chain.changes()) {
      expected = change.commanded(expected, Command.STAND);
    }
    assertEquals(expected.speedMPerS(), taken.speed(0));
    assertEquals(expected.turnRadPerS(), taken.turn(0));
    assertEquals(chain.speed(0.31, 0), stages.speed(0.31, 0));
    assertEquals(chain.turn(-0.7, 0.31), stages.turn(-0.7, 0.31));
  }

  private static double[] values(MotionForm form) {
    return form.parameters().stream().mapToDouble(StagesTest::value).toArray();
  }

  private static double value(MotionParameter parameter) {
    return parameter.within(Math.min(parameter.neutral(), 1) + 0.2);
  }

  /** The stages of speeds and turns, but not of commands, have a halving. */
  @Test
  void whatSaysNothing_isNotAsked() {
    Stages stages = Stages.of(MotionChain.EXACT.with(new Halving()));

    assertEquals(0, stages.commands().length);
    assertEquals(1, stages.speeds().length);
    assertEquals(0, stages.turns().length);
  }

  /** It may have only the method that knows the command before. */
  @Test
  void whatRemembers_isAsked() {
    MotionChain chain = MotionChain.EXACT.with(new Rising());
    assertEquals(1, Stages.of(chain).commands().length);
  }

  private record Rising() implements MotionChange {
    @Override
    public Command commanded(Command command, Command before) {
      return command.speedMPerS() > before.speedMPerS() ? command : before;
    }

    @Override
    public boolean remembers() {
      return true;
    }
  }

  private record Halving() implements MotionChange {
    @Override
    public double speed(double speedMPerS, double turnRadPerS) {
      return speedMPerS / 2;
    }
  }
}
