package simbad.experiments.table;

import java.util.List;
import simbad.obstacles.Catalogue;
import simbad.obstacles.CrossSections;
import simbad.scattering.FittedReceiver;
import simbad.scattering.KnownThresholds;
import simbad.scattering.RangeLimits;
import simbad.scattering.ThesisThresholds;
import simbad.sonar.level.Air;
import simbad.sonar.scene.SonarSpec;

/** The prediction's calibration, fitted anew to what Kranz (2014) says of his obstacles. */
public final class ThesisCalibration {
  private ThesisCalibration() {}

  /**
   * Fits it in the air of a room, within the SRF04's limits. Takes seconds.
   *
   * @param withAngle whether to the angle's measured table as well, or to the words alone
   */
  public static FittedReceiver fit(boolean withAngle) {
    ThesisThresholds thesis =
        new ThesisThresholds(CrossSections.square(), CrossSections.round(), Air.ROOM);
    List<KnownThresholds> known =
        withAngle
            ? thesis.with(CrossSections.angle(), Catalogue.angleTable().table())
            : thesis.inWords();
    SonarSpec srf04 = Catalogue.srf04();
    return FittedReceiver.fit(
        known, Air.ROOM, new RangeLimits(srf04.minRangeM(), srf04.maxRangeM()));
  }
}
