package simbad.sonar.change;

import simbad.sonar.ping.Geometry;
import simbad.sonar.ping.LevelChange;
import simbad.sonar.ping.LevelEars;
import simbad.sonar.ping.RangeChange;

/**
 * The air is warmer or colder than assumed, under the level law: sound is faster or slower, and the
 * air takes more or less of it. One cause, two symptoms.
 *
 * @param speed by which ranges are scaled
 * @param absorption by which echoes get weaker
 */
public record OtherAir(SoundSpeed speed, LevelAbsorption absorption)
    implements RangeChange, LevelChange {
  @Override
  public int order() {
    return speed.order();
  }

  @Override
  public double meanM(double rangeM) {
    return speed.meanM(rangeM);
  }

  @Override
  public double rangeM(double meanM) {
    return speed.rangeM(meanM);
  }

  @Override
  public double addedDb(LevelEars ears, Geometry geometry, int line) {
    return absorption.addedDb(ears, geometry, line);
  }
}
