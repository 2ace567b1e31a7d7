package simbad.sonar.catalogue;

import static java.lang.Math.toRadians;
import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.Crosstalk;
import simbad.sonar.change.LevelBoard;
import simbad.sonar.change.LevelPost;
import simbad.sonar.change.UnmodelledObject;
import simbad.sonar.change.UnmodelledPost;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.frame.Placement;
import simbad.sonar.frame.Point;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.Obstacle;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;

/** Something that is not in the scene answers from a fixed place. */
public final class UnmodelledObjectEffect implements Definition {
  private static final String POST = "post";
  private static final String BEHIND = "behind";
  private static final String POST_BY_LEVEL = "post by level";
  private static final String BOARD_BY_LEVEL = "board by level";
  private static final Parameter RADIUS = Parameter.of("radius_m", 0, 0, 0.5, 0.05);
  private static final Parameter X = Parameter.of("x_m", 0, -20, 20, 0);
  private static final Parameter Z = Parameter.of("z_m", 0, -20, 20, 0);
  private static final Parameter NORMAL = Parameter.of("normal_deg", 0, -400, 400, 0).asClosed();
  private static final Parameter WIDTH = Parameter.of("half_width_m", 0, 0.02, 10, 0.4).asClosed();
  private static final Parameter SURE = Parameter.of("share", 0, 0.1, 1, 0.95).asClosed();
  private static final double AHEAD_M = 0.5;

  private static final double MOST_OFTEN = 0.5;

  /** Where behind it most of what is heard there is. */
  private static final double FEW = 0.02;

  private static final int OBJECTS = 6;
  private static final double LEAST_RADIUS_M = 0.005;
  private static final int CORNERS = 16;

  @Override
  public Effect effect() {
    return Effect.UNMODELLED_OBJECT;
  }

  @Override
  public String happens() {
    return "something that is not in the scene sends back echoes from a fixed place";
  }

  @Override
  public String briefly() {
    return "something that is not in the scene sends back echoes";
  }

  @Override
  public String cause() {
    return "furniture, a wall, a post, a cable, a person";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double most = setup.sensor().maxRangeM();
    Parameter reach = Parameter.of("reach_m", most, 0.05, most, most);
    return List.of(
        Form.of(
            effect(),
            "mirror",
            v -> new UnmodelledObject(v[0], v[1], toRadians(v[2]), v[3], 0, most, v[4]),
            X,
            Z,
            NORMAL,
            WIDTH,
            SURE),
        Form.of(
            effect(),
            "face",
            v ->
                new UnmodelledObject(
                    v[0], v[1], toRadians(v[2]), v[3], toRadians(v[5]), v[6], v[4]),
            X,
            Z,
            NORMAL,
            WIDTH,
            SURE,
            Parameter.of("square_deg", 30, 3, 90, 15, 40).asClosed(),
            reach),
        Form.of(
            effect(),
            POST,
            v -> new UnmodelledPost(v[0], v[1], v[2], v[3], toRadians(v[5]), v[4]),
            X,
            Z,
            RADIUS,
            reach,
            SURE,
            Parameter.of("square_deg", 90, 3, 90, 90).asClosed()),
        behind(most));
  }

  /** Many things at unknown places, which are heard where the simulator hears nothing. */
  private Form behind(double mostM) {
    return Form.of(
        effect(),
        BEHIND,
        v -> new Crosstalk(v[0], v[1], v[1] + v[2], true),
        Parameter.of("share", 0, 0, 1, 0.5, 0.95).asClosed(),
        Parameter.of("low_m", 0, 0, 0.9 * mostM, 0.05).asClosed(),
        Parameter.of("band_m", mostM, 0.3, mostM, 0.5 * mostM, mostM).asClosed());
  }

  @Override
  public boolean isHeardInSilence(String form) {
    return BEHIND.equals(form);
  }

  /** What is behind an obstacle that is turned away is heard in its place. */
  @Override
  public boolean isInvited(Form form, LogDesign log, double... values) {
    return BEHIND.equals(form.name()) && values[0] > MOST_OFTEN;
  }

  @Override
  public boolean canShow(Form form, LogDesign log) {
    return !BEHIND.equals(form.name()) || log.isTurnedBefore();
  }

  /** What is heard of a thing depends on how strong it is, and so on where it is seen from. */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    List<Form> forms = new ArrayList<>();
    forms.add(
        Form.of(
            effect(),
            BOARD_BY_LEVEL,
            v -> new LevelBoard(v[0], v[1], toRadians(v[2]), v[3], v[4]),
            X,
            Z,
            NORMAL,
            WIDTH,
            Parameter.of("reflected_db", Double.NEGATIVE_INFINITY, -40, 10, 0, -10)));
    forms.add(
        Form.of(
            effect(),
            POST_BY_LEVEL,
            v -> new LevelPost(v[0], v[1], v[2], v[3]),
            X,
            Z,
            RADIUS,
            Parameter.of("strength_db", Double.NEGATIVE_INFINITY, -70, 20, -30, -20)));
    forms.addAll(forms(setup, sensors));
    return forms;
  }

  @Override
  public List<double[]> starts(Form form, Clues clues) {
    return switch (form.name()) {
      case POST -> clues.posts(form.parameters().get(3).high());
      case POST_BY_LEVEL -> byLevel(form, clues.posts(clues.strangeRangesM().max().orElse(1)), 3);
      case BEHIND -> behind(form, clues);
      case BOARD_BY_LEVEL -> byLevel(form, clues.faces(form), 4);
      default -> clues.faces(form);
    };
  }

  private static List<double[]> behind(Form form, Clues clues) {
    double[] sorted = clues.strangeRangesM().sorted().toArray();
    if (sorted.length == 0) {
      return Tries.all(form);
    }
    double low = Modes.quantile(sorted, FEW) - 0.02;
    double high = Modes.quantile(sorted, 1 - FEW) + 0.02;
    return Tries.product(form, List.of(), List.of(low), List.of(high - low));
  }

  /** The first values of each start, and every strength that is tried. */
  private static List<double[]> byLevel(Form form, List<double[]> starts, int at) {
    List<double[]> all = new ArrayList<>();
    for (double[] start : starts) {
      for (double strength : form.parameters().get(at).tries()) {
        double[] one = Arrays.copyOf(start, at + 1);
        one[at] = strength;
        all.add(one);
      }
    }
    return all;
  }

  /** Posts in front of poses spread over the log, which answer half of the pings that face them. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    List<double[]> places = new ArrayList<>();
    for (int i = 0; i < OBJECTS && log.size() > 0; i++) {
      int ping = (int) ((i + 0.5) / OBJECTS * log.size());
      double x = log.xM(ping) + AHEAD_M * Math.cos(log.headingRad(ping));
      double z = log.zM(ping) - AHEAD_M * Math.sin(log.headingRad(ping));
      places.add(new double[] {x, z, 0, setup.sensor().maxRangeM(), 0, 90});
    }
    Form post =
        forms(setup, log.sensors()).stream()
            .filter(form -> form.name().equals(POST))
            .findFirst()
            .orElseThrow();
    return List.of(new Probe(post, 4, 0.5, places));
  }

  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    if (!(form.with(values) instanceof UnmodelledPost post)) {
      return Optional.empty();
    }
    List<Obstacle> obstacles = new ArrayList<>(stated.scene().obstacles());
    obstacles.add(obstacle(post));
    return Optional.of(stated.with(new Scene(obstacles)));
  }

  /** Round, and heard from all sides. */
  private static Obstacle obstacle(UnmodelledPost post) {
    double radius = Math.max(LEAST_RADIUS_M, post.radiusM());
    List<Point> corners =
        IntStream.range(0, CORNERS)
            .mapToObj(i -> 2 * Math.PI * i / CORNERS)
            .map(angle -> new Point(radius * Math.cos(angle), -radius * Math.sin(angle)))
            .toList();
    return new Obstacle(
        "found",
        new Placement(post.xM(), post.zM(), 0),
        Outline.of(corners),
        new UniformDetection(radius + post.reachM()));
  }

  @Override
  public String remedy(FittedValues values) {
    if (values.has("band_m")) {
      return text(
          "clear away what stands %.1f to %.1f m before the sensor, or put it into the scene",
          values.value("low_m"), values.value("low_m") + values.value("band_m"));
    }
    return text(
        "look at x = %.2f m, z = %.2f m, and put what is there into the scene",
        values.value("x_m"), values.value("z_m"));
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.SOAKS_UP, Trait.SOAKS_UP_PLACEMENTS);
  }
}
