package simbad.sonar.catalogue;

import static java.util.stream.Collectors.joining;
import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.BearingFactor;
import simbad.sonar.change.FaceLobe;
import simbad.sonar.change.OrientationShadow;
import simbad.sonar.change.OrientationShadows;
import simbad.sonar.change.OtherOutline;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.frame.Angles;
import simbad.sonar.frame.Point;
import simbad.sonar.level.StrengthTable;
import simbad.sonar.ping.OutlineLevels;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.Detection;
import simbad.sonar.scene.Scene;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.StrengthDetection;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.Outline;
import simbad.sonar.shape.ThresholdTable;

/** The threshold depends on the bearing, while the simulator believes it uniform. */
public final class OrientationShadowEffect implements Definition {
  private static final double MOST_THRESHOLD_M = 20;

  private static final double MOST_SIDE_M = 0.5;
  private static final String POST = "post:";
  private static final String FACE = "face:";

  /** What is more than so many times as wide as it is deep is a plate. */
  private static final double PLATE = 2;

  /** A mirror of a few wavelengths sends no echo back from further aside; what is left is less. */
  private static final double MOST_TURNED_DEG = 45;

  private static final double MOST_LEFT = 0.5;

  /** Who turns a plate by degrees cannot tell a sharper border from one that is at once. */
  private static final double SHARP_DEG = 0.3;

  /** A side's lobe is some five degrees wide. */
  private static final int TURN_STEP_DEG = 3;

  /** As many as hold a side's lobe. */
  private static final int STRENGTHS = 144;

  /** A table's step. */
  private static final double ONE_SIDE_DEG = 360.0 / Forms.TABLE_SIZE;

  @Override
  public Effect effect() {
    return Effect.ORIENTATION_SHADOW;
  }

  @Override
  public String happens() {
    return "the threshold depends on the bearing, but it was believed to be the same all "
        + "round";
  }

  @Override
  public String briefly() {
    return "the threshold depends on the bearing";
  }

  @Override
  public String cause() {
    return "an obstacle with flat faces and edges, which sends more sound back to some sides";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    List<String> labels = Scenes.labels(setup.scene());
    int[] uniform =
        IntStream.range(0, labels.size())
            .filter(i -> setup.scene().obstacles().get(i).detection() instanceof UniformDetection)
            .toArray();
    List<Form> forms = new ArrayList<>();
    for (int i : uniform) {
      String name = labels.get(i) + "#" + i;
      forms.add(table("table:" + name, labels.get(i), uniformM(setup, i)));
      forms.add(waved("waves:" + name, Optional.of(labels.get(i))));
      faceRad(setup.scene().obstacles().get(i).outline())
          .ifPresent(rad -> forms.add(faced(FACE + name, labels.get(i), rad)));
    }
    if (uniform.length > 1) {
      forms.add(tables(setup, uniform));
    }
    if (labels.size() > 1 && uniform.length == labels.size()) {
      forms.add(waved("waves", Optional.empty()));
    }
    return forms;
  }

  /**
   * Strengths are by bearing already; but what is believed to be the same all round may stand for a
   * post with flat sides, whose echo and nearest point depend on the bearing together.
   */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    List<String> labels = Scenes.labels(setup.scene());
    return IntStream.range(0, labels.size())
        .filter(i -> setup.scene().obstacles().get(i).detection() instanceof UniformDetection)
        .mapToObj(i -> post(setup, labels.get(i), i))
        .toList();
  }

  private Form post(SensingSetup setup, String label, int obstacle) {
    Outline outline = setup.scene().obstacles().get(obstacle).outline();
    OutlineLevels believed = new OutlineLevels(outline, LevelForms.wavenumberPerM(setup));
    Posts posts = new Posts(believed.wavenumberPerM());
    return Form.of(
        effect(),
        POST + label + "#" + obstacle,
        v ->
            v[0] > 0 && v[1] > 0
                ? new OtherOutline(
                    Optional.of(label), believed, posts.of(v[0], v[1]), Math.toRadians(v[2]))
                : new OtherOutline(Optional.of(label), believed, believed, 0),
        Parameter.of("width_m", 0, 0, MOST_SIDE_M, 0.03, 0.06),
        Parameter.of("depth_m", 0, 0, MOST_SIDE_M, 0.03, 0.06),
        Parameter.of("turn_deg", 0, -90, 90, 0, 20).asClosed());
  }

  /**
   * Posts with flat sides. A fit turns one many times before it makes another, so that the last few
   * are kept: what they are does not depend on it.
   */
  private static final class Posts {
    private static final int KEPT = 16;
    private final double wavenumberPerM;
    private final Map<Point, OutlineLevels> last =
        new LinkedHashMap<>() {
          @Override
          protected boolean removeEldestEntry(Map.Entry<Point, OutlineLevels> eldest) {
            return size() > KEPT;
          }
        };

    Posts(double wavenumberPerM) {
      this.wavenumberPerM = wavenumberPerM;
    }

    synchronized OutlineLevels of(double widthM, double depthM) {
      return last.computeIfAbsent(new Point(widthM / 2, depthM / 2), this::levels);
    }

    private OutlineLevels levels(Point corner) {
      double x = corner.xM();
      double z = corner.zM();
      return new OutlineLevels(
          Outline.of(
              List.of(new Point(-x, -z), new Point(-x, z), new Point(x, z), new Point(x, -z))),
          wavenumberPerM);
    }
  }

  private static boolean isPost(Form form) {
    return form.name().startsWith(POST);
  }

  private static double uniformM(SensingSetup setup, int obstacle) {
    return setup.scene().obstacles().get(obstacle).detection().greatestM();
  }

  private Form table(String name, String label, double uniformM) {
    return Form.of(
        effect(),
        name,
        v -> new OrientationShadow(Optional.of(label), ThresholdTable.of(v)),
        thresholds("", uniformM).toArray(Parameter[]::new));
  }

  /** Every obstacle that is believed uniform has a table of its own. */
  private Form tables(SensingSetup setup, int... obstacles) {
    List<String> labels = Scenes.labels(setup.scene());
    List<Parameter> all = new ArrayList<>();
    for (int obstacle : obstacles) {
      all.addAll(thresholds(labels.get(obstacle) + "_", uniformM(setup, obstacle)));
    }
    String numbers = Arrays.stream(obstacles).mapToObj(String::valueOf).collect(joining(","));
    return Form.of(
        effect(),
        "tables#" + numbers,
        v -> {
          List<OrientationShadow> each = new ArrayList<>();
          for (int i = 0; i < obstacles.length; i++) {
            double[] own = Arrays.copyOfRange(v, i * Forms.TABLE_SIZE, (i + 1) * Forms.TABLE_SIZE);
            each.add(
                new OrientationShadow(
                    Optional.of(labels.get(obstacles[i])), ThresholdTable.of(own)));
          }
          return new OrientationShadows(each);
        },
        all.toArray(Parameter[]::new));
  }

  private static List<Parameter> thresholds(String prefix, double uniformM) {
    double most = Math.max(MOST_THRESHOLD_M, 2 * uniformM);
    return IntStream.range(0, Forms.TABLE_SIZE)
        .mapToObj(i -> prefix + "threshold_" + i * 360 / Forms.TABLE_SIZE + "_deg_m")
        .map(name -> Parameter.of(name, uniformM, 0, most, uniformM).asClosed())
        .toList();
  }

  /** A shadow of few lobes, which few readings tell of. */
  private Form waved(String name, Optional<String> only) {
    List<Parameter> series = new ArrayList<>();
    series.add(Parameter.of("level", 0, -1, 1, 0).asClosed());
    for (int wave = 1; wave <= Forms.SHADOW_WAVES; wave++) {
      series.add(Parameter.of("cos_" + wave, 0, -1, 1, 0).asClosed());
      series.add(Parameter.of("sin_" + wave, 0, -1, 1, 0).asClosed());
    }
    return Form.of(
        effect(),
        name,
        v -> new BearingFactor(only, Arrays.stream(v).boxed().toList()),
        series.toArray(Parameter[]::new));
  }

  /** Of a plate, which is heard square to its faces. */
  private Form faced(String name, String label, double faceRad) {
    return Form.of(
        effect(),
        name,
        v ->
            new FaceLobe(
                Optional.of(label), faceRad, Math.toRadians(v[0]), Math.toRadians(v[1]), v[2]),
        Parameter.of("half_angle_deg", 30, 1, 80, 15, 25),
        Parameter.of("soft_deg", SHARP_DEG, SHARP_DEG, 20, 2),
        Parameter.of("floor", 1, 0, 1, 0.05, 0.4).asClosed());
  }

  /** The bearing of a plate's face; empty for what is no plate. */
  private static OptionalDouble faceRad(Outline outline) {
    List<Point> corners = outline.corners();
    int longest = 0;
    for (int i = 1; i < corners.size(); i++) {
      longest = edgeM(corners, i) > edgeM(corners, longest) ? i : longest;
    }
    Point from = corners.get(longest);
    Point to = corners.get((longest + 1) % corners.size());
    double lengthM = edgeM(corners, longest);
    double alongX = (to.xM() - from.xM()) / lengthM;
    double alongZ = (to.zM() - from.zM()) / lengthM;
    DoubleSummaryStatistics width = across(corners, alongX, alongZ);
    DoubleSummaryStatistics depth = across(corners, -alongZ, alongX);
    return width.getMax() - width.getMin() > PLATE * (depth.getMax() - depth.getMin())
        ? OptionalDouble.of(Math.atan2(-alongZ, alongX))
        : OptionalDouble.empty();
  }

  private static double edgeM(List<Point> corners, int first) {
    Point from = corners.get(first);
    Point to = corners.get((first + 1) % corners.size());
    return Math.hypot(to.xM() - from.xM(), to.zM() - from.zM());
  }

  private static DoubleSummaryStatistics across(List<Point> corners, double x, double z) {
    return corners.stream().mapToDouble(c -> c.xM() * x + c.zM() * z).summaryStatistics();
  }

  /** A form that is about no single obstacle has no number: each obstacle's waves may be all's. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    if (form.with(form.neutral()) instanceof OtherOutline same) {
      return posts(same.believed().outline());
    }
    if (form.name().startsWith(FACE)) {
      return Tries.all(form);
    }
    int hash = form.name().lastIndexOf('#');
    if (hash < 0) {
      return IntStream.range(0, clues.obstacles()).mapToObj(clues::waves).toList();
    }
    String[] numbers = form.name().substring(hash + 1).split(",", -1);
    int[] obstacles = Arrays.stream(numbers).mapToInt(Integer::parseInt).toArray();
    return List.of(form.isTable() ? clues.tables(obstacles) : clues.waves(obstacles[0]));
  }

  /** Square posts of the same area, turned so that one has its sides near the real one's. */
  private static List<double[]> posts(Outline believed) {
    double sideM = Math.min(MOST_SIDE_M, Math.sqrt(Math.abs(believed.signedAreaM2())));
    return IntStream.range(0, 90 / TURN_STEP_DEG)
        .mapToObj(i -> new double[] {sideM, sideM, i * TURN_STEP_DEG - 45.0})
        .toList();
  }

  /** A tenth by bearing: thresholds that swing twice about the believed ones in a turn. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return Forms.of(this, setup, log.sensors()).stream()
        .filter(table -> table.neutral()[0] > 0)
        .map(table -> Probe.alone(swinging(table), 0, 0.1))
        .toList();
  }

  private Form swinging(Form table) {
    double[] uniformM = table.neutral();
    return Form.of(
        effect(),
        table.name(),
        v ->
            table.with(
                IntStream.range(0, uniformM.length)
                    .mapToDouble(i -> uniformM[i] * swing(v[0], i, uniformM.length))
                    .toArray()),
        new Parameter("relative_swing", 0, 0, 0.9, List.of(), false));
  }

  private static double swing(double share, int index, int size) {
    return 1 + share * Math.cos(index * 4 * Math.PI / size);
  }

  /** A plate mirrors: who turns it before a sensor turns its echo away. */
  @Override
  public boolean isInvited(Form form, LogDesign log, double... values) {
    return form.name().startsWith(FACE) && values[0] < MOST_TURNED_DEG && values[2] < MOST_LEFT;
  }

  @Override
  public boolean canShow(Form form, LogDesign log) {
    if (form.name().startsWith(FACE)) {
      return log.isTurnedBefore();
    }
    // What is believed to be round may be another post; if it is the same one, it is round.
    boolean canBe = isPost(form) || !log.isOfRoundOnes(form, false);
    return canBe && !log.isFromOneSide(ONE_SIDE_DEG);
  }

  /** Of a post with flat sides: its outline, and how strongly that answers all round. */
  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    if (!(form.with(values) instanceof OtherOutline other)) {
      return Definition.super.corrected(stated, form, values);
    }
    Scene scene = Scenes.detected(stated.scene(), other.only(), d -> heard(stated, other, d));
    return Optional.of(stated.with(other.apply(scene)));
  }

  private static Detection heard(SensingSetup stated, OtherOutline other, Detection believed) {
    double thresholdM = believed.greatestM();
    double uniformDb = stated.sensor().levelLaw().strengthDb(thresholdM);
    double[] strengthDb = new double[STRENGTHS];
    Arrays.setAll(
        strengthDb, i -> uniformDb + other.strongerDb(i * Angles.TURN_RAD / STRENGTHS, thresholdM));
    return StrengthDetection.of(
        StrengthTable.of(strengthDb), stated.sensor().levelLaw(), stated.sensor().maxRangeM());
  }

  @Override
  public String remedy(FittedValues values) {
    if (values.has("half_angle_deg")) {
      return text(
          "give the obstacle a threshold table: its face answers up to %.0f degrees from square",
          values.value("half_angle_deg"));
    }
    return values.has("width_m")
        ? text(
            "give the obstacle the outline that it has, some %.0f by %.0f mm with flat sides, and "
                + "a threshold table instead of one range",
            1000 * values.value("width_m"), 1000 * values.value("depth_m"))
        : "give the obstacle a threshold table instead of one range";
  }
}
