package simbad.blindworld.wavechange;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotSame;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import simbad.blindworld.wave.Alteration;
import simbad.blindworld.wave.Ear;
import simbad.blindworld.wave.FixedEcho;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.WavePing;
import simbad.blindworld.world.FixedChance;
import simbad.blindworld.world.Point;
import simbad.blindworld.world.Recording;

/** What alterations and effects are made of, and where they are put in. */
class AlterationsTest {

  private static final double NONE = Double.POSITIVE_INFINITY;
  private static final double NEAR = 1e-12;
  private static final WavePing PING = WaveGround.after(0.5);
  private static final List<Reflector> THINGS =
      List.of(new FixedEcho(1, 2, 3), new FixedEcho(4, 5, 6));

  private static Ear ear(Alteration alteration) {
    return alteration.ear(WaveGround.ROUND, WaveGround.ROUND.tracks().get(0), 1);
  }

  @Test
  void alteration_isOfOneThingOnly() {
    Alteration louder = Alterations.gear(g -> g.louder(3));
    assertEquals(3, louder.gear("s", WaveGround.GEAR).levelDb());
    assertEquals(WaveGround.AIR, louder.air(WaveGround.AIR));
    assertEquals(THINGS, louder.reflectors(THINGS));
    assertEquals(0, louder.headroomDb());
    assertEquals(0.3, louder.scatterDb(0.3));
    Alteration warmer = Alterations.air(a -> a.warmer(5));
    assertEquals(25, warmer.air(WaveGround.AIR).temperatureC());
    assertSame(WaveGround.GEAR, warmer.gear("s", WaveGround.GEAR));
    assertEquals(1.5, ear(warmer).rangeM(1.5, PING));
  }

  @Test
  void things_areReplacedOrAdded_inACopy() {
    FixedEcho other = new FixedEcho(7, 8, 9);
    assertEquals(
        List.of(THINGS.get(0), other), Alterations.instead(1, r -> other).reflectors(THINGS));
    assertEquals(
        List.of(THINGS.get(0), THINGS.get(1), other),
        Alterations.more(List.of(other)).reflectors(THINGS));
    assertEquals(2, THINGS.size());
  }

  @Test
  void ears_changeTheirOwnStep() {
    Ear arrival = ear(Alterations.arrival(() -> (t, ping) -> t + ping.share()));
    assertEquals(1.5, arrival.arrivalS(1, PING));
    assertEquals(1, arrival.rangeM(1, PING));
    Ear range = ear(Alterations.range((r, ping) -> r * ping.share()));
    assertEquals(1, range.rangeM(2, PING));
    assertEquals(2, range.arrivalS(2, PING));
    Ear report = ear(Alterations.report(() -> (r, ping) -> r - ping.share()));
    assertEquals(0.5, report.reportedM(1, PING));
    assertEquals(1, report.steppedM(1, 3, PING));
    assertEquals(0, report.louderDb(PING));
  }

  /** A memory is of one track. */
  @Test
  void ear_isAnotherOneForEachTrack() {
    Alteration counts =
        Alterations.report(
            () -> {
              int[] pings = {0};
              return (r, ping) -> ++pings[0];
            });
    Ear one = ear(counts);
    assertNotSame(one, ear(counts));
    assertEquals(1, one.reportedM(9, PING));
    assertEquals(2, one.reportedM(9, PING));
    assertEquals(1, ear(counts).reportedM(9, PING));
  }

  @Test
  void louder_isNeverAboveItsHeadroom() {
    Alteration louder = Alterations.louder(4, (zero, ping) -> zero + 10 * ping.share());
    assertEquals(4, louder.headroomDb());
    assertEquals(4, ear(louder).louderDb(PING));
    assertEquals(2, ear(louder).louderDb(WaveGround.after(0.2)), NEAR);
  }

  @Test
  void echo_isWhatIsFinite() {
    assertTrue(Alterations.isEcho(0));
    assertFalse(Alterations.isEcho(NONE));
  }

  @Test
  void effect_keepsWhatItIsCalled() {
    Map<String, Object> parameters = new HashMap<>(Map.of("z", 1, "a", 2, "m", 3));
    WaveEffect plain = WaveEffect.of("gain", parameters, Alterations.air(a -> a));
    parameters.put("q", 4);
    assertEquals(List.of("a", "m", "z"), new ArrayList<>(plain.parameters().keySet()));
    assertThrows(UnsupportedOperationException.class, () -> plain.parameters().clear());
    assertEquals(List.of(Set.of("gain")), plain.accept());
    assertEquals(List.of(), plain.also());
    WaveEffect more =
        plain
            .accepting(List.of(Set.of("absorption")))
            .near(List.of(Set.of("dropout")))
            .near(List.of(Set.of("wrap")));
    assertEquals("gain", more.name());
    assertEquals(List.of(Set.of("gain"), Set.of("absorption")), more.accept());
    assertEquals(List.of(Set.of("dropout"), Set.of("wrap")), more.also());
    assertEquals(plain.parameters(), more.parameters());
    assertSame(plain.alteration(), more.alteration());
  }

  @Test
  void site_sizesByItsSize() {
    Site site = WaveGround.site(new FixedChance(0.25).coins(true, false), 2);
    assertEquals(0.6, site.sized(0.3), NEAR);
    assertEquals(0.6, site.eitherWay(0.3), NEAR);
    assertEquals(-0.6, site.eitherWay(0.3), NEAR);
    assertEquals(3.5, site.between(3, 5), NEAR);
    assertThrows(IllegalArgumentException.class, () -> WaveGround.site(new FixedChance(0.5), -1));
  }

  /** Of ten readings 1.0 to 1.9 m. */
  @Test
  void quantiles_areOfWhatIsHeard() {
    Site site = WaveGround.site(new FixedChance(0.5), 1);
    assertEquals(1.0, site.heardM(0));
    assertEquals(1.0, site.heardM(-3));
    assertEquals(1.2, site.heardM(0.22));
    assertEquals(1.9, site.heardM(1));
    assertEquals(1.9, site.heardM(7));
    assertEquals(List.of(0.5, 1.0, 2.0), Site.heard(new double[] {2, NONE, 0.5, Double.NaN, 1}));
    Site deaf =
        new Site(
            WaveGround.ROOM,
            WaveGround.PARTS,
            WaveGround.SCENE,
            WaveGround.ROUND,
            false,
            List.of(),
            new FixedChance(0.5),
            1);
    assertEquals(1, deaf.heardM(0.5));
  }

  @Test
  void site_knowsPlacesAndTimes() {
    Site site = WaveGround.site(new FixedChance(0.25, 0.75), 1);
    assertEquals(2 * 1.5 / 343.2, site.timeS(1.5), NEAR);
    assertEquals(0, site.someObstacle());
    assertEquals(1, site.someObstacle());
    assertSame(WaveGround.POLE_TARGET, site.target(1));
    // A quarter of a turn is along z, three quarters against it.
    Point down = site.beside(1, 0.5);
    assertEquals(2, down.xM(), NEAR);
    assertEquals(0.5, down.zM(), NEAR);
    assertEquals(-0.5, site.beside(0, 0.5).zM(), NEAR);
    double[] distances = site.distancesM();
    assertEquals(0.8, distances[3], NEAR);
    assertEquals(Math.hypot(0.9, 0.05), distances[8], NEAR);
    assertTrue(site.circumstances().driven());
    assertSame(WaveGround.SCENE, site.circumstances().scene());
  }

  @Test
  void vocabulary_knowsWhereANameApplies() {
    Site driven = WaveGround.site(new FixedChance(0.5), 1);
    Site bench =
        new Site(
            WaveGround.ROOM,
            WaveGround.PARTS,
            WaveGround.SCENE,
            new Recording(List.of(WaveGround.ROUND.rows().get(0))),
            false,
            WaveGround.HEARD,
            new FixedChance(0.5),
            1);
    for (String name : List.of("latency", "odometry-scale", "heading-drift")) {
      assertTrue(WaveVocabulary.needsRobot(name), name);
      assertTrue(WaveVocabulary.applies(name, driven), name);
      assertFalse(WaveVocabulary.applies(name, bench), name);
    }
    assertFalse(WaveVocabulary.needsRobot("gain"));
    assertTrue(WaveVocabulary.applies("gain", bench));
    assertFalse(WaveVocabulary.applies("nothing", bench));
    assertThrows(IllegalArgumentException.class, () -> WaveVocabulary.draw("latency", bench));
    assertTrue(WaveVocabulary.names().contains("gain"));
    assertFalse(WaveVocabulary.names().contains("wind"));
    assertTrue(WaveVocabulary.outside().contains("wind"));
    assertFalse(WaveVocabulary.outside().contains("gain"));
    assertEquals(
        WaveVocabulary.names().stream().sorted().distinct().toList(), WaveVocabulary.names());
  }
}
