package simbad.cli;

import java.io.IOException;
import java.util.Locale;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import simbad.experiments.table.ThesisCalibration;
import simbad.scattering.FittedReceiver;
import simbad.scattering.Receiver;

/** {@code simbad table calibrate}. */
@Command(
    name = "calibrate",
    description = {
      "Fit the prediction's three figures again to what the thesis says about its " + "obstacles.",
      "Compares them with the figures that simbad table predict uses.",
      "Exit status 1 if they are not the same. The method: docs/method/scattering.md."
    },
    footer = {"", "Example: simbad table calibrate --without-angle"})
final class TableCalibrateCommand extends Subcommand {
  @Option(
      names = "--without-angle",
      description =
          "Leave out the angle's measured table, as for simbad table predict " + "--without-angle.")
  private boolean withoutAngle;

  @Override
  protected void run() throws Exception {
    FittedReceiver shipped = withoutAngle ? FittedReceiver.WITHOUT_ANGLE : FittedReceiver.SRF04;
    FittedReceiver fitted = ThesisCalibration.fit(!withoutAngle);
    out()
        .println(
            withoutAngle
                ? "fitted to: round, square (words)"
                : "fitted to: round, square (words), angle (72 measured)");
    line("level L", "dB", shipped.receiver().levelDb(), fitted.receiver().levelDb());
    line("K", "", shipped.receiver().desensitisation(), fitted.receiver().desensitisation());
    line("tau", "ms", 1e3 * shipped.receiver().recoveryS(), 1e3 * fitted.receiver().recoveryS());
    if (withoutAngle) {
      line("band", "dB either way, of the fit with the angle", shipped.spreadDb());
    } else {
      line("band", "dB either way", shipped.spreadDb(), fitted.spreadDb());
    }
    if (!agrees(shipped, fitted)) {
      throw new IOException("the figures in use are not those of the fit");
    }
    out().println("the figures in use are those of the fit");
  }

  /** A few words say nothing of scatter: without the angle the band is not fitted. */
  private boolean agrees(FittedReceiver shipped, FittedReceiver fitted) {
    Receiver inUse = shipped.receiver();
    return withoutAngle ? inUse.equals(fitted.receiver()) : shipped.equals(fitted);
  }

  private void line(String name, String unit, double shipped, double fitted) {
    out().println(text(name, fitted, unit) + (shipped == fitted ? "" : ", in use " + shipped));
  }

  private void line(String name, String unit, double shipped) {
    out().println(text(name, shipped, unit));
  }

  private static String text(String name, double value, String unit) {
    return String.format(Locale.ROOT, "  %s %s %s", name, value, unit).stripTrailing();
  }
}
