/* A stand-in of our own for tests: only what sonar_controller.c uses. */
#ifndef WB_SUPERVISOR_H
#define WB_SUPERVISOR_H

typedef struct WbNodeStructPrivate *WbNodeRef;

WbNodeRef wb_supervisor_node_get_self(void);
WbNodeRef wb_supervisor_node_get_from_def(const char *def);
const double *wb_supervisor_node_get_position(WbNodeRef node);
const double *wb_supervisor_node_get_orientation(WbNodeRef node);

#endif
