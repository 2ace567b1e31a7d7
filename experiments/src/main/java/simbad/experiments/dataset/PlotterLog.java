package simbad.experiments.dataset;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import simbad.sonar.check.Checks;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/**
 * A sensor on a pen plotter before a ball: columns {@code x, y} in millimetres on the plotter,
 * {@code ultra} in whole centimetres, 765 for no target.
 *
 * <p>Seen from above the plane of the drawing is the line z = ball's radius + distance, x is the
 * world's, and the sensor looks along -z. Lines of the plotter within 12 mm of the ball's height
 * are taken as at its height; the others are left out, for a scene seen from above has no height.
 * What the log does not say: pings follow every 0.1 s, the sensor's quickest; its cone is 20
 * degrees to each side; the backdrop is 1 m wide. The simulator believes neither a near limit nor a
 * backdrop that it is not told of.
 */
public final class PlotterLog {
  /** The MB1213's number for no target, centimetres. */
  public static final double NO_TARGET_CM = 765;

  private static final double MM = 1000;
  private static final double SOUND_M_PER_S = 343;
  private static final double PERIOD_S = 0.1;
  private static final double BAND_MM = 12;
  private static final double BALL_RADIUS_M = 0.0375;
  private static final double BACKDROP_M = 1;
  private static final double HEARD_M = 7.65;

  private PlotterLog() {}

  /**
   * What was set up before the plotter.
   *
   * @param ballXMm where on the plotter the ball is
   * @param ballYMm likewise
   * @param distanceMm from the plane to the ball's front
   * @param backdropMm from the plane to a board behind; empty where there is none
   */
  public record Setup(
      double ballXMm, double ballYMm, double distanceMm, OptionalDouble backdropMm) {
    /** Checks that all are finite. */
    public Setup {
      Checks.finite("ballXMm", ballXMm);
      Checks.finite("ballYMm", ballYMm);
      Checks.finite("distanceMm", distanceMm);
      Checks.finite("backdropMm", backdropMm);
    }
  }

  /**
   * Converts a log.
   *
   * @param file csv
   * @param setup what was before the plotter
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public static MadeDataSet read(Path file, Setup setup) throws DataFormatException {
    LogTable log = LogTable.read(file, LogFormat.PLAIN);
    int x = LogColumns.require(log, "x");
    int y = LogColumns.require(log, "y");
    int ultra = LogColumns.require(log, "ultra");
    double awayM = setup.distanceMm() / MM;
    LogRows rows = new LogRows();
    rows.take(
        log,
        new LogRows.Plan(
            List.of(RowRule.within(y, setup.ballYMm() - BAND_MM, setup.ballYMm() + BAND_MM)),
            List.of(new LogRows.Range(ultra, "MB1213")),
            new RangeRule(Unit.CM, SOUND_M_PER_S, NoEchoCodes.of(Optional.of(">=" + NO_TARGET_CM))),
            PoseRule.ladder(
                LoggedFigure.constant(awayM, Unit.M),
                LoggedFigure.column(x, Unit.MM, 0).from(setup.ballXMm()),
                BALL_RADIUS_M),
            Clock.ofRows(PERIOD_S),
            LogRows.Labels.of("scan"),
            Map.of()),
        false);
    if (rows.rows().isEmpty()) {
      throw log.fault("has no row within " + BAND_MM + " mm of y = " + setup.ballYMm());
    }
    return new MadeDataSet(believed(setup, BALL_RADIUS_M + awayM), rows.rows());
  }

  private static SensingSetup believed(Setup setup, double zM) {
    SonarSpec sensor =
        new SonarSpec(
            "MB1213",
            Math.toRadians(20),
            0,
            7.65,
            0.2,
            SOUND_M_PER_S,
            0.01,
            0.005,
            0.005,
            0.05,
            PERIOD_S);
    List<Obstacle> obstacles = new ArrayList<>();
    obstacles.add(Shapes.ball("apple", BALL_RADIUS_M, HEARD_M));
    setup
        .backdropMm()
        .ifPresent(
            mm -> obstacles.add(Shapes.board("backdrop", zM - mm / MM, BACKDROP_M, HEARD_M)));
    return new SensingSetup(sensor, new Scene(obstacles), HEARD_M);
  }
}
