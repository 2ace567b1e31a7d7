package simbad.experiments.bag;

/**
 * A rigid motion in space: turn, then move. ROS's frames: x forward, y to the left, z up (REP-103).
 *
 * @param xM metres
 * @param yM metres
 * @param zM metres
 * @param qx of the unit quaternion
 * @param qy of the unit quaternion
 * @param qz of the unit quaternion
 * @param qw of the unit quaternion
 */
record Rigid(double xM, double yM, double zM, double qx, double qy, double qz, double qw) {
  static final Rigid NONE = new Rigid(0, 0, 0, 0, 0, 0, 1);

  private static final double LEAST_NORM = 1e-6;
  private static final double NEARLY_ALIKE = 0.9995;

  /**
   * Makes one of x, y, z, qx, qy, qz, qw. A quaternion of no length, which some drivers leave
   * there, is no turn.
   */
  static Rigid of(double... n) {
    double norm = Math.sqrt(n[3] * n[3] + n[4] * n[4] + n[5] * n[5] + n[6] * n[6]);
    return norm < LEAST_NORM
        ? new Rigid(n[0], n[1], n[2], 0, 0, 0, 1)
        : new Rigid(n[0], n[1], n[2], n[3] / norm, n[4] / norm, n[5] / norm, n[6] / norm);
  }

  /** Returns where this frame has what stands at another motion in it. */
  Rigid times(Rigid inner) {
    double[] moved = turned(inner.xM, inner.yM, inner.zM);
    return of(
        xM + moved[0],
        yM + moved[1],
        zM + moved[2],
        qw * inner.qx + qx * inner.qw + qy * inner.qz - qz * inner.qy,
        qw * inner.qy - qx * inner.qz + qy * inner.qw + qz * inner.qx,
        qw * inner.qz + qx * inner.qy - qy * inner.qx + qz * inner.qw,
        qw * inner.qw - qx * inner.qx - qy * inner.qy - qz * inner.qz);
  }

  /** Turns a vector: v + 2 w (q x v) + 2 q x (q x v). */
  private double[] turned(double x, double y, double z) {
    double cx = 2 * (qy * z - qz * y);
    double cy = 2 * (qz * x - qx * z);
    double cz = 2 * (qx * y - qy * x);
    return new double[] {
      x + qw * cx + qy * cz - qz * cy,
      y + qw * cy + qz * cx - qx * cz,
      z + qw * cz + qx * cy - qy * cx
    };
  }

  /** Returns the motion between this one and another: straight, and the shortest turn (slerp). */
  Rigid towards(Rigid other, double share) {
    double dot = qx * other.qx + qy * other.qy + qz * other.qz + qw * other.qw;
    double sign = dot < 0 ? -1 : 1;
    double cos = Math.min(1, Math.abs(dot));
    double mine = 1 - share;
    double theirs = share;
    if (cos < NEARLY_ALIKE) {
      double angle = Math.acos(cos);
      mine = Math.sin((1 - share) * angle) / Math.sin(angle);
      theirs = Math.sin(share * angle) / Math.sin(angle);
    }
    double by = sign * theirs;
    return of(
        xM + share * (other.xM - xM),
        yM + share * (other.yM - yM),
        zM + share * (other.zM - zM),
        mine * qx + by * other.qx,
        mine * qy + by * other.qy,
        mine * qz + by * other.qz,
        mine * qw + by * other.qw);
  }

  /** Returns the direction of its x axis seen from above, radians, counter-clockwise. */
  double yawRad() {
    return Math.atan2(2 * (qw * qz + qx * qy), 1 - 2 * (qy * qy + qz * qz));
  }
}
