package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simbad.motion.CommandUse;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;

class AmplitudeTest {
  private static double error(Consumer<Drives> world, double stepMPerS) {
    Drives drives = new Drives(61);
    world.accept(drives);
    List<MotionRun> runs = drives.data().runs();
    MotionSteps given = new MotionSteps(runs);
    MotionForm steps = MotionForms.find("command-quantization").orElseThrow();
    MotionHypothesis set =
        new MotionHypothesis(MotionChain.EXACT, List.of(), new double[0])
            .with(steps, new double[] {stepMPerS, 0});
    MotionFit fit = new MotionFitter(given, CommandUse.of(runs, 0)).asItIs(set);
    return Amplitude.standardError(given, ScoredMotion.of(given, fit), "command-quantization");
  }

  @Test
  void stepsThatAreThere_areKnownExactly() {
    double error = error(drives -> drives.speedStep = 0.04, 0.04);
    assertTrue(error < 0.02, "error " + error);
  }

  /** Small steps that are not there, on a floor that scatters. */
  @Test
  void stepsThatAreNot_areVague() {
    double error = error(drives -> drives.roughness = 0.02, 0.004);
    assertTrue(error > 0.1, "error " + error);
  }
}
