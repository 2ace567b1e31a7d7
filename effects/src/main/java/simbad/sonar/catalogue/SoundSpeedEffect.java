package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.DoubleSummaryStatistics;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.definition.Trait;
import simbad.sonar.change.AirTemperature;
import simbad.sonar.change.LevelAbsorption;
import simbad.sonar.change.OtherAir;
import simbad.sonar.change.ReadingScale;
import simbad.sonar.change.SoundSpeed;
import simbad.sonar.effect.Clues;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.LogDesign;
import simbad.sonar.effect.Modes;
import simbad.sonar.effect.Probe;
import simbad.sonar.effect.Tries;
import simbad.sonar.level.Air;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;
import simbad.sonar.scene.SonarSpec;

/** The sound travels faster or slower than assumed. */
public final class SoundSpeedEffect implements Definition {
  /** A wrong unit or constant scales ranges by a fifth to five times; neither is at a bound. */
  private static final double MOST_SCALE = 5.5;

  /**
   * Believed over read: what is taken for another unit or way is so exactly, and steps that are
   * scaled leave no room between (inches, feet, one way for both, some timers).
   */
  private static final double[] UNITS = {
    0.2, 0.25, 0.3048, 1 / 2.54, 0.5, 0.94, 0.98, 1.02, 1.06, 2, 2.54, 1 / 0.3048, 4, 5
  };

  private static final int MODES = 4;

  /** The form that needs the air's temperature ping by ping. */
  private static final String TEMPERATURE = "temperature";

  /** Air that changes by less changes the speed of sound by less than a thousandth. */
  private static final double LEAST_CHANGE_C = 0.5;

  private static final double LEAST_FOLLOWED = 0.1;
  private static final double DEGREES_OF_AIR = 0.606;
  private static final double FREEZING_M_S = 331.3;

  /** Air between these is air; any other speed is a wrong constant or a wrong unit. */
  private static final double COLDEST_M_S = 318;

  private static final double HOTTEST_M_S = 362;

  /** Air of -40 and of 70 degrees. */
  private static final double LEAST_AIR_M_S = 306;

  private static final double MOST_AIR_M_S = 371;

  private static final String AIR = "air";
  private static final String SPEED = "sound_speed_m_s";
  private static final String HUMIDITY = "humidity_percent";

  @Override
  public Effect effect() {
    return Effect.SOUND_SPEED;
  }

  @Override
  public String happens() {
    return "sound is faster or slower than assumed: every range is scaled";
  }

  @Override
  public String briefly() {
    return "sound is faster or slower than assumed";
  }

  @Override
  public String cause() {
    return "warmer or colder air, a wrong constant, a wrong unit";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    double assumed = setup.sensor().assumedSoundSpeedMPerS();
    double steps = stepsM(setup.sensor());
    return List.of(
        Form.of(
            effect(),
            "scale",
            v -> new SoundSpeed(assumed / v[0]),
            speed(assumed, 0.94, 0.98, 1.02, 1.06)),
        Form.of(
            effect(),
            "reading",
            v -> new ReadingScale(assumed / v[0], steps),
            speed(assumed, UNITS)),
        Form.of(
            effect(),
            TEMPERATURE,
            v -> new AirTemperature(assumed / v[0], v[1]),
            speed(assumed, 0.98, 1, 1.02),
            Parameter.of("follows", 0, 0, 1, 0.5, 1).asClosed()));
  }

  /** Warmer air is faster, and takes more of an echo; how much more hangs on how damp it is. */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    double assumed = setup.sensor().assumedSoundSpeedMPerS();
    double hz = LevelForms.frequencyHz(setup.sensor());
    List<Form> forms = new ArrayList<>(forms(setup, sensors));
    forms.add(
        Form.of(
            effect(),
            AIR,
            v ->
                new OtherAir(
                    new SoundSpeed(assumed / v[0]),
                    new LevelAbsorption(addedDbPerM(assumed, v[0], v[1], hz))),
            Parameter.of(
                SPEED,
                assumed,
                Math.min(assumed, LEAST_AIR_M_S),
                Math.max(assumed, MOST_AIR_M_S),
                0.96 * assumed,
                0.98 * assumed,
                1.02 * assumed,
                1.04 * assumed),
            Parameter.of(HUMIDITY, Air.ROOM.humidityPercent(), 2, 98, 10, 50, 90).asClosed()));
    return forms;
  }

  /** What air of one speed of sound takes more than that of another one, equally damp. */
  private static double addedDbPerM(double from, double to, double humidityPercent, double hz) {
    return Air.nearest(to, humidityPercent).absorptionDbPerM(hz)
        - Air.nearest(from, humidityPercent).absorptionDbPerM(hz);
  }

  /**
   * Steps that are finer than the scatter do not show. Scaled, they beat with the steps of the log,
   * and a fit would follow the beat.
   */
  private static double stepsM(SonarSpec sensor) {
    return sensor.resolutionM() > sensor.rangeNoiseM() ? sensor.resolutionM() : 0;
  }

  private static Parameter speed(double assumed, double... shares) {
    return Parameter.of(
        SPEED,
        assumed,
        assumed / MOST_SCALE,
        assumed * MOST_SCALE,
        Arrays.stream(shares).map(share -> share * assumed).toArray());
  }

  /** That of which most readings are the same multiple of a distance, beside the usual ones. */
  @Override
  public List<double[]> starts(Form form, Clues clues) {
    DoubleStream logarithms =
        clues
            .echoesInCone()
            .filter(i -> clues.log().rangeM(i) > 0 && clues.nearestM(i) > 0)
            .mapToDouble(i -> Math.log(clues.log().rangeM(i) / clues.nearestM(i)));
    List<Double> speeds = new ArrayList<>(form.parameters().get(0).tries());
    double assumed = form.parameters().get(0).neutral();
    Modes.of(logarithms, 0.02, MODES)
        .forEach(logarithm -> speeds.add(assumed / Math.exp(logarithm)));
    return form.parameters().size() == 1
        ? Tries.product(form, speeds)
        : Definition.super.starts(form, clues);
  }

  /** A temperature shows where the log has it, it changes, and the sensor may not know it. */
  @Override
  public boolean canShow(Form form, LogDesign log) {
    if (!form.name().equals(TEMPERATURE)) {
      return true;
    }
    DoubleSummaryStatistics known =
        IntStream.range(0, log.log().size())
            .mapToDouble(log.log()::temperatureC)
            .filter(Double::isFinite)
            .summaryStatistics();
    return known.getMax() - known.getMin() >= LEAST_CHANGE_C
        && !log.setup().details().temperatureCompensated().orElse(false);
  }

  /** 3 m/s is 5 degrees of the air. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    return List.of(
        Probe.alone(Forms.find(effect(), "scale", setup, log.sensors()).orElseThrow(), 0, 3));
  }

  /** Half a kelvin is 0.3 m/s. */
  @Override
  public boolean isWithinDays(Form form, double... values) {
    return isPlain(form) && Math.abs(values[0] - form.neutral()[0]) < 0.6;
  }

  @Override
  public Set<Effect> twins(LogDesign log) {
    return log.alikeInRange(effect());
  }

  @Override
  public String remedy(FittedValues values) {
    double speed = values.value(SPEED);
    double assumed = values.sensor().assumedSoundSpeedMPerS();
    if (values.value("follows") > LEAST_FOLLOWED) {
      return text(
          "compute with the speed of sound of each reading's temperature: %.1f m/s at 20 degrees",
          speed);
    }
    if (!isAir(speed)) {
      return text(
          "multiply readings by %.4g: that is a unit or a constant, not the air", speed / assumed);
    }
    String compute =
        text(
            "compute with %.1f m/s (air of %.0f degrees), not %.1f",
            speed, (speed - FREEZING_M_S) / DEGREES_OF_AIR, assumed);
    return values.has(HUMIDITY) ? compute + absorbs(values) : compute;
  }

  private static String absorbs(FittedValues values) {
    double more =
        addedDbPerM(
            values.sensor().assumedSoundSpeedMPerS(),
            values.value(SPEED),
            values.value(HUMIDITY),
            LevelForms.frequencyHz(values.sensor()));
    return text("; it takes %.1f dB/m %s of an echo", Math.abs(more), more < 0 ? "less" : "more");
  }

  /** A wrong unit is no speed of sound: readings are to be mended then, not the scene. */
  @Override
  public Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    return isAir(values[0]) && isPlain(form)
        ? Optional.of(stated.with(stated.sensor().withSoundSpeed(values[0])))
        : Optional.empty();
  }

  /** Of one speed of sound, whatever else it brings. */
  private static boolean isPlain(Form form) {
    return form.parameters().size() == 1 || form.name().equals(AIR);
  }

  private static boolean isAir(double speed) {
    return speed >= COLDEST_M_S && speed <= HOTTEST_M_S;
  }

  @Override
  public Set<Trait> traits() {
    return Set.of(Trait.MOVES_RANGES, Trait.LAW_OF_RANGES);
  }
}
