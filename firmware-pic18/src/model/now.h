/*
 * The time of this turn of the loop, for all of the model. A module variable, as most that the functions here work on:
 * the compiler passes an argument through a stack in software, some ten bytes of program for each that is passed.
 */
#ifndef MODEL_NOW_H
#define MODEL_NOW_H

#include <stdint.h>

/* Milliseconds, wrapping at 65536; set by the application, or by a test. */
extern uint16_t now_ms;

#endif
