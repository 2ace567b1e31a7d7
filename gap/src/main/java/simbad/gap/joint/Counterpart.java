package simbad.gap.joint;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import simbad.gap.diagnosis.DataSet;
import simbad.motion.Robot;
import simbad.motion.effect.MotionForm;
import simbad.motion.effect.MotionForms;
import simbad.sonar.effect.Definition;
import simbad.sonar.effect.Definitions;
import simbad.sonar.effect.Form;
import simbad.sonar.effect.Forms;
import simbad.sonar.ping.PingLog;

/**
 * One cause in both halves of a joint log: what a tracker sees of it, and what a sonar hears of it
 * at the poses that the robot reckoned.
 *
 * @param moves its form of motion
 * @param hears its form of a sensor's effect, with the same parameter
 */
record Counterpart(MotionForm moves, Form hears) {

  /** Returns all that there are for a log, as the definitions say. */
  static List<Counterpart> all(DataSet data, Robot robot) {
    List<String> sensors = new PingLog(data.readings()).sensors();
    List<Counterpart> all = new ArrayList<>();
    for (Definition definition : Definitions.all()) {
      for (Form form : Forms.of(definition, data.setup(), sensors)) {
        Optional<MotionForm> moves =
            definition.seenInMotion(form).flatMap(name -> MotionForms.find(name, robot));
        moves.ifPresent(motion -> all.add(new Counterpart(motion, form)));
      }
    }
    return all;
  }

  /** Returns a difference of its value that would matter to nobody. */
  double immaterial() {
    return moves.parameters().get(0).practical() / 2;
  }
}
