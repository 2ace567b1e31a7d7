/*
 * A Webots controller that says what a sonar at the robot's centre would hear of one obstacle.
 *
 * Not tried in Webots: compiled and run only against small stand-ins for its headers.
 *
 * It needs sonar.h beside it, a header that Simbad Sonar exported under the name "sonar".
 *
 * The robot's field "supervisor" must be TRUE, and the obstacle must be a node DEF OBSTACLE. The
 * world's frame is ENU, as Webots has it since R2022a: x east, y north, z up; the robot looks along
 * its x, and the sensor with it. Each step a line with the reading in metres, or "none", is
 * printed. If the robot has an emitter named "sonar", the reading goes there too as one float,
 * below 0 for no echo.
 */
#include <math.h>
#include <stdio.h>
#include <webots/emitter.h>
#include <webots/robot.h>
#include <webots/supervisor.h>

#include "sonar.h"

/* x and y in metres, yaw in radians counter-clockwise as seen from above. */
typedef struct {
  double x;
  double y;
  double yaw;
} pose;

static pose pose_of(WbNodeRef node) {
  const double *position = wb_supervisor_node_get_position(node);
  const double *turn = wb_supervisor_node_get_orientation(node);
  pose found;
  found.x = position[0];
  found.y = position[1];
  /* Row by row: the first column is where the node's x points. */
  found.yaw = atan2(turn[3], turn[0]);
  return found;
}

/* Metres, below 0 for no echo. The header's z points the other way than y. */
static float read_m(pose sensor, pose obstacle) {
  const double x = sensor.x - obstacle.x;
  const double y = sensor.y - obstacle.y;
  const double c = cos(obstacle.yaw);
  const double s = sin(obstacle.yaw);
  return sonar_read_m((float)(c * x + s * y), (float)(s * x - c * y),
                      (float)(sensor.yaw - obstacle.yaw));
}

static void say(WbDeviceTag emitter, float range_m) {
  if (range_m < 0) {
    printf("none\n");
  } else {
    printf("%.4f\n", (double)range_m);
  }
  if (emitter != 0) {
    wb_emitter_send(emitter, &range_m, (int)sizeof range_m);
  }
}

int main(void) {
  WbNodeRef obstacle;
  WbNodeRef robot;
  WbDeviceTag emitter;
  int step_ms;
  wb_robot_init();
  step_ms = (int)wb_robot_get_basic_time_step();
  robot = wb_supervisor_node_get_self();
  obstacle = wb_supervisor_node_get_from_def("OBSTACLE");
  if (robot == NULL || obstacle == NULL) {
    fprintf(stderr, "sonar_controller: no node DEF OBSTACLE, or the robot is no supervisor\n");
    wb_robot_cleanup();
    return 1;
  }
  emitter = wb_robot_get_device("sonar");
  while (wb_robot_step(step_ms) != -1) {
    say(emitter, read_m(pose_of(robot), pose_of(obstacle)));
  }
  wb_robot_cleanup();
  return 0;
}
