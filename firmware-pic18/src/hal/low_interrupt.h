/* The interrupt of low priority: the clock and the serial port share it. */
#ifndef HAL_LOW_INTERRUPT_H
#define HAL_LOW_INTERRUPT_H

#include "compiler.h"

void low_interrupt(void) INTERRUPT_LOW;

#endif
