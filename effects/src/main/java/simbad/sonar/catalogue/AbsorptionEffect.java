package simbad.sonar.catalogue;

import static simbad.sonar.effect.FittedValues.text;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import simbad.definition.Effect;
import simbad.definition.Parameter;
import simbad.sonar.change.Absorption;
import simbad.sonar.change.LevelAbsorption;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.FittedValues;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.effect.Probe;
import simbad.sonar.level.Air;
import simbad.sonar.level.LevelDefaults;
import simbad.sonar.ping.PingLog;
import simbad.sonar.scene.SensingSetup;

/** Far thresholds shrink more than near ones. */
public final class AbsorptionEffect implements Definition {
  @Override
  public Effect effect() {
    return Effect.ABSORPTION;
  }

  @Override
  public String happens() {
    return "far thresholds shrink more than near ones";
  }

  @Override
  public String briefly() {
    return "echoes lose strength with the length of their way";
  }

  @Override
  public String cause() {
    return "air of another temperature or humidity";
  }

  @Override
  public List<Form> forms(SensingSetup setup, List<String> sensors) {
    return Arrays.stream(Absorption.Law.values())
        .map(
            law ->
                Form.of(
                    effect(),
                    law.name().toLowerCase(Locale.ROOT),
                    v -> new Absorption(v[0], law),
                    Parameter.of("loss_per_m", 0, 0, 1.5, 0.05, 0.1, 0.2, 0.4)))
        .toList();
  }

  /**
   * No air takes more than {@link Air#mostDbPerM} says: what seems to take more is no air. A room's
   * air is what may have been believed in vain.
   */
  @Override
  public List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    double hz = setup.sensor().law().level().frequencyHz().orElse(LevelDefaults.FREQUENCY_HZ);
    double most = Air.mostDbPerM(hz) - Air.leastDbPerM(hz);
    double least = -Air.ROOM.absorptionDbPerM(hz);
    double[] starts = {0.6 * least, 0.3 * least, most / 5, 2 * most / 5, 3 * most / 4};
    return List.of(
        Form.of(
            effect(),
            "level",
            v -> new LevelAbsorption(v[0]),
            Parameter.of("added_db_per_m", 0, least, most, starts)));
  }

  /** 0.05 for each metre is a tenth at two; a fifth of a decibel per metre. */
  @Override
  public List<Probe> probes(SensingSetup setup, PingLog log) {
    boolean level = setup.sensor().law().isLevel();
    List<Form> forms = Forms.of(this, setup, log.sensors());
    return List.of(Probe.alone(forms.get(0), 0, level ? 0.2 : 0.05));
  }

  /** 0.15 dB at a metre and a half, there and back. */
  @Override
  public boolean isWithinDays(Form form, double... values) {
    return Math.abs(values[0] - form.neutral()[0]) < 0.1;
  }

  @Override
  public String remedy(FittedValues values) {
    return values.has("added_db_per_m")
        ? text(
            "log the air's temperature and humidity: it takes %+.2f dB for each metre more than"
                + " was believed",
            values.value("added_db_per_m"))
        : text(
            "shorten the far thresholds, by about %.0f %% for each metre, or log the air's"
                + " temperature and humidity",
            100 * values.value("loss_per_m"));
  }
}
