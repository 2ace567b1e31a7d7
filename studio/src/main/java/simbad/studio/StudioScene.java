package simbad.studio;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import simbad.experiments.run.RunSettings;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.JsonInput;
import simbad.sonar.frame.Point;

/**
 * What the page asks to see; the same scene is always the same world, step by step.
 *
 * @param obstacle name of the catalogue; it stands at the origin until it is moved
 * @param sensor name as on the command line
 * @param sonar name of its figures in the catalogue
 * @param robot name of how the robot moves; empty for exactly as it is told
 * @param robots how many, in [1, {@value #MOST_ROBOTS}]
 * @param start of the first robot, or the main experiment's own
 * @param speedMPerS of the robot
 * @param seed of all chance
 * @param moves by hand, in the order of their steps
 */
record StudioScene(
    String obstacle,
    String sensor,
    String sonar,
    String robot,
    int robots,
    Optional<Point> start,
    double speedMPerS,
    long seed,
    List<Move> moves) {
  static final String FORMAT = "simbad-studio/1";
  static final int MOST_MOVES = 200;
  static final int MOST_ROBOTS = 12;

  private static final Path NAME = Path.of("scene");

  StudioScene {
    moves = List.copyOf(moves);
  }

  /**
   * Reads a question's scene.
   *
   * @param json an object of the format {@value #FORMAT}
   * @throws DataFormatException naming the field that is wrong
   */
  static StudioScene of(JsonInput json) throws DataFormatException {
    JsonInput format = json.field("format");
    if (!format.isText(FORMAT)) {
      throw format.isNot("\"" + FORMAT + "\"");
    }
    int robots = json.has("robots") ? whole(json.field("robots"), 1, MOST_ROBOTS) : 1;
    return new StudioScene(
        json.text("obstacle"),
        json.text("sensor"),
        json.has("sonar") ? json.text("sonar") : Choices.SONAR,
        json.has("robot") ? json.text("robot") : "",
        robots,
        json.has("start") ? Optional.of(point(json.field("start"))) : Optional.empty(),
        json.field("speed_m_per_s")
            .number(
                v -> v > 0 && v <= RunSettings.GREATEST_SPEED_M_PER_S,
                "in (0, " + RunSettings.GREATEST_SPEED_M_PER_S + "]"),
        json.field("seed").whole(),
        moves(json, robots));
  }

  /** Every robot that is moved must be there. */
  private static int number(JsonInput item, int robots) throws DataFormatException {
    return item.has("number") ? whole(item.field("number"), 0, robots - 1) : 0;
  }

  private static int whole(JsonInput field, int low, int high) throws DataFormatException {
    return (int)
        field.number(
            v -> v >= low && v <= high && v == Math.rint(v),
            "a whole number in [" + low + ", " + high + "]");
  }

  /** Reads a question: JSON as the page sends it. */
  static JsonInput question(String text) throws DataFormatException {
    return JsonInput.parse(NAME, text);
  }

  private static List<Move> moves(JsonInput json, int robots) throws DataFormatException {
    List<Move> moves = new ArrayList<>();
    int before = 0;
    for (JsonInput item : json.items("moves")) {
      Move move = move(item, robots);
      if (move.step() < before || moves.size() == MOST_MOVES) {
        throw item.fault("is out of order, or one of more than " + MOST_MOVES);
      }
      before = move.step();
      moves.add(move);
    }
    return moves;
  }

  private static Move move(JsonInput item, int robots) throws DataFormatException {
    Move.Thing thing = item.has("robot") ? Move.Thing.ROBOT : Move.Thing.OBSTACLE;
    Point to = point(item.field(thing.name().toLowerCase(Locale.ROOT)));
    return new Move(
        step(item.field("step")), thing, number(item, robots), to.xM(), to.zM(), turnRad(item));
  }

  /** Files from before obstacles could be turned lack it. */
  private static double turnRad(JsonInput item) throws DataFormatException {
    if (!item.has("turn_deg")) {
      return 0;
    }
    JsonInput turn = item.field("turn_deg");
    if (item.has("robot")) {
      throw turn.fault("is of obstacles only");
    }
    return Math.toRadians(turn.number(v -> Math.abs(v) <= 360, "in [-360, 360]"));
  }

  static int step(JsonInput field) throws DataFormatException {
    return whole(field, 0, LiveWorld.MOST_STEPS);
  }

  private static Point point(JsonInput pair) throws DataFormatException {
    List<JsonInput> items = pair.items();
    if (items.size() != 2) {
      throw pair.isNot("[x, z]");
    }
    return new Point(coordinate(items.get(0)), coordinate(items.get(1)));
  }

  private static double coordinate(JsonInput item) throws DataFormatException {
    return item.number(
        v -> Math.abs(v) <= Move.FARTHEST_M,
        "in [-" + Move.FARTHEST_M + ", " + Move.FARTHEST_M + "] m");
  }
}
