/* Milliseconds since the start, by timer 2. */
#ifndef HAL_CLOCK_H
#define HAL_CLOCK_H

#include <stdint.h>

void clock_open(void);

/* Wraps at 65536. */
uint16_t clock_ms(void);

/* The interrupt's part: counts a millisecond when one has passed. */
void clock_interrupt(void);

#endif
