package simbad.cli;

import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;
import simbad.demo.Demo;
import simbad.experiments.demo.ObstacleDemo;
import simbad.experiments.run.RobotKind;
import simbad.sonar.format.DataFormatException;

/** The robot of a demo. */
final class DemoRobot {
  @Option(
      names = "--robot",
      paramLabel = "ROBOT",
      description =
          "Let the robot of an obstacle's demo move as a real one: diagnosed:DIR (what simbad "
              + "diagnose made of a motion folder), or a robot.json. It is given the time that "
              + "it needs for each step.")
  private @Nullable String robot;

  boolean isNamed() {
    return robot != null;
  }

  /** Returns the demo with the robot, if there is one. */
  Demo in(Demo demo, Subcommand command) throws DataFormatException {
    if (robot == null) {
      return demo;
    }
    return ObstacleDemo.on(demo, RobotKind.read(robot))
        .orElseThrow(
            () -> command.wrongUsage("--robot needs the demo of an obstacle, such as AngleDemo"));
  }
}
