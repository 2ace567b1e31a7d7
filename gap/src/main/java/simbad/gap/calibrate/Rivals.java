package simbad.gap.calibrate;

import java.util.List;
import java.util.stream.IntStream;
import simbad.gap.calibrate.level.LevelCalibrator;
import simbad.gap.fit.CalibratedLog;
import simbad.gap.fit.Fitter;
import simbad.gap.fit.Fold;
import simbad.gap.fit.Hypothesis;
import simbad.gap.score.Blocks;
import simbad.gap.unexplained.Surprise;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SensorLaw;

/**
 * The threshold rule and the level law, each calibrated on one half of a reference's blocks and
 * asked of the other, and the other way round: which foretells better what it was not fitted on.
 */
final class Rivals {
  private final SensingSetup setup;
  private final SensingSetup level;
  private final PingLog reference;
  private final CalibratedLog raw;
  private final Blocks blocks;

  /**
   * Prepares the comparison.
   *
   * @param setup as believed, under no law
   * @param reference in more than one block
   */
  Rivals(SensingSetup setup, PingLog reference) {
    this.setup = setup;
    this.reference = reference;
    level = setup.under(SensorLaw.Model.LEVEL);
    raw = new CalibratedLog(setup, List.of(), reference);
    blocks = new Blocks(reference);
  }

  /** Returns by how much the level law foretells better, natural logarithm. */
  double gainedNats() {
    LevelCalibrator calibrator = new LevelCalibrator(level, reference);
    List<Double> gained =
        IntStream.range(0, 2).parallel().mapToObj(half -> gainedNats(calibrator, half)).toList();
    return gained.get(0) + gained.get(1);
  }

  private double gainedNats(LevelCalibrator calibrator, int half) {
    Fold in = blocks.half(half);
    Fold out = blocks.half(1 - half);
    Hypothesis threshold = new Calibrator(new Fitter(raw, in), setup).fit();
    return nats(level, calibrator.fit(in).setup(), out)
        - Math.max(nats(setup, threshold, out), nats(setup, Hypothesis.NONE, out));
  }

  /** How well echoes are foretold; a wrong offset of ranges says nothing of how a sensor hears. */
  private double nats(SensingSetup believed, Hypothesis calibrated, Fold fold) {
    CalibratedLog given = new CalibratedLog(believed, calibrated.changes(), reference);
    return new Surprise(given, Hypothesis.NONE).echoNats(fold);
  }
}
