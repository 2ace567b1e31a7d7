/* The SRF04's two lines: triggers it on RB3, times its pulse on RB4 by interrupt on change and timer 0 (1 MHz). */
#ifndef HAL_CAPTURE_H
#define HAL_CAPTURE_H

#include <stdint.h>

#include "compiler.h"

void capture_open(void);

/* Waits for the next pulse and triggers the sensor: its line is high for at least 10 us. */
void capture_fire(void);

/* How far it has come: an enum capture_stage of model/ping.h. */
uint8_t capture_stage(void);

/* The length of the pulse in microseconds; only when the stage is CAPTURE_FALLEN. */
uint16_t capture_echo_us(void);

/* 1 when the echo line is high now. Not while a pulse is awaited: a read can hide an edge that comes with it. */
uint8_t capture_line_high(void);

/* The interrupt of high priority. */
void capture_interrupt(void) INTERRUPT_HIGH;

#endif
