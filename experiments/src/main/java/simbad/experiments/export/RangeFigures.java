package simbad.experiments.export;

import simbad.sonar.change.CoarseResolution.Reported;

/**
 * What is reported for a distance: scaled, shifted, not below a least, in steps.
 *
 * @param scale of the distance, positive
 * @param offsetM added afterwards, metres
 * @param clampM nothing nearer is reported, metres, at least 0
 * @param stepM length of a step, metres; 0 for none
 * @param reported which steps there are
 * @param codeM what is reported for no echo, metres; negative for no echo
 */
record RangeFigures(
    double scale, double offsetM, double clampM, double stepM, Reported reported, double codeM) {
  static final RangeFigures AS_IT_IS = new RangeFigures(1, 0, 0, 0, Reported.START, -1);

  /** What is added before a step's number is cut off, in halves of a step. */
  int fromHalves() {
    return reported == Reported.NEAREST ? 1 : 0;
  }

  /** What of a step is added to its number, in halves. */
  int reportHalves() {
    return reported == Reported.CENTRE ? 1 : 0;
  }

  RangeFigures scaled(double factor) {
    return new RangeFigures(scale * factor, offsetM * factor, clampM, stepM, reported, codeM);
  }

  RangeFigures shifted(double byM) {
    return new RangeFigures(scale, offsetM + byM, clampM, stepM, reported, codeM);
  }

  RangeFigures clamped(double leastM) {
    return new RangeFigures(scale, offsetM, Math.max(clampM, leastM), stepM, reported, codeM);
  }

  RangeFigures stepped(double newStepM, Reported as) {
    return new RangeFigures(scale, offsetM, clampM, newStepM, as, codeM);
  }

  RangeFigures coded(double newCodeM) {
    return new RangeFigures(scale, offsetM, clampM, stepM, reported, newCodeM);
  }

  /** What is reported for a distance, metres. */
  double reportedM(double distanceM) {
    double range = Math.max(clampM, distanceM * scale + offsetM);
    return stepM > 0
        ? (Math.floor(range / stepM + fromHalves() / 2.0) + reportHalves() / 2.0) * stepM
        : range;
  }
}
