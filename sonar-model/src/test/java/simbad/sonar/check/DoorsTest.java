package simbad.sonar.check;

import org.junit.jupiter.api.Test;
import simbad.sonar.level.Beam;
import simbad.sonar.level.Curve;
import simbad.sonar.level.LevelLaw;
import simbad.sonar.level.PistonBeam;
import simbad.sonar.level.StrengthTable;

/** NaN comes in by no public constructor and by no factory: what is made is made of numbers. */
class DoorsTest {
  @Test
  void nan_isRefusedAtEveryDoor() throws Exception {
    Curve curve = Curve.of(0, 0.1, 1, 0.2);
    Beam beam = PistonBeam.of(0.007, 700);
    Samples samples =
        new Samples()
            .with(Curve.class, curve)
            .with(Beam.class, beam)
            .with(StrengthTable.class, StrengthTable.of(new double[72]))
            .with(LevelLaw.class, new LevelLaw(30, 2, 1, beam, curve, 1, curve, curve, 0.01));
    DoorWalk.refusesNan(Checks.class, samples, 30);
  }
}
