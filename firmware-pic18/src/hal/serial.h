/* The serial port, 19200 8N1, by interrupts of low priority: nothing here waits. */
#ifndef HAL_SERIAL_H
#define HAL_SERIAL_H

#include <stdint.h>

#include "compiler.h"

void serial_open(void);

/* 1 when the text before has been sent and its place may be written again. */
uint8_t serial_idle(void);

/* Sends a text that stays where it is until the port is idle again; only when it is idle. */
void serial_send(IN_RAM const char *text, uint8_t length);

/* 1 when a byte has come. */
uint8_t serial_has_byte(void);

/* The first byte that came; only when there is one. */
uint8_t serial_take(void);

/* 1 when bytes came garbled or were lost since it was last asked. */
uint8_t serial_lost(void);

/* The interrupt's part. */
void serial_interrupt(void);

#endif
