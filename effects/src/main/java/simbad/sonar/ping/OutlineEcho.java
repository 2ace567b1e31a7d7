package simbad.sonar.ping;

import java.util.Arrays;
import simbad.sonar.check.Checks;
import simbad.sonar.frame.Angles;
import simbad.sonar.shape.Outline;

/**
 * What an outline sends back, by Kirchhoff's integral round it: each piece that faces the sensor
 * answers in proportion to the cosine of its angle, with the phase of its distance there and back.
 * The echo's place is the mean direction of what adds up, its level the sum's, both over the band
 * of a burst. The integral leaves out what bends round corners and is reflected twice. It knows
 * nothing of height. Immutable.
 */
final class OutlineEcho {
  /**
   * Half of the band in which a burst of eight periods has its energy, as a share of the carrier.
   */
  private static final double BAND = 0.1;

  private static final int WAVES = 5;
  private static final double PIECES_PER_WAVE = 5;
  private static final double LEAST_POWER = 1e-12;

  /** Of short pieces, in the outline's own frame. */
  private final double[] xM;

  private final double[] zM;

  /** The way out of the body, as long as the piece. */
  private final double[] outX;

  private final double[] outZ;
  private final double wavenumberPerM;

  /**
   * Cuts an outline into pieces.
   *
   * @param outline in its own frame
   * @param wavenumberPerM of the carrier, radians per metre
   */
  OutlineEcho(Outline outline, double wavenumberPerM) {
    this.wavenumberPerM = Checks.positive("wavenumberPerM", wavenumberPerM);
    double longestM = Angles.TURN_RAD / wavenumberPerM / PIECES_PER_WAVE;
    double sense = -Math.signum(outline.signedAreaM2());
    double[][] all = new double[4][0];
    int from = outline.size() - 1;
    for (int to = 0; to < outline.size(); to++) {
      double edgeX = outline.xM(to) - outline.xM(from);
      double edgeZ = outline.zM(to) - outline.zM(from);
      int count = (int) Math.ceil(Math.sqrt(edgeX * edgeX + edgeZ * edgeZ) / longestM);
      int first = all[0].length;
      for (int i = 0; i < all.length; i++) {
        all[i] = Arrays.copyOf(all[i], first + count);
      }
      for (int i = 0; i < count; i++) {
        double share = (i + 0.5) / count;
        all[0][first + i] = outline.xM(from) + share * edgeX;
        all[1][first + i] = outline.zM(from) + share * edgeZ;
        all[2][first + i] = sense * edgeZ / count;
        all[3][first + i] = -sense * edgeX / count;
      }
      from = to;
    }
    xM = all[0];
    zM = all[1];
    outX = all[2];
    outZ = all[3];
  }

  /**
   * One echo.
   *
   * @param offCentreRad by how much it comes from the left of the line to the centre
   * @param levelDb its level, a sum over the band, of no distance
   */
  record Echo(double offCentreRad, double levelDb) {}

  /**
   * Returns the echo.
   *
   * @param bearingRad of the sensor in the outline's own frame
   * @param distanceM from the sensor to the frame's origin, positive
   */
  Echo echo(double bearingRad, double distanceM) {
    Sum sum = new Sum();
    double sightX = -Math.sin(bearingRad);
    double sightZ = -Math.cos(bearingRad);
    for (int i = 0; i < xM.length; i++) {
      double awayX = xM[i] + distanceM * sightX;
      double awayZ = zM[i] + distanceM * sightZ;
      double away = Math.sqrt(awayX * awayX + awayZ * awayZ);
      double facing = -(awayX * outX[i] + awayZ * outZ[i]) / away;
      if (facing > 0) {
        double across = sightZ * awayX - sightX * awayZ;
        double along = sightX * awayX + sightZ * awayZ;
        double way = 2 * wavenumberPerM * (away - distanceM);
        sum.add(facing * distanceM / away, way, Math.atan2(across, along));
      }
    }
    return sum.echo();
  }

  /**
   * Returns the level of the echo alone, which is found sooner, as a mean over the band; parameters
   * as of {@link #echo}.
   *
   * @return decibels, of a piece of one metre that faces the sensor
   */
  double levelDb(double bearingRad, double distanceM) {
    double[] real = new double[WAVES];
    double[] imaginary = new double[WAVES];
    double eyeX = distanceM * Math.sin(bearingRad);
    double eyeZ = distanceM * Math.cos(bearingRad);
    for (int i = 0; i < xM.length; i++) {
      double awayX = xM[i] - eyeX;
      double awayZ = zM[i] - eyeZ;
      double facing = -(awayX * outX[i] + awayZ * outZ[i]);
      if (facing > 0) {
        double away = Math.sqrt(awayX * awayX + awayZ * awayZ);
        double weight = facing * distanceM / (away * away);
        double way = 2 * wavenumberPerM * (away - distanceM);
        double step = 2 * BAND * way / (WAVES - 1);
        double inPhase = weight * Math.cos((1 - BAND) * way);
        double behind = weight * Math.sin((1 - BAND) * way);
        double stepCos = Math.cos(step);
        double stepSin = Math.sin(step);
        for (int wave = 0; wave < WAVES; wave++) {
          real[wave] += inPhase;
          imaginary[wave] += behind;
          double next = inPhase * stepCos - behind * stepSin;
          behind = behind * stepCos + inPhase * stepSin;
          inPhase = next;
        }
      }
    }
    double power = 0;
    for (int wave = 0; wave < WAVES; wave++) {
      power += real[wave] * real[wave] + imaginary[wave] * imaginary[wave];
    }
    return 10 * Math.log10(Math.max(LEAST_POWER, power / WAVES));
  }

  /** What the pieces add up to at each frequency of the band. */
  private static final class Sum {
    private final double[] real = new double[WAVES];
    private final double[] imaginary = new double[WAVES];
    private final double[] realSide = new double[WAVES];
    private final double[] imaginarySide = new double[WAVES];
    private double leftRad = Double.NEGATIVE_INFINITY;
    private double rightRad = Double.POSITIVE_INFINITY;

    void add(double weight, double phaseRad, double sideRad) {
      leftRad = Math.max(leftRad, sideRad);
      rightRad = Math.min(rightRad, sideRad);
      for (int wave = 0; wave < WAVES; wave++) {
        double phase = phaseRad * (1 + BAND * (2.0 * wave / (WAVES - 1) - 1));
        double inPhase = weight * Math.cos(phase);
        double behind = weight * Math.sin(phase);
        real[wave] += inPhase;
        imaginary[wave] += behind;
        realSide[wave] += inPhase * sideRad;
        imaginarySide[wave] += behind * sideRad;
      }
    }

    Echo echo() {
      double power = 0;
      double moment = 0;
      for (int wave = 0; wave < WAVES; wave++) {
        power += real[wave] * real[wave] + imaginary[wave] * imaginary[wave];
        moment += real[wave] * realSide[wave] + imaginary[wave] * imaginarySide[wave];
      }
      if (!(power > 0)) {
        return new Echo(0, 10 * Math.log10(LEAST_POWER));
      }
      // Of waves that all but cancel, the mean may lie beside the obstacle.
      double side = Math.max(rightRad, Math.min(leftRad, moment / power));
      return new Echo(side, 10 * Math.log10(Math.max(LEAST_POWER, power)));
    }
  }
}
