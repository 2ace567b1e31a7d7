package simbad.motion;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * One continuous recording.
 *
 * @param name of the run
 * @param commands in order of time; not empty
 * @param track in order of time, with holes where the robot was not seen
 */
public record MotionRun(String name, List<Command> commands, List<TrackPose> track) {
  /** Sorts both by time; of equal times the later one of the list acts. */
  public MotionRun {
    if (commands.isEmpty()) {
      throw new IllegalArgumentException("run " + name + " has no commands");
    }
    commands = commands.stream().sorted(Comparator.comparingDouble(Command::timeS)).toList();
    track = track.stream().sorted(Comparator.comparingDouble(TrackPose::timeS)).toList();
  }

  /** Returns the same run without commands that repeat the one before: it is held anyway. */
  public MotionRun withoutRepeats() {
    List<Command> changes = new ArrayList<>();
    for (Command command : commands) {
      if (changes.isEmpty() || !command.asksTheSameAs(changes.get(changes.size() - 1))) {
        changes.add(command);
      }
    }
    return new MotionRun(name, changes, track);
  }
}
