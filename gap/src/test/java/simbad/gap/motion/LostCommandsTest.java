package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import simbad.motion.MotionChain;
import simbad.motion.MotionRun;
import simbad.motion.effect.MotionForms;
import simbad.motion.format.MotionData;

class LostCommandsTest {
  private static final MotionChain LAG =
      MotionChain.EXACT.with(
          MotionForms.find("actuation-lag: time constants").orElseThrow().change(0.2, 0.2));

  private static MotionData data(Consumer<Drives> world) {
    Drives drives = new Drives(61);
    world.accept(drives);
    return drives.data();
  }

  private static LostCommands lost(MotionData data, MotionChain chain) {
    return new LostCommands(new MotionSteps(data.runs()), data.runs(), chain);
  }

  @Test
  void commandsThatWereLost_areFound() {
    MotionData data = data(drives -> drives.dropped = 0.3);
    LostCommands lost = lost(data, MotionChain.EXACT);
    MotionSteps given = new MotionSteps(data.runs());
    assertTrue(lost.gain() > 500, "gain " + lost.gain());
    // Of two that were lost in a row the second is held too early.
    double share = MotionStrangers.share(lost.part(), given.residuals(MotionChain.EXACT));
    assertTrue(share > 0.6 && share < 1, "share " + share);
  }

  @Test
  void noneIsFound_whereNoneWasLost() {
    double exact = lost(data(drives -> {}), MotionChain.EXACT).gain();
    double lagging = lost(data(drives -> drives.lagS = 0.2), LAG).gain();
    assertTrue(exact < 0, "gain " + exact);
    assertTrue(lagging < 0, "gain of a lag " + lagging);
  }

  /** Losses explain a lag far worse than the lag does. */
  @Test
  void lag_isNoLoss() {
    MotionData data = data(drives -> drives.lagS = 0.2);
    double with = lost(data, LAG).logDensity();
    double without = lost(data, MotionChain.EXACT).logDensity();
    assertTrue(with > without + 200, with + " and " + without);
  }

  /** A command that repeats the one before may be lost and nothing shows. */
  @Test
  void repeatedCommands_areHeldByTheNextRow() {
    MotionData data = data(drives -> drives.dropped = 0.3);
    MotionSteps given =
        new MotionSteps(data.runs().stream().map(MotionRun::withoutRepeats).toList());
    assertTrue(new LostCommands(given, data.runs(), MotionChain.EXACT).gain() > 500);
  }
}
