package simbad.sonar.catalogue;

import static java.util.stream.Collectors.joining;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.BearingFactor;
import simbad.sonar.change.OrientationShadow;
import simbad.sonar.change.OrientationShadows;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Probe;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.Scenes;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.UniformDetection;
import simbad.sonar.shape.ThresholdTable;

/** The threshold depends on the bearing, while the simulator believes it uniform. */
public final class OrientationShadowEffect implements Definition {
  private static final double MOST_THRESHOLD_M = 20;

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
    }
    if (uniform.length > 1) {
      forms.add(tables(setup, uniform));
    }
    if (labels.size() > 1 && uniform.length == labels.size()) {
      forms.add(waved("waves", Optional.empty()));
    }
    return forms;
  }

  /** Of a shadow there is nothing left to find: strengths are by bearing. */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    return List.of();
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

  /** A form that is about no single obstacle has no number: each obstacle's waves may be all's. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    int hash = form.name().lastIndexOf('#');
    if (hash < 0) {
      return IntStream.range(0, clues.obstacles()).mapToObj(clues::waves).toList();
    }
    String[] numbers = form.name().substring(hash + 1).split(",", -1);
    int[] obstacles = Arrays.stream(numbers).mapToInt(Integer::parseInt).toArray();
    return List.of(form.isTable() ? clues.tables(obstacles) : clues.waves(obstacles[0]));
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

  @Override
  public boolean canShow(Form form, LogDesign log) {
    return !log.isOfRoundOnes(form, false) && !log.isFromOneSide(ONE_SIDE_DEG);
  }

  @Override
  public String remedy(FittedValues values) {
    return "give the obstacle a threshold table instead of one range";
  }
}
