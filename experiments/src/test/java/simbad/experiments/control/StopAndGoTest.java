package simbad.experiments.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.sonar.sensing.Readings;

class StopAndGoTest {
  private static final Readings SILENCE = new Readings(4);

  /** Decides to turn left at 2 rad/s and right at 0.1 rad/s by turns, always at 0.5 m/s. */
  private static final class ByTurns implements Controller {
    private int decided;

    @Override
    public void decide(Readings readings, Command command) {
      command.set(0.5, decided++ % 2 == 0 ? 2 : -0.1);
    }
  }

  private static List<List<Double>> commands(Controller controller, int steps) {
    List<List<Double>> commands = new ArrayList<>();
    for (int i = 0; i < steps; i++) {
      Command command = new Command();
      controller.decide(SILENCE, command);
      commands.add(List.of(command.speedMPerS(), command.turnRateRadPerS()));
    }
    return commands;
  }

  @Test
  void aFastTurn_isASlowOneOnTheSpot_andThenItWaits() {
    List<List<Double>> expected =
        List.of(
            List.of(0.5, 0.0),
            List.of(0.0, 0.5),
            List.of(0.0, 0.5),
            List.of(0.0, 0.5),
            List.of(0.0, 0.5),
            List.of(0.0, 0.0),
            List.of(0.0, 0.0),
            List.of(0.5, -0.1),
            List.of(0.0, 0.0),
            List.of(0.0, 0.0),
            List.of(0.5, 0.0));

    assertEquals(expected, commands(new StopAndGo(new ByTurns(), 2, 0.6), expected.size()));
  }

  @Test
  void aRobotThatTurnsFastEnough_doesWhatIsDecided() {
    assertEquals(commands(new ByTurns(), 10), commands(new StopAndGo(new ByTurns(), 0, 2), 10));
  }

  @Test
  void wrongNumbers_areRefused() {
    assertThrows(IllegalArgumentException.class, () -> new StopAndGo(new ByTurns(), -1, 1));
    assertThrows(IllegalArgumentException.class, () -> new StopAndGo(new ByTurns(), 0, Double.NaN));
    assertThrows(IllegalArgumentException.class, () -> new StopAndGo(new ByTurns(), 0, 0));
  }
}
