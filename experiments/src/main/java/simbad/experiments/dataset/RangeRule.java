package simbad.experiments.dataset;

import java.util.Optional;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.Reading;

/**
 * How a cell becomes a reading.
 *
 * @param unit of its numbers: a length, or the time of flight there and back
 * @param soundSpeedMPerS that turns such a time into a range
 * @param codes for no echo
 */
record RangeRule(Unit unit, double soundSpeedMPerS, NoEchoCodes codes) {

  Reading read(LogTable log, int row, int column) throws DataFormatException {
    String cell = log.text(row, column);
    if (codes.isCode(cell)) {
      LoggedFigure.requireWhole(log, row, column);
      return NoEcho.NO_ECHO;
    }
    Optional<LogNumber> number = log.findNumber(row, column);
    if (number.isEmpty() || !isRange(number.get())) {
      throw log.fault(
          row,
          column,
          "'"
              + cell
              + "' is not a number of at least 0, at most "
              + LoggedFigure.GREATEST
              + hint());
    }
    if (codes.isCode(number.get().value())) {
      return NoEcho.NO_ECHO;
    }
    return new Echo(rangeM(number.get()));
  }

  private boolean isRange(LogNumber number) {
    Unit.Kind kind = number.unit().orElse(unit).kind();
    return codes.isCode(number.value())
        || (kind != Unit.Kind.ANGLE
            && number.value() >= 0
            && number.value() <= LoggedFigure.GREATEST
            && rangeM(number) <= LoggedFigure.GREATEST);
  }

  private String hint() {
    return codes.equals(NoEchoCodes.NONE)
        ? ""
        : " (--no-echo names values that mean no echo, --skip-bad leaves such rows out)";
  }

  private double rangeM(LogNumber number) {
    Unit own = number.unit().orElse(unit);
    double si = own.si(number.value());
    return own.kind() == Unit.Kind.TIME ? si * soundSpeedMPerS / 2 : si;
  }
}
