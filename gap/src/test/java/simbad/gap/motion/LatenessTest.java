package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simbad.motion.MotionChain;
import simbad.motion.MotionChange;
import simbad.motion.effect.MotionForms;

class LatenessTest {
  /** Chi-square of four exceeds it once in a thousand. */
  private static final double RARE = 18.5;

  private double share;

  private double hangsTogether(Consumer<Drives> world, double lateS) {
    Drives drives = new Drives(62);
    world.accept(drives);
    MotionSteps given = new MotionSteps(drives.data().runs());
    MotionChain chain = MotionChain.EXACT.with(late(lateS));
    double[][] residuals = given.residuals(chain);
    double[][] perS = given.residuals(MotionChain.EXACT.with(late(lateS + 0.02)));
    for (int c = 0; c < perS.length; c++) {
      for (int i = 0; i < given.size(); i++) {
        perS[c][i] = MotionSteps.wrapped(residuals[c][i] - perS[c][i]) / 0.02;
      }
    }
    Lateness lateness = new Lateness(given, residuals, perS);
    double square = lateness.hangsTogether();
    share = MotionStrangers.share(lateness.part(), given.residuals(MotionChain.EXACT));
    return square;
  }

  private static MotionChange late(double seconds) {
    return MotionForms.find("actuation-latency").orElseThrow().change(seconds);
  }

  @Test
  void whatIsLateForSeconds_hangsTogether() {
    double square = hangsTogether(drives -> drives.clogS = 0.3, 0.15);
    assertTrue(square > 2 * RARE, "square " + square);
    assertTrue(share > 0.1, "share " + share);
  }

  @Test
  void whatIsAlwaysLate_orByChance_doesNot() {
    assertTrue(hangsTogether(drives -> drives.lateS = 0.15, 0.15) < RARE);
    assertTrue(hangsTogether(drives -> drives.unsteadyS = 0.3, 0.15) < RARE);
  }

  @Test
  void fewStretches_sayNothing() {
    assertEquals(0, hangsTogether(drives -> drives.seconds = 20, 0));
  }
}
