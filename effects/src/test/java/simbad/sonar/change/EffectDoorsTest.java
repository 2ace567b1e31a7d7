package simbad.sonar.change;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.check.DoorWalk;
import simbad.sonar.check.Samples;
import simbad.sonar.effect.Form;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.level.Beam;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.PistonBeam;
import simbad.sonar.level.StrengthTable;
import simbad.sonar.ping.OutlineLevels;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/** NaN comes in by no public constructor and by no factory: what is made is made of numbers. */
class EffectDoorsTest {
  private static final Outline TRIANGLE =
      Outline.of(List.of(new Point(-0.1, -0.1), new Point(-0.1, 0.1), new Point(0.1, 0.1)));

  private static Samples samples() {
    Curve curve = Curve.of(0, 0.1, 1, 0.2);
    Beam beam = PistonBeam.of(0.007, 700);
    Form form =
        Form.of(Effect.GAIN, "factor", v -> new Gain(v[0]), Parameter.of("factor", 1, 0, 3, 0.5));
    return new Samples()
        .with(Curve.class, curve)
        .with(Beam.class, beam)
        .with(Form.class, form)
        .with(Outline.class, TRIANGLE)
        .with(OutlineLevels.class, new OutlineLevels(TRIANGLE, 700))
        .with(
            Obstacle.class,
            new Obstacle("one", Placement.IDENTITY, TRIANGLE, new UniformDetection(1)))
        .with(StrengthTable.class, StrengthTable.of(new double[72]))
        .with(LevelLaw.class, new LevelLaw(30, 2, 1, beam, curve, 1, curve, curve, 0.01));
  }

  @Test
  void nan_isRefusedAtEveryDoor() throws Exception {
    DoorWalk.refusesNan(Gain.class, samples(), 40);
    DoorWalk.refusesNan(Effect.class, samples(), 1);
  }

  private static void assertRefused(String message, Executable made) {
    assertEquals(message, assertThrows(IllegalArgumentException.class, made).getMessage());
  }

  @Test
  void outOfRange_isRefused_andSaysWhatIsPermitted() {
    assertRefused("factor = NaN is not in [0, infinity)", () -> new Gain(Double.NaN));
    assertRefused("factor = -0.1 is not in [0, infinity)", () -> new Gain(-0.1));
    assertRefused("share = 7.0 is not in [0, 1]", () -> new Dropout(7));
    assertRefused("lengthPings = 0.5 is not in [1, infinity)", () -> new Burst(0.1, 0.5, 1));
    assertRefused("highM = 1.0 is not in (2, infinity)", () -> new Crosstalk(0.1, 2, 1, false));
  }
}
