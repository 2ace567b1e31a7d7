package simbad.sonar.predict;

import java.util.List;
import simbad.sonar.model.Report;
import simbad.sonar.ping.OutputChange;

/** Several ways of reporting, one after the other. */
record OutputChain(List<OutputChange> outputs) implements Report {
  @Override
  public double reported(double rangeM) {
    double reported = rangeM;
    for (OutputChange output : outputs) {
      reported = output.reported(reported);
    }
    return reported;
  }

  @Override
  public double leastRange(double reportedM) {
    double least = reportedM;
    for (int i = outputs.size() - 1; i >= 0; i--) {
      least = outputs.get(i).leastRange(least);
    }
    return least;
  }
}
