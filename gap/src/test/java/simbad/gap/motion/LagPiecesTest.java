package simbad.gap.motion;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import simbad.gap.audit.AuditCheck;
import simbad.gap.audit.AuditFinding;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.TrackPose;
import simbad.motion.format.MotionRow;

/** Commands and tracks that are laid over each other in steps of a twentieth of a second. */
class LagPiecesTest {
  private static final double EXACT = 1e-9;

  private static <T> List<MotionRow<T>> rows(List<T> values) {
    List<MotionRow<T>> rows = new ArrayList<>();
    values.forEach(value -> rows.add(new MotionRow<>(7 + rows.size(), value)));
    return rows;
  }

  /** Straight on at speeds that are held for a second and then change by chance. */
  private static List<Command> commands(double fromS, int count) {
    SplittableRandom random = new SplittableRandom(21);
    List<Command> commands = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      commands.add(new Command(fromS + i, random.nextDouble(0.1, 0.5), 0));
    }
    return commands;
  }

  /** A track that does as it is told so much later, ten times a second. */
  private static List<TrackPose> track(List<Command> commands, double lateS) {
    double fromS = commands.get(0).timeS();
    List<TrackPose> track = new ArrayList<>();
    double x = 0;
    for (int i = 0; i <= 10 * commands.size(); i++) {
      double timeS = fromS + i / 10.0;
      track.add(new TrackPose(timeS, x, 0, 0));
      x += CommandTrail.held(commands, timeS - lateS + 1e-6).speedMPerS() / 10;
    }
    return track;
  }

  /** Of 200 s a tenth each, from 8 s after the first pose on; the last 8 s are looked ahead to. */
  @Test
  void piecesFollowOneAnother_eachWithItsLag() {
    List<Command> commands = commands(500, 200);
    List<Lags.Piece> pieces = Lags.of(rows(commands), rows(track(commands, 0.4)));

    assertEquals(9, pieces.size());
    for (int k = 0; k < 9; k++) {
      Lags.Piece piece = pieces.get(k);
      assertEquals(500 + 8 + 20 * (k + 0.5), piece.timeS(), EXACT);
      assertEquals(0.4, piece.lagS(), 0.04);
      assertEquals(7 + 80 + 200 * k, piece.row(), 1);
    }
  }

  @Test
  void aTrackMayBeAhead() {
    List<Command> commands = commands(0, 60);
    List<TrackPose> early =
        track(commands, 0).stream().map(p -> new TrackPose(p.timeS() - 1.5, p.xM(), 0, 0)).toList();
    List<Lags.Piece> pieces = Lags.of(rows(commands), rows(early));

    // Pieces of 15 s at least.
    assertEquals(2, pieces.size());
    assertEquals(-1.5, pieces.get(0).lagS(), 0.04);
  }

  @Test
  void oneCommandOrOnePoseIsNoGrid() {
    List<MotionRow<Command>> told = rows(commands(0, 2));
    List<MotionRow<TrackPose>> seen = rows(track(commands(0, 2), 0));

    assertTrue(Lags.Grid.of(told, seen).isPresent());
    assertEquals(Optional.empty(), Lags.Grid.of(told.subList(0, 1), seen));
    assertEquals(Optional.empty(), Lags.Grid.of(told, seen.subList(0, 1)));
    assertEquals(List.of(), Lags.of(told, seen.subList(0, 1)));
  }

  /** Speeds over a fifth of a second, forwards or back, and however the heading wraps. */
  @Test
  void aGridShowsWhatTheTrackDid() {
    List<TrackPose> track = new ArrayList<>();
    for (int i = 0; i <= 40; i++) {
      double heading = Math.IEEEremainder(Math.PI - 0.3 + 0.02 * i, 2 * Math.PI);
      double way = 0.03 * i;
      // Towards -x, while its heading turns across half a turn.
      track.add(new TrackPose(10 + i / 10.0, -way, 0, heading));
    }
    List<MotionRow<Command>> told = rows(List.of(new Command(11, 0.3, 0.2), new Command(12, 0, 0)));
    Lags.Grid grid = Lags.Grid.of(told, rows(track)).orElseThrow();

    assertEquals(10, grid.firstS(), 0);
    assertEquals(14, grid.lastS(), 0);
    assertEquals(80, grid.asked()[0].length, 1);
    assertTrue(Double.isNaN(grid.asked()[0][19]) && Double.isNaN(grid.asked()[1][19]));
    assertEquals(0.3, grid.asked()[0][20], 0);
    assertEquals(0.2, grid.asked()[1][39], 0);
    assertEquals(0, grid.asked()[0][40], 0);
    for (int i = 4; i < 75; i++) {
      double off = -0.3 + 0.2 * (i + 0.5) * Lags.STEP_S;
      assertEquals(0.3 * Math.cos(off), grid.did()[0][i], 0.01, "step " + i);
      assertEquals(0.2, grid.did()[1][i], 1e-6, "step " + i);
      assertEquals(0.3, grid.fast()[i], 1e-6);
    }
  }

  /** Two sequences of which one is twice the other and one above, and as much below. */
  @Test
  void correlationIsThatOfTheSpreads() {
    double[] asked = {9, 1, 2, 4, 3, 9};
    double[] twice = {0, 0, 3, 5, 9, 7};
    assertEquals(1, Lags.correlation(asked, twice, 1, 4, 1), EXACT);
    double[] less = {0, -1, -2, -4, -3, 0};
    assertEquals(-1, Lags.correlation(asked, less, 1, 4, 0), EXACT);
    double[] still = {5, 5, 5, 5, 5, 5};
    assertTrue(Double.isNaN(Lags.correlation(asked, still, 1, 4, 0)));
    // Of four one is not seen: 1, 2, 3 beside 2, 3, 1 are minus a half.
    double[] hole = {0, 2, 3, Double.NaN, 1, 0};
    assertEquals(-0.5, Lags.correlation(asked, hole, 1, 4, 0), EXACT);
    double[] half = {0, 2, Double.NaN, Double.NaN, 1, 0};
    assertTrue(Double.isNaN(Lags.correlation(asked, half, 1, 4, 0)));
  }

  private static List<AuditFinding> follows(int changes) {
    List<Command> commands = new ArrayList<>();
    SplittableRandom random = new SplittableRandom(22);
    for (int i = 0; i <= changes; i++) {
      commands.add(new Command(20 + i, random.nextDouble(0.1, 0.5), 0));
    }
    MotionRun other = new Drives(70).data().runs().get(0);
    return FollowCheck.of(Map.of("a", rows(commands)), Map.of("a", rows(other.track())));
  }

  /** Commands that change forty times, beside another's track. */
  @Test
  void fewChangesSayNothingOfWhoseTrackItIs() {
    assertEquals(List.of(), follows(39));
    AuditFinding found = follows(40).get(0);
    assertEquals(AuditCheck.TRACK_FOREIGN, found.check());
    assertEquals(List.of(7), found.rows());
    assertTrue(found.what().contains("run 'a'"), found.what());
    assertEquals(List.of(), FollowCheck.of(Map.of(), Map.of("a", rows(track(commands(0, 90), 0)))));
  }

  /** However late it follows. */
  @Test
  void aTrackThatFollowsIsItsOwn() {
    List<Command> commands = commands(0, 120);
    for (double lateS : new double[] {0, 3, 7}) {
      Map<String, List<MotionRow<TrackPose>>> track = Map.of("a", rows(track(commands, lateS)));
      assertEquals(List.of(), FollowCheck.of(Map.of("a", rows(commands)), track));
    }
  }
}
