package simbad.blindworld.generate;

import java.util.LinkedHashMap;
import java.util.Map;
import simbad.blindworld.file.Decimals;
import simbad.blindworld.file.Json;
import simbad.blindworld.motion.Commands;
import simbad.blindworld.motion.Outing;
import simbad.blindworld.motion.Robot;
import simbad.blindworld.motion.Track;

/** Robots, commands and tracks in the format motion-gap/1. */
final class MotionFiles {

  private MotionFiles() {}

  static String robot(Robot robot) {
    Map<String, Object> json = new LinkedHashMap<>();
    json.put("format", "motion-gap/1");
    json.put("kinematics", robot.differential() ? "differential" : "unicycle");
    if (robot.differential()) {
      json.put("wheel_radius_m", robot.wheelRadiusM());
      json.put("wheel_base_m", robot.wheelBaseM());
    }
    Robot.Beliefs beliefs = robot.beliefs();
    if (beliefs.latencyS() > 0) {
      json.put("latency_s", beliefs.latencyS());
    }
    if (beliefs.timeConstantS() > 0) {
      json.put("speed_time_constant_s", beliefs.timeConstantS());
      json.put("turn_time_constant_s", beliefs.timeConstantS());
    }
    if (beliefs.maxSpeedMPerS() < Double.POSITIVE_INFINITY) {
      json.put("max_speed_m_s", beliefs.maxSpeedMPerS());
      json.put("max_turn_rad_s", beliefs.maxTurnRadPerS());
    }
    if (robot.tracker().positionM() > 0) {
      json.put("track_sigma_m", robot.tracker().positionM());
      json.put("track_sigma_deg", Math.toDegrees(robot.tracker().headingRad()));
    }
    if (robot.separateClocks()) {
      json.put("clocks", "separate");
    }
    return Json.write(json);
  }

  static String commands(Robot robot, Outing outing) {
    boolean rims = robot.differential();
    StringBuilder text =
        new StringBuilder(rims ? "run,t_s,left_m_s,right_m_s\n" : "run,t_s,v_m_s,w_rad_s\n");
    for (Outing.Run run : outing.runs()) {
      for (int i = 0; i < run.commands().size(); i++) {
        Commands.Speeds told = run.commands().at(i);
        text.append(run.name()).append(',');
        Decimals.append(text, run.commands().timeS(i), 3).append(',');
        double base = robot.wheelBaseM();
        Decimals.append(text, rims ? told.left(base) : told.vMPerS(), 5).append(',');
        Decimals.append(text, rims ? told.right(base) : told.wRadPerS(), 5).append('\n');
      }
    }
    return text.toString();
  }

  static String track(Outing outing, Track track) {
    StringBuilder text = new StringBuilder("run,t_s,x_m,z_m,heading_deg\n");
    for (int r = 0; r < track.size(); r++) {
      Outing.Run run = outing.runs().get(r);
      for (int i = 0; i < run.frames(); i++) {
        text.append(run.name()).append(',');
        Decimals.append(text, run.frameS(i), 4).append(',');
        Decimals.append(text, track.xM(r, i), 5).append(',');
        Decimals.append(text, track.zM(r, i), 5).append(',');
        double heading = Math.IEEEremainder(track.headingRad(r, i), 2 * Math.PI);
        Decimals.append(text, Math.toDegrees(heading), 3).append('\n');
      }
    }
    return text.toString();
  }
}
