package simbad.sonar.model;

/** How a sensor reports what it measured, before the rounding to its resolution. */
public interface Report {
  /** As measured. */
  Report AS_MEASURED =
      new Report() {
        @Override
        public double reported(double rangeM) {
          return rangeM;
        }

        @Override
        public double leastRange(double reportedM) {
          return reportedM;
        }
      };

  /** Returns what is reported for a measured range, both in metres; never falling. */
  double reported(double rangeM);

  /**
   * Returns the least measured range whose report is not below a value.
   *
   * @param reportedM metres
   * @return metres; negative infinity where every report is above it
   */
  double leastRange(double reportedM);
}
