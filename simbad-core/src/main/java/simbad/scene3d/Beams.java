package simbad.scene3d;

import java.util.EnumSet;
import java.util.OptionalDouble;
import java.util.Set;
import javax.media.j3d.BranchGroup;
import javax.media.j3d.Node;
import javax.vecmath.Color3f;
import simbad.sonar.check.Checks;
import simbad.sonar.sensing.Readings;
import simbad.sonar.sensing.TransducerPoses;

/**
 * The rays or cones of a sensor: short where it hears nothing, as long as the range and red where
 * it has an echo.
 */
public final class Beams implements Animated {
  /**
   * How beams look.
   *
   * @param color colour of a beam without echo
   * @param halfAngleRad half angle of the cones, in (0, pi]; empty for thin rays
   */
  public record Style(Color3f color, OptionalDouble halfAngleRad) {
    /** Checks the angle. */
    public Style {
      halfAngleRad.ifPresent(angle -> Checks.within("halfAngleRad", angle, 0, Math.PI));
    }
  }

  private final BranchGroup group = new BranchGroup();
  private final SceneBeam[] beams;
  private final Readings readings;
  private final boolean[] echo;
  private final double[] rangeM;

  /**
   * Creates beams.
   *
   * @param style how they look
   * @param inSensor where they start and point, in the sensor's frame
   * @param idleM how long each is without an echo, metres
   * @param readings what the sensor hears; followed, not copied
   */
  public Beams(Style style, TransducerPoses inSensor, double[] idleM, Readings readings) {
    Checks.numbers("idleM", idleM);
    this.readings = readings;
    BeamLook idle = BeamLook.idle(style);
    BeamLook hit = BeamLook.hit(style);
    beams = new SceneBeam[inSensor.size()];
    for (int i = 0; i < beams.length; i++) {
      beams[i] = new SceneBeam(inSensor, i, idleM[i], idle, hit);
      group.addChild(beams[i].node());
    }
    echo = new boolean[beams.length];
    rangeM = new double[beams.length];
  }

  @Override
  public Node node() {
    return group;
  }

  @Override
  public void capture() {
    for (int i = 0; i < beams.length; i++) {
      echo[i] = readings.isEcho(i);
      rangeM[i] = echo[i] ? readings.rangeM(i) : 0;
    }
  }

  @Override
  public void show() {
    for (int i = 0; i < beams.length; i++) {
      if (echo[i]) {
        beams[i].showEcho(rangeM[i]);
      } else {
        beams[i].showIdle();
      }
    }
  }

  @Override
  public Set<Sign> signs() {
    return EnumSet.of(Sign.SILENT, Sign.ECHO);
  }
}
