package simbad.sonar.effect;

import java.util.List;
import simbad.sonar.model.Report;

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
