/* A stand-in of our own for tests: only what sonar_controller.c uses. */
#ifndef WB_ROBOT_H
#define WB_ROBOT_H

typedef unsigned short WbDeviceTag;

int wb_robot_init(void);
double wb_robot_get_basic_time_step(void);
WbDeviceTag wb_robot_get_device(const char *name);
int wb_robot_step(int duration_ms);
void wb_robot_cleanup(void);

#endif
