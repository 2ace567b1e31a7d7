package simbad.gap.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;
import simbad.definition.Effect;
import simbad.gap.fixture.Worlds;
import simbad.sonar.effect.Clues.HeardArc;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.frame.Pose;
import simbad.sonar.ping.PingLog;
import simbad.sonar.sensing.Echo;
import simbad.sonar.sensing.NoEcho;
import simbad.sonar.sensing.ReadingRow;

/** A sensor on a servo 80 cm before a post, a reading each degree. */
class ArcSearchTest {
  private static final List<Form> FORMS = Forms.all(Worlds.POST, List.of("s"));

  private static List<ReadingRow> scan(Hypothesis truth, double secondX) {
    List<ReadingRow> poses = new ArrayList<>();
    for (int degrees = 0; degrees <= 180; degrees++) {
      Pose pose = Pose.of(degrees % 2 * secondX, 0.8, Math.toRadians(degrees));
      poses.add(new ReadingRow("r", "s", 0.1 * degrees, pose, NoEcho.NO_ECHO));
    }
    return Worlds.read(poses, truth, 9);
  }

  private static Hypothesis turnedAndWider() {
    Form wider = Forms.find(Effect.BEAM_WIDTH, "cone", Worlds.POST, List.of("s")).orElseThrow();
    return Worlds.effect(Effect.BEAM_MISALIGNMENT, "all", 15).and(wider, 9);
  }

  private static Optional<HeardArc> arc(List<ReadingRow> rows) {
    return new LogClues(Worlds.given(rows), Hypothesis.NONE).heardArc();
  }

  /**
   * A sensor that looks 15 degrees more to the left hears the post as if that were to the right.
   */
  @Test
  void arc_tellsTurnAndWidth() {
    HeardArc arc = arc(scan(turnedAndWider(), 0)).orElseThrow();
    assertEquals(-15, Math.toDegrees(arc.turnRad()), 1);
    assertEquals(9, Math.toDegrees(arc.widerRad()), 1);
    double asideM = 0.8 * Math.sin(Math.toRadians(15));
    assertEquals(asideM, arc.xM(), 0.02);
    assertEquals(0.8 - 0.8 * Math.cos(Math.toRadians(15)), arc.zM(), 0.01);
  }

  /** A post that stands there is found there. */
  @Test
  void arc_isWhereThePostStands() {
    Hypothesis aside = Worlds.effect(Effect.OBSTACLE_OFFSET, "all", -0.2, 0);
    HeardArc arc = arc(scan(aside, 0)).orElseThrow();
    assertEquals(-0.2, arc.xM(), 0.02);
    assertTrue(arc.turnRad() > 0, "to the left");
  }

  @Test
  void strays_changeNothing() {
    List<ReadingRow> rows = scan(turnedAndWider(), 0);
    Random random = new Random(2);
    List<ReadingRow> strayed = new ArrayList<>();
    for (ReadingRow row : rows) {
      boolean stray = random.nextInt(25) == 0;
      strayed.add(
          !stray
              ? row
              : new ReadingRow(
                  row.run(),
                  row.sensor(),
                  row.timeS(),
                  row.pose(),
                  new Echo(0.3 + 2 * random.nextDouble())));
    }
    HeardArc clean = arc(rows).orElseThrow();
    HeardArc found = arc(strayed).orElseThrow();
    assertEquals(clean.turnRad(), found.turnRad(), Math.toRadians(1.5));
    assertEquals(clean.widerRad(), found.widerRad(), Math.toRadians(1.5));
  }

  @Test
  void starts_areOfATurnOrAMoveWithACone() {
    List<Hypothesis> starts = ArcSearch.starts(Worlds.given(scan(turnedAndWider(), 0)), FORMS);
    Set<Set<Effect>> sets = new HashSet<>();
    starts.forEach(start -> sets.add(new TreeSet<>(start.effects())));
    assertEquals(
        Set.of(
            Set.of(Effect.BEAM_MISALIGNMENT, Effect.BEAM_WIDTH),
            Set.of(Effect.OBSTACLE_OFFSET, Effect.BEAM_WIDTH)),
        sets);
  }

  @Test
  void noArc_whereTheSensorMovesOrHearsNothing() {
    assertEquals(Optional.empty(), arc(scan(Hypothesis.NONE, 0.01)));
    List<ReadingRow> silent = new ArrayList<>();
    scan(Hypothesis.NONE, 0)
        .forEach(
            row ->
                silent.add(
                    new ReadingRow(
                        row.run(), row.sensor(), row.timeS(), row.pose(), NoEcho.NO_ECHO)));
    assertEquals(Optional.empty(), arc(silent));
    assertEquals(List.of(), ArcSearch.starts(Worlds.given(silent), FORMS));
    assertEquals(Optional.empty(), arc(List.of()));
    assertEquals(0, new PingLog(List.of()).echoes());
  }
}
