package simbad.gap;

import java.util.Set;
import java.util.function.Function;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.gap.calibrate.level.LevelCalibration;
import simbad.gap.diagnosis.Interval;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Hypothesis;
import simbad.gap.fixture.Worlds;
import simbad.gap.score.GapGains;
import simbad.gap.score.HeldOut.Scored;
import simbad.sonar.change.Gain;
import simbad.sonar.check.DoorWalk;
import simbad.sonar.check.Samples;
import simbad.sonar.effect.Form;

/** NaN comes in by no public constructor and by no factory: what is made is made of numbers. */
class GapDoorsTest {
  private static CalibratedLog given() {
    return Worlds.given(Worlds.read(Worlds.poses(50, 0.3, 2.2, 9), Hypothesis.NONE, 10));
  }

  @Test
  void nan_isRefusedAtEveryDoor() throws Exception {
    Form form =
        Form.of(Effect.GAIN, "factor", v -> new Gain(v[0]), Parameter.of("factor", 1, 0, 3, 0.5));
    Samples samples =
        new Samples()
            .with(double[].class, new double[] {0.5})
            .with(Form.class, form)
            .with(Hypothesis.class, Hypothesis.NONE)
            .with(Function.class, (Function<Hypothesis, Set<Effect>>) set -> Set.of())
            .with(Interval.class, new Interval(0, 1))
            .with(Scored.class, new Scored(Hypothesis.NONE, -1, -1))
            .with(CalibratedLog.class, given())
            .with(GapGains.class, new GapGains(given()));
    // A ping may have no place on an axis, and NaN says so there.
    DoorWalk.refusesNan(LevelCalibration.class, samples, 35, "gap.calibrate.level.Along.of(");
  }
}
