package simbad.sonar.effect;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import simbad.definition.Effect;
import simbad.definition.Trait;
import simbad.sonar.ping.Change;
import simbad.sonar.ping.PingLog;
import simbad.sonar.ping.SceneChange;
import simbad.sonar.ping.SensorChange;
import simbad.sonar.scene.SensingSetup;

/**
 * All that is to be known of an effect. Search, report, prediction, help and documentation read it
 * here.
 *
 * <p>Definitions are found with {@link java.util.ServiceLoader}: a class that implements this
 * interface, is public, has a public constructor without parameters and stands in {@code
 * META-INF/services/simbad.sonar.effect.Definition} of its jar takes part. Implementations have no
 * state, since one object serves several threads.
 */
public interface Definition {
  /** Returns the effect that it defines: one of the constants, or {@link Effect#named}. */
  Effect effect();

  /** Returns what happens, in one plain sentence without a full stop. */
  String happens();

  /** Returns the same in a few words, which stand behind the name in a verdict. */
  default String briefly() {
    return happens();
  }

  /** Returns what in the world it stands for: causes, commonest first. */
  String cause();

  /**
   * Returns the forms that it can take where echoes are decided by thresholds; none where the
   * set-up has no room for it.
   *
   * @param setup whose obstacles and sensor they are for
   * @param sensors labels of the transducers in the log
   */
  List<Form> forms(SensingSetup setup, List<String> sensors);

  /** Returns the same where echoes are decided by levels. */
  default List<Form> levelForms(SensingSetup setup, List<String> sensors) {
    return forms(setup, sensors);
  }

  /**
   * Returns values from which a fit starts: by default all combinations of the parameters' tries,
   * and what the arc says over which a lone obstacle was heard.
   *
   * @param form one of its forms
   * @param clues what the log shows that nothing explains yet
   * @return at least one set of values, each in its parameter's interval
   */
  default List<double[]> starts(Form form, Clues clues) {
    List<double[]> starts = new ArrayList<>(Tries.all(form));
    clues
        .heardArc()
        .flatMap(arc -> whereHeard(form, arc))
        .ifPresent(values -> starts.add(Tries.within(form, values)));
    return starts;
  }

  /**
   * Returns the values with which a lone obstacle would be heard over an arc of headings, or over
   * an arc of its width, from one place.
   *
   * @param form one of its forms
   * @param arc over which it was heard
   * @return one for each parameter, in its interval or not; empty for what has no say in it
   */
  default Optional<double[]> whereHeard(Form form, Clues.HeardArc arc) {
    return Optional.empty();
  }

  /**
   * Returns by which parameters, from which size on it matters in practice. By default the first
   * parameter of the first form shows it from its smallest try on.
   *
   * @param setup as the simulator believes it
   * @param log whose readings might show it
   * @return none where the set-up does not admit the effect
   */
  default List<Probe> probes(SensingSetup setup, PingLog log) {
    return Forms.of(this, setup, log.sensors()).stream().limit(1).map(Probe::ofTries).toList();
  }

  /** Returns what to do about it, in one sentence without a full stop. */
  String remedy(FittedValues values);

  /**
   * Returns the set-up as it should have been stated, so that the nominal model has in it what was
   * fitted. By default what changes obstacles or the sensor is put into the scene, and anything
   * else has no place there.
   *
   * @param stated the set-up as the simulator believes it
   * @param form of this effect
   * @param values that were fitted, in the units of files
   * @return empty where a scene has no field that says it
   */
  default Optional<SensingSetup> corrected(SensingSetup stated, Form form, double... values) {
    Change change = form.with(values);
    if (change instanceof SceneChange obstacles) {
      return Optional.of(stated.with(obstacles.apply(stated.scene())));
    }
    return change instanceof SensorChange sensor
        ? Optional.of(stated.with(sensor.apply(stated.sensor())))
        : Optional.empty();
  }

  /**
   * Returns the form of motion that is the same cause: what makes poses wrong that a robot has
   * reckoned from its wheels also makes it move otherwise than it was told. Both have the same
   * parameter, so that one value stands for both.
   *
   * @param form one of its forms
   * @return own name of the form of motion; empty where a tracker sees nothing of it
   */
  default Optional<String> seenInMotion(Form form) {
    return Optional.empty();
  }

  /** Returns what the search has to know of it. */
  default Set<Trait> traits() {
    return Set.of();
  }

  /**
   * Tells whether a log may show a form at all, by physics, symmetry or the way in which it was
   * taken. What it cannot show is not looked for.
   */
  default boolean canShow(Form form, LogDesign log) {
    return true;
  }

  /**
   * Returns the same form with the values that can be in a log as it was taken; by default all of
   * them.
   */
  default Form within(Form form, LogDesign log) {
    return form;
  }

  /**
   * Tells whether a log was taken in a way that invites the effect in one of its forms, so that it
   * is to be expected rather than rare.
   *
   * @param form one of its forms
   * @param log how it was taken
   * @param values of the form's parameters
   */
  default boolean isInvited(Form form, LogDesign log, double... values) {
    return false;
  }

  /**
   * Returns the effects that a log cannot tell from this one because of how it was taken, whatever
   * it reads: they are not looked for in it, and could be what is found.
   */
  default Set<Effect> twins(LogDesign log) {
    return Set.of();
  }

  /**
   * Tells whether sensors are built so: what is found then is no stand-in for something else that
   * the log cannot tell from it.
   *
   * @param form of this effect
   * @param values that were fitted, in the units of files
   */
  default boolean isByDesign(Form form, double... values) {
    return false;
  }

  /**
   * Tells whether a form is read where nothing that the simulator knows is heard, and only there.
   *
   * @param form its own name
   */
  default boolean isHeardInSilence(String form) {
    return false;
  }

  /**
   * Tells whether the readings that a form takes to itself depend on what stands in front of the
   * sensor. Those that do not may come at any place, and say so when they are compared with it.
   */
  default boolean isOfThePlace(String form) {
    return true;
  }

  /**
   * Tells whether values are no more than what differs from one day to the next though nothing was
   * changed. That belongs to the set-up.
   */
  default boolean isWithinDays(Form form, double... values) {
    return false;
  }
}
