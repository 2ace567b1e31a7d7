package simbad.blindworld.generate;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import simbad.blindworld.motion.MotionForecast;
import simbad.blindworld.motion.MotionWorld;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Track;
import simbad.blindworld.motion.Windows;
import simbad.blindworld.motionchange.MotionEffect;
import simbad.blindworld.motionchange.MotionVocabulary;

/**
 * A case of motion as it was drawn and driven.
 *
 * @param assignment what was asked
 * @param drive which kind of drive it is
 * @param setup words for what is there before the change
 * @param robot what the simulator believes
 * @param effects what is at work
 * @param log the log of the case
 * @param reference another one without the effects, where there is one
 * @param sealed another drive of the same robot
 * @param oracle the world's own forecast of the sealed windows
 * @param figures how large things are
 * @param called by which sets of names each effect may be called, and by which it nearly may
 */
record MotionCase(
    Plan.Assignment assignment,
    String drive,
    String setup,
    Robot robot,
    List<MotionEffect> effects,
    Log log,
    Optional<Log> reference,
    Log sealed,
    MotionForecast oracle,
    Figures figures,
    List<Called> called) {

  /** What was told, and what was seen. */
  record Log(Outing outing, Track track) {}

  /**
   * Sets of names for an effect.
   *
   * @param accept those that physics allows
   * @param also those that come near and are not right
   */
  record Called(List<Set<String>> accept, List<Set<String>> also) {}

  /**
   * Figures of the truth.
   *
   * @param nominal losses of the nominal forecast on the sealed windows, by horizon and component
   * @param unchanged the gap without the effects, in units of the nominal one
   * @param oracleGap the gap of the world's own forecast, in units of the nominal one
   * @param z by how many standard errors the effect that shows least shows
   * @param sizes of each effect, 1 for a practical one
   * @param draws how many draws it took
   */
  record Figures(
      List<Double> nominal,
      double unchanged,
      double oracleGap,
      double z,
      List<Double> sizes,
      int draws) {}

  Map<String, String> openFiles() {
    Map<String, String> files = new LinkedHashMap<>();
    files.put("robot.json", MotionFiles.robot(robot));
    files.put("commands.csv", MotionFiles.commands(robot, log.outing));
    files.put("track.csv", MotionFiles.track(log.outing, log.track));
    reference.ifPresent(
        other -> {
          files.put("reference-commands.csv", MotionFiles.commands(robot, other.outing));
          files.put("reference-track.csv", MotionFiles.track(other.outing, other.track));
        });
    return files;
  }

  Map<String, String> sealedFiles() {
    Map<String, String> files = new LinkedHashMap<>();
    files.put("sealed-commands.csv", MotionFiles.commands(robot, sealed.outing));
    files.put("sealed-track.csv", MotionFiles.track(sealed.outing, sealed.track));
    files.put("oracle.csv", oracle.csv(Windows.of(sealed.outing)));
    return files;
  }

  /** The sealed drive as dead reckoning has it: what is to be forecast cannot be looked at. */
  Map<String, String> rowFiles() {
    Track reckoned =
        MotionWorld.nominal(robot.withTracker(Robot.Scatter.NONE)).drive(sealed.outing, 0);
    Map<String, String> files = new LinkedHashMap<>();
    files.put("robot.json", MotionFiles.robot(robot));
    files.put("commands.csv", MotionFiles.commands(robot, sealed.outing));
    files.put("track.csv", MotionFiles.track(sealed.outing, reckoned));
    return files;
  }

  /** What is sealed, less the hashes of the files beside it. */
  Map<String, Object> truth() {
    Map<String, Object> named = new LinkedHashMap<>();
    effects.forEach(effect -> named.put(effect.name(), effect.parameters()));
    List<String> outside =
        named.keySet().stream().filter(n -> !MotionVocabulary.contains(n)).toList();
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("case", assignment.id());
    json.put("worlds", "motion");
    json.put("kind", assignment.kind().name().toLowerCase(Locale.ROOT));
    json.put("effects", named);
    json.put("outside_vocabulary", outside);
    json.put("public", named.keySet().stream().filter(MotionVocabulary::contains).toList());
    json.put("unknown", outside);
    Set<Set<String>> accept = together(Called::accept);
    json.put("accept", lists(accept));
    Set<Set<String>> also = together(c -> joined(c.accept(), c.also()));
    also.removeAll(accept);
    json.put("also", lists(also));
    json.put("drive", drive);
    json.put("setup", setup);
    json.put("reference", reference.isPresent());
    json.put("seconds", log.outing.durationS());
    json.put("windows", Windows.of(sealed.outing).size());
    json.put("draws", figures.draws);
    json.put("sizes", figures.sizes);
    json.put("z", figures.z);
    json.put("sealed_nominal", figures.nominal);
    json.put("sealed_gap_nominal", 1);
    json.put("sealed_gap_unchanged", figures.unchanged);
    json.put("sealed_gap_oracle", figures.oracleGap);
    return json;
  }

  private static List<Set<String>> joined(List<Set<String>> one, List<Set<String>> other) {
    List<Set<String>> all = new ArrayList<>(one);
    all.addAll(other);
    return all;
  }

  /** The sets that a truth has of one effect. */
  private interface Sets {
    List<Set<String>> of(Called called);
  }

  /** One name or set of names for each effect, in every way of choosing. */
  private Set<Set<String>> together(Sets sets) {
    Set<Set<String>> all = new LinkedHashSet<>();
    all.add(Set.of());
    for (Called one : called) {
      Set<Set<String>> longer = new LinkedHashSet<>();
      for (Set<String> begun : all) {
        for (Set<String> names : sets.of(one)) {
          Set<String> both = new TreeSet<>(begun);
          both.addAll(names);
          longer.add(both);
        }
      }
      all = longer;
    }
    return all;
  }

  private static List<Object> lists(Set<Set<String>> sets) {
    List<Object> lists = new ArrayList<>();
    sets.forEach(set -> lists.add(set.stream().sorted().toList()));
    return lists;
  }
}
