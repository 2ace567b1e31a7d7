package simbad.blindworld.effect;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import simbad.blindworld.world.Chance;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Pose;
import simbad.blindworld.world.Recording;
import simbad.blindworld.world.Row;

/** Places that a hand is off by, each by its own amount, in closed form. */
class PlacementFormsTest {

  private static final double NEAR = 1e-12;
  private static final String NAME = "placement-error";

  /** Three readings at each of two places of run a; run b has the first place again. */
  private static final Recording ROWS =
      recording(List.of("a", "a", "b"), List.of(pose(1), pose(2), pose(1)), 3);

  private static Pose pose(double xM) {
    return new Pose(xM, 0.5, Math.PI / 2);
  }

  private static Recording recording(List<String> runs, List<Pose> poses, int times) {
    List<Row> rows = new ArrayList<>();
    for (int i = 0; i < poses.size(); i++) {
      for (int k = 0; k < times; k++) {
        rows.add(new Row(runs.get(i), "s", rows.size(), poses.get(i)));
      }
    }
    return new Recording(rows);
  }

  private static Circumstances circumstances(Recording rows, boolean driven, double strength) {
    return new Circumstances(EffectGround.SCENE, rows, driven, new FixedChance(0.5), strength);
  }

  private static List<Pose> moved(String form, double strength, FixedChance chance) {
    Effect effect = Vocabulary.draw(NAME, form, circumstances(ROWS, false, strength));
    assertEquals(0.01 * strength, EffectGround.number(effect, "deviation_m"), NEAR);
    assertTrue(effect.change().restless(), "another hand in each repeat");
    List<Pose> poses = ROWS.rows().stream().map(Row::pose).toList();
    return effect.change().poses(ROWS, poses, chance);
  }

  private static void assertOffBy(double dxM, double dzM, List<Pose> moved, int placement) {
    for (int k = 3 * placement; k < 3 * placement + 3; k++) {
      Pose believed = ROWS.pose(k);
      assertEquals(believed.xM() + dxM, moved.get(k).xM(), NEAR);
      assertEquals(believed.zM() + dzM, moved.get(k).zM(), NEAR);
      assertEquals(believed.headingRad(), moved.get(k).headingRad());
    }
  }

  /** By 2 cm times the numbers that chance says, and never by more than 2.5 times. */
  @Test
  void anyWay_isOneErrorForEachPlacement() {
    FixedChance chance = new FixedChance(0.5).gaussian(1, -0.5, 9, 0, 2, -9);
    List<Pose> moved = moved("any way", 2, chance);
    assertOffBy(0.02, -0.01, moved, 0);
    assertOffBy(0.05, 0, moved, 1);
    assertOffBy(0.04, -0.05, moved, 2);
  }

  /** It looks along (0, -1): at most the square root of 3 times 1 cm to, and as much fro. */
  @Test
  void along_isOnTheAxisOnly() {
    List<Pose> moved = moved("along", 1, new FixedChance(1, 0, 0.75));
    assertOffBy(0, -0.01 * Math.sqrt(3), moved, 0);
    assertOffBy(0, 0.01 * Math.sqrt(3), moved, 1);
    assertOffBy(0, -0.005 * Math.sqrt(3), moved, 2);
  }

  /** The standard deviation of both is what the truth says; the limit costs some 2 %. */
  @Test
  void deviation_isThatOfTheTruth() {
    List<String> runs = new ArrayList<>();
    List<Pose> poses = new ArrayList<>();
    for (int i = 0; i < 4000; i++) {
      runs.add("r" + i);
      poses.add(new Pose(0, 0, 0));
    }
    Recording many = recording(runs, poses, 3);
    for (String form : Vocabulary.forms(NAME)) {
      Effect effect = Vocabulary.draw(NAME, form, circumstances(many, false, 3));
      List<Pose> believed = many.rows().stream().map(Row::pose).toList();
      double squares = 0;
      for (Pose pose : effect.change().poses(many, believed, new Chance(5))) {
        squares += pose.xM() * pose.xM();
      }
      assertEquals(0.03, Math.sqrt(squares / many.size()), 0.0015, form);
    }
  }

  /** Three readings at most places, and a hand. */
  @Test
  void needsSeveralReadingsAtAPlace() {
    assertTrue(Vocabulary.applies(NAME, circumstances(ROWS, false, 1)));
    assertFalse(Vocabulary.applies(NAME, circumstances(ROWS, true, 1)), "a robot drives");
    Recording twice = recording(List.of("a", "a"), List.of(pose(1), pose(2)), 2);
    assertFalse(Vocabulary.applies(NAME, circumstances(twice, false, 1)));
    assertTrue(Vocabulary.needsPlacements(NAME));
    assertFalse(Vocabulary.needsPlacements("wrap"));
  }
}
