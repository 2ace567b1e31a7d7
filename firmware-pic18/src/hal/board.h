/* The processor and its pins: oscillator, directions, LEDs, watchdog, cause of the reset. */
#ifndef HAL_BOARD_H
#define HAL_BOARD_H

#include <stdint.h>

#include "compiler.h"

/* Sets up oscillator and pins, and notes and rearms the flags that tell the cause of a reset. First of all. */
void board_open(void);

/* Lets the interrupts come. Last of all that is set up. */
void board_enable_interrupts(void);

/* RCON and STKPTR as they were when the program started. */
uint8_t board_rcon(void);
uint8_t board_stkptr(void);

/* Shows a number on the eight LEDs. */
void board_show(uint8_t leds) BYTE_IN_W;

/* Tells the watchdog that the program goes on. */
void board_alive(void);

#endif
