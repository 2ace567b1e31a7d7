package simbad.experiments.fleet;

import java.util.SplittableRandom;
import java.util.random.RandomGenerator;

/** A source of chance that a belt keeps while each episode brings its own numbers. */
final class Chance implements RandomGenerator {
  private SplittableRandom source = new SplittableRandom(0);

  void take(SplittableRandom newSource) {
    source = newSource;
  }

  @Override
  public long nextLong() {
    return source.nextLong();
  }
}
