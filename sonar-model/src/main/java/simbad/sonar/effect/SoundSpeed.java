package simbad.sonar.effect;

/**
 * Sound is faster or slower than assumed: time is right, range is scaled.
 *
 * @param scale range read over true range; 1 is neutral
 */
public record SoundSpeed(double scale) implements RangeChange {
  @Override
  public int order() {
    return 0;
  }

  @Override
  public double meanM(double rangeM) {
    return rangeM * scale;
  }

  @Override
  public double rangeM(double meanM) {
    return meanM / scale;
  }
}
