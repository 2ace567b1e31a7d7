package simbad.blindworld.world;

import java.util.random.RandomGenerator;

/** The chance events of a set-up along one track, which may hang together from ping to ping. */
final class Luck {

  private final RandomGenerator random;
  private final double[] uniform;
  private double noiseM;
  private boolean begun;

  Luck(RandomGenerator random, int bodies) {
    this.random = random;
    uniform = new double[bodies];
  }

  void draw(Setup setup) {
    for (int b = 0; b < uniform.length; b++) {
      boolean kept = random.nextDouble() < setup.persistence();
      double fresh = random.nextDouble();
      uniform[b] = begun && kept ? uniform[b] : fresh;
    }
    boolean kept = random.nextDouble() < setup.persistence();
    double scale = random.nextDouble() < setup.tailShare() ? setup.tailScale() : 1;
    double fresh = setup.rangeNoiseM() * scale * random.nextGaussian();
    noiseM = begun && kept ? noiseM : fresh;
    begun = true;
  }

  double uniform(int body) {
    return uniform[body];
  }

  double noiseM() {
    return noiseM;
  }
}
