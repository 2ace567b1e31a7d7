/* The program: pings, answers commands, says what it measured. */
#ifndef APP_RANGER_H
#define APP_RANGER_H

/* Sets everything up. */
void ranger_open(void);

/* One turn of the loop; never waits. */
void ranger_step(void);

#endif
