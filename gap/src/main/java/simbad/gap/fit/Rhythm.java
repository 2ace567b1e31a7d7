package simbad.gap.fit;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import simbad.sonar.ping.PingLog;

/** Steps that the readings of a log may be multiples of, by how well they keep the beat. */
final class Rhythm {
  private static final double LEAST_M = 0.008;
  private static final double GREATEST_M = 0.3;
  private static final double RATIO = 1.004;
  private static final int BEST = 8;

  private final PingLog log;

  Rhythm(PingLog log) {
    this.log = log;
  }

  /** Returns the steps that fit best, best first, then lengths that people choose. */
  List<Double> steps() {
    List<double[]> beats = new ArrayList<>();
    for (double step = LEAST_M; step < GREATEST_M; step *= RATIO) {
      beats.add(new double[] {step, beat(step)});
    }
    beats.sort(Comparator.comparingDouble(beat -> -beat[1]));
    List<Double> steps = new ArrayList<>();
    for (double[] beat : beats.subList(0, BEST)) {
      // Coarse grids are often round numbers: the exact millimetre is tried beside the peak.
      steps.add(beat[0]);
      steps.add(Math.rint(beat[0] * 1e3) / 1e3);
    }
    // A step's half and third keep its beat as well, so longer steps are tried by name.
    for (int millimetres = 10; millimetres <= 100; millimetres += 5) {
      steps.add(millimetres / 1e3);
    }
    return steps.stream().distinct().toList();
  }

  private double beat(double step) {
    double cos = 0;
    double sin = 0;
    for (int i = 0; i < log.size(); i++) {
      if (log.echo(i)) {
        double phase = 2 * Math.PI * log.rangeM(i) / step;
        cos += Math.cos(phase);
        sin += Math.sin(phase);
      }
    }
    return Math.hypot(cos, sin);
  }
}
