/*
 * A stand-in of our own for tests: a world that moves its robot as standard input says. The first
 * line is the obstacle, each further one the robot at a step: x, y, cosine and sine of the yaw.
 * What the emitter gets goes to the error stream.
 */
#include <stdio.h>
#include <string.h>

#include "emitter.h"
#include "robot.h"
#include "supervisor.h"

struct WbNodeStructPrivate {
  double position[3];
  double orientation[9];
};

static struct WbNodeStructPrivate robot;
static struct WbNodeStructPrivate obstacle;

static int place(WbNodeRef node) {
  double x, y, c, s;
  if (scanf("%lf %lf %lf %lf", &x, &y, &c, &s) != 4) {
    return -1;
  }
  node->position[0] = x;
  node->position[1] = y;
  node->orientation[0] = node->orientation[4] = c;
  node->orientation[1] = -s;
  node->orientation[3] = s;
  node->orientation[8] = 1;
  return 0;
}

int wb_robot_init(void) { return place(&obstacle); }

double wb_robot_get_basic_time_step(void) { return 32; }

WbDeviceTag wb_robot_get_device(const char *name) { return strcmp(name, "sonar") == 0 ? 7 : 0; }

int wb_robot_step(int duration_ms) { return duration_ms == 32 ? place(&robot) : -1; }

void wb_robot_cleanup(void) {}

WbNodeRef wb_supervisor_node_get_self(void) { return &robot; }

WbNodeRef wb_supervisor_node_get_from_def(const char *def) {
  return strcmp(def, "OBSTACLE") == 0 ? &obstacle : NULL;
}

const double *wb_supervisor_node_get_position(WbNodeRef node) { return node->position; }

const double *wb_supervisor_node_get_orientation(WbNodeRef node) { return node->orientation; }

int wb_emitter_send(WbDeviceTag tag, const void *data, int size) {
  float sent;
  if (tag != 7 || size != (int)sizeof sent) {
    return 0;
  }
  memcpy(&sent, data, sizeof sent);
  /* Both streams may be one file: whole lines only. */
  fflush(stdout);
  fprintf(stderr, "sent %.4f\n", (double)sent);
  return 1;
}
