package simbad.blindworld.wavechange;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import simbad.blindworld.wave.FixedEcho;
import simbad.blindworld.wave.Mirrored;
import simbad.blindworld.wave.Outline;
import simbad.blindworld.wave.Reflector;
import simbad.blindworld.wave.Target;
import simbad.blindworld.wave.Upright;
import simbad.blindworld.world.Point;

/** What happens to things around. */
final class SceneChanges {

  private static final String OBJECT = "unmodelled-object";

  private SceneChanges() {}

  static List<WaveForm> all() {
    return List.of(
        new WaveForm("obstacle-turn", SceneChanges::someEdged, SceneChanges::turn),
        WaveForm.anywhere("obstacle-offset", SceneChanges::offset),
        WaveForm.anywhere(OBJECT, SceneChanges::board),
        WaveForm.anywhere("multipath", SceneChanges::wall),
        WaveForm.anywhere("floor-echo", SceneChanges::floor),
        new WaveForm("orientation-shadow", SceneChanges::someUniform, SceneChanges::square));
  }

  private static boolean someEdged(Site site) {
    return site.room().articles().stream().anyMatch(a -> !a.isRound());
  }

  private static boolean someUniform(Site site) {
    return site.scene().obstacles().stream().anyMatch(o -> o.shadow().isUniform());
  }

  private static Reflector moved(Reflector reflector, double xM, double zM) {
    return reflector instanceof Target target ? target.moved(xM, zM) : reflector;
  }

  private static Reflector turned(Reflector reflector, double byRad) {
    return reflector instanceof Target target ? target.turned(byRad) : reflector;
  }

  private static WaveEffect turn(Site site) {
    int index = site.someObstacle();
    while (site.room().articles().get(index).isRound()) {
      index = site.someObstacle();
    }
    double deg = site.eitherWay(7);
    return WaveEffect.of(
        "obstacle-turn",
        Map.of("obstacle", index, "deg", deg),
        Alterations.instead(index, r -> turned(r, Math.toRadians(deg))));
  }

  private static WaveEffect offset(Site site) {
    int index = site.someObstacle();
    double m = site.sized(0.06);
    double direction = site.between(0, 2 * Math.PI);
    double x = m * StrictMath.cos(direction);
    double z = m * StrictMath.sin(direction);
    return WaveEffect.of(
        "obstacle-offset",
        Map.of("obstacle", index, "x", x, "z", z),
        Alterations.instead(index, r -> moved(r, x, z)));
  }

  /** A board's two ends and the board itself, beside an obstacle, facing it more or less. */
  private record Board(Point middle, Point from, Point to, Target target) {

    static Board draw(Site site, double widthM, double awayM) {
      int index = site.someObstacle();
      Point place = site.target(index).place();
      Point middle = site.beside(index, awayM);
      double towards = StrictMath.atan2(middle.zM() - place.zM(), place.xM() - middle.xM());
      // A slab's broad side looks along its own z; turned by a right angle it looks along x.
      double turn = towards + Math.PI / 2 + site.between(-0.5, 0.5);
      double x = widthM / 2 * StrictMath.cos(turn);
      double z = -widthM / 2 * StrictMath.sin(turn);
      Outline outline =
          Outline.of(
              List.of(
                  new Point(-widthM / 2, -0.005),
                  new Point(widthM / 2, -0.005),
                  new Point(widthM / 2, 0.005),
                  new Point(-widthM / 2, 0.005)));
      double mount = site.room().mountHeightM();
      Target target = new Target(outline, new Upright(-mount, 1 - mount), middle, turn);
      return new Board(
          middle,
          new Point(middle.xM() - x, middle.zM() - z),
          new Point(middle.xM() + x, middle.zM() + z),
          target);
    }

    Map<String, Object> parameters(double widthM) {
      return Map.of("what", "board", "x", middle.xM(), "z", middle.zM(), "width_m", widthM);
    }
  }

  private static WaveEffect board(Site site) {
    double width = Math.min(1.2, site.sized(0.4));
    Board board = Board.draw(site, width, site.between(0.5, 1.4));
    return WaveEffect.of(
        OBJECT, board.parameters(width), Alterations.more(List.of(board.target())));
  }

  /** A board so wide that echoes also come by it; so it answers itself, too. */
  private static WaveEffect wall(Site site) {
    double width = Math.min(1.8, site.sized(1));
    Board board = Board.draw(site, width, site.between(0.35, 0.7));
    List<Reflector> added = new ArrayList<>();
    added.add(board.target());
    for (Target target : site.room().targets()) {
      added.add(new Mirrored(target, board.from(), board.to()));
    }
    return WaveEffect.of("multipath", board.parameters(width), Alterations.more(added))
        .accepting(List.of(Set.of(OBJECT), Set.of("multipath", OBJECT)));
  }

  /** The floor's roughness or the robot's own edge answers, now over the threshold, now under. */
  private static WaveEffect floor(Site site) {
    double at = site.between(0.45, 1.2);
    double db = StrictMath.log(site.size()) / StrictMath.log(2) - 0.5;
    double scatter = site.between(1, 3);
    return WaveEffect.of(
        "floor-echo",
        Map.of("m", at, "excess_db", db, "scatter_db", scatter),
        Alterations.more(List.of(new FixedEcho(at, db, scatter))));
  }

  /** A square post stands where a round one stood that its user believed the same all round. */
  private static WaveEffect square(Site site) {
    int index = site.someObstacle();
    while (!site.scene().obstacles().get(index).shadow().isUniform()) {
      index = site.someObstacle();
    }
    double radius = site.room().articles().get(index).outline().radiusM();
    double half = radius * Math.sqrt(Math.PI) / 2;
    Outline post =
        Outline.of(
            List.of(
                new Point(-half, -half),
                new Point(half, -half),
                new Point(half, half),
                new Point(-half, half)));
    return WaveEffect.of(
        "orientation-shadow",
        Map.of("obstacle", index, "side_m", 2 * half),
        Alterations.instead(index, r -> r instanceof Target target ? target.with(post) : r));
  }
}
