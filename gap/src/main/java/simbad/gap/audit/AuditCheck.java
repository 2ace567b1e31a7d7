package simbad.gap.audit;

import java.util.EnumSet;

/** The checks of the audit, by the word that stands in files. */
public enum AuditCheck {
  /** A figure of the scene that no sonar in air has. */
  CONSTANT("constant", "sensor"),
  /** Ranges beyond what the sensor measures. */
  RANGE_LIMIT("range-limit", "range_m"),
  /** Ranges that are a multiple of what the scene says. */
  UNIT("unit", "range_m"),
  /** A number that stands for no echo. */
  NO_ECHO_CODE("no-echo-code", "range_m"),
  /** One value much more often than its neighbours, where the scene expects others. */
  PILE("pile", "range_m"),
  /** Ranges that start again from 0. */
  WRAP("wrap", "range_m"),
  /** One value that stays, whatever the sensor looks at. */
  STUCK("stuck", "range_m"),
  /** The last value again and again. */
  HELD("held", "range_m"),
  /** Single readings that are off by one and the same amount. */
  JUMP("jump", "range_m"),
  /** Poses at which nobody can say what is in the cone. */
  EDGE("edge", "x_m, z_m, heading_deg"),
  /** A placement that is off the line of all others. */
  MISPLACED("misplaced", "range_m"),
  /** Times that go back or stand twice. */
  CLOCK("clock", "t_s"),
  /** Times between pings that are not the sensor's. */
  PERIOD("period", "t_s"),
  /** Sensors inside obstacles. */
  INSIDE("inside", "x_m, z_m"),
  /** Poses that never change though readings do. */
  STILL("still", "x_m, z_m, heading_deg"),
  /** Poses in another frame or unit than the scene. */
  AXES("axes", "x_m, z_m, heading_deg"),
  /** Times of commands and track that do not belong together. */
  TRACK_CLOCK("track-clock", "t_s"),
  /** Commands that no robot can do. */
  COMMAND_UNIT("command-unit", "speed, turn"),
  /** Positions that are a multiple of what was commanded. */
  TRACK_UNIT("track-unit", "x_m, z_m"),
  /** A track in another frame, or a mirrored one. */
  TRACK_FRAME("track-frame", "x_m, z_m, heading_deg"),
  /** Headings in another unit. */
  TRACK_HEADING("track-heading", "heading_deg"),
  /** Where the robot was not seen. */
  TRACK_HOLES("track-holes", "t_s"),
  /** Poses that no robot gets to between two rows. */
  TRACK_JUMP("track-jump", "x_m, z_m, heading_deg"),
  /** A track that stands while the robot is told to go. */
  TRACK_STILL("track-still", "x_m, z_m, heading_deg"),
  /** A track that does not go with its commands at all. */
  TRACK_FOREIGN("track-foreign", "x_m, z_m, heading_deg");

  private final String word;
  private final String field;

  AuditCheck(String word, String field) {
    this.word = word;
    this.field = field;
  }

  /** Returns how many checks there are of one data set of readings; those of tracks stand apart. */
  static int ofReadings() {
    return EnumSet.range(CONSTANT, AXES).size();
  }

  /** Returns the word as it stands in files. */
  public String word() {
    return word;
  }

  /** Returns the columns, or the part of the scene, that it looks at. */
  public String field() {
    return field;
  }
}
