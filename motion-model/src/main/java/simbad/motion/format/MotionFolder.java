package simbad.motion.format;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import simbad.motion.Command;
import simbad.motion.MotionRun;
import simbad.motion.Robot;
import simbad.motion.TrackPose;
import simbad.sonar.format.CsvCell;
import simbad.sonar.format.DataFormatException;
import simbad.sonar.format.TextFile;

/** A folder with robot.json, commands.csv and track.csv, and perhaps a reference of both. */
public final class MotionFolder {
  /** What the simulator believes. */
  public static final String ROBOT = "robot.json";

  /** What was commanded. */
  public static final String COMMANDS = "commands.csv";

  /** Where the robot was. */
  public static final String TRACK = "track.csv";

  private static final String REFERENCE = "reference-";

  private final Path folder;

  /** Names a folder that need not exist. */
  public MotionFolder(Path folder) {
    this.folder = folder;
  }

  /** Tells whether a folder says that it is one of motion. */
  public static boolean isOne(Path folder) {
    return Files.exists(folder.resolve(ROBOT));
  }

  /** Returns the names of the files that are there, in a fixed order. */
  public List<String> files() {
    return List.of(ROBOT, COMMANDS, TRACK, REFERENCE + COMMANDS, REFERENCE + TRACK).stream()
        .filter(name -> Files.exists(folder.resolve(name)))
        .toList();
  }

  /**
   * Reads what the simulator believes of the robot.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public Robot robot() throws DataFormatException {
    return RobotFile.read(folder.resolve(ROBOT));
  }

  /**
   * Reads the folder.
   *
   * @param name by which the data set goes
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public MotionData read(String name) throws DataFormatException {
    Robot robot = robot();
    List<MotionRun> reference =
        Files.exists(folder.resolve(REFERENCE + COMMANDS)) ? runs(robot, REFERENCE) : List.of();
    return new MotionData(name, robot, runs(robot, ""), reference);
  }

  private List<MotionRun> runs(Robot robot, String prefix) throws DataFormatException {
    Path commandsFile = folder.resolve(prefix + COMMANDS);
    Path trackFile = folder.resolve(prefix + TRACK);
    Map<String, List<MotionRow<Command>>> commands = MotionCsv.commands(commandsFile, robot);
    Map<String, List<MotionRow<TrackPose>>> track = MotionCsv.track(trackFile);
    List<MotionRun> runs = new ArrayList<>();
    for (Map.Entry<String, List<MotionRow<TrackPose>>> run : track.entrySet()) {
      if (!commands.containsKey(run.getKey())) {
        throw DataFormatException.inFile(
            trackFile, "run '" + run.getKey() + "' has no commands in " + commandsFile);
      }
      runs.add(
          new MotionRun(
              run.getKey(),
              MotionRow.values(commands.get(run.getKey())),
              MotionRow.values(run.getValue())));
    }
    return runs;
  }

  /**
   * Reads the commands as they stand in the file, by run.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public Map<String, List<MotionRow<Command>>> commandRows() throws DataFormatException {
    return MotionCsv.commands(folder.resolve(COMMANDS), RobotFile.read(folder.resolve(ROBOT)));
  }

  /**
   * Reads the track as it stands in the file, by run.
   *
   * @throws DataFormatException naming file, line and field of the first fault
   */
  public Map<String, List<MotionRow<TrackPose>>> trackRows() throws DataFormatException {
    return MotionCsv.track(folder.resolve(TRACK));
  }

  /**
   * Writes a folder of a body that goes and turns.
   *
   * @param data with a robot that does exactly what it is told, not differential
   * @throws IOException if a file cannot be written
   */
  public void write(MotionData data) throws IOException {
    Files.createDirectories(folder);
    TextFile.write(folder.resolve(ROBOT), RobotFile.unicycle(data.robot()));
    StringBuilder commands = new StringBuilder("run,t_s,v_m_s,w_rad_s\n");
    StringBuilder track = new StringBuilder("run,t_s,x_m,z_m,heading_deg\n");
    for (MotionRun run : data.runs()) {
      for (Command c : run.commands()) {
        line(commands, run.name(), c.timeS(), c.speedMPerS(), c.turnRadPerS());
      }
      for (TrackPose p : run.track()) {
        line(track, run.name(), p.timeS(), p.xM(), -p.yM(), Math.toDegrees(p.headingRad()));
      }
    }
    TextFile.write(folder.resolve(COMMANDS), commands.toString());
    TextFile.write(folder.resolve(TRACK), track.toString());
  }

  private static void line(StringBuilder text, String run, double timeS, double... values) {
    text.append(CsvCell.of(run)).append(',').append(String.format(Locale.ROOT, "%.4f", timeS));
    for (double value : values) {
      text.append(',').append(String.format(Locale.ROOT, "%.5f", value + 0.0));
    }
    text.append('\n');
  }
}
