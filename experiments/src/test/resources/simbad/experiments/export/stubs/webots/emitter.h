/* A stand-in of our own for tests: only what sonar_controller.c uses. */
#ifndef WB_EMITTER_H
#define WB_EMITTER_H
#include "robot.h"

int wb_emitter_send(WbDeviceTag tag, const void *data, int size);

#endif
