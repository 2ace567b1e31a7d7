/*
 * When to ping and what became of it. Pure: the time is now_ms, the echo line what has been captured of it. Steps
 * must come at least once a second.
 */
#ifndef MODEL_PING_H
#define MODEL_PING_H

#include <stdint.h>

#include "compiler.h"

#define PING_LEAST_PERIOD_MS 20u
#define PING_MOST_PERIOD_MS 1000u
#define PING_DEFAULT_PERIOD_MS 250u

/* Echoes of a ping can be heard for about 60 ms in a room: Devantech asks for 65 ms between pings. */
#define PING_QUIET_PERIOD_MS 65u

/* The sensors of this family raise the line within half a millisecond of the trigger. */
#define PING_RISE_LIMIT_MS 5u

/* Longer than the longest time-out pulse (38 ms), shorter than the 65.5 ms that the 16-bit timer can tell apart. */
#define PING_FALL_LIMIT_MS 60u

/* In place of the time since the ping before: that long or longer, or there was none. */
#define PING_LONG_AGO_MS 65535u

/* What has been captured of the echo line since it was armed. */
enum capture_stage { CAPTURE_OFF, CAPTURE_ARMED, CAPTURE_RISEN, CAPTURE_FALLEN };

/* What the caller shall do after a step. */
enum ping_action {
    PING_NOTHING,
    PING_FIRE, /* arm the capture and trigger the sensor */
    PING_DONE  /* a new ping is complete: ping, and echo_us when it is not stuck */
};

typedef struct {
    uint16_t sequence; /* counts pings, from 1 after a reset; wraps */
    uint16_t since_ms; /* from the trigger of the ping before to this one's */
    uint8_t status;    /* STATUS_... of protocol.h */
    uint8_t high;      /* when stuck: 1 when the line stayed high */
} ping_t;

/* The latest ping. */
extern ping_t ping;

extern uint16_t ping_period_ms;

/* 1 from a trigger to the end of its pulse. */
extern uint8_t ping_awaits_pulse;

/* Set before a step where a pulse is awaited: an enum capture_stage; when it has fallen, echo_us as well. */
extern uint8_t ping_stage;

/* Set before a step where none is awaited: 1 when the echo line is high. */
extern uint8_t ping_line_high;

/* Everything as after a reset: pinging with the default period, the first ping due now. */
void ping_reset(void);

/* Pings again and again; the first is due now. */
void ping_run(void);

/* Stops pinging; a ping under way is finished. */
void ping_halt(void);

/* Stops pinging by itself and pings once; called n times, n times (up to 255 are remembered). */
void ping_single(void);

/* After a change of the period: the next ping of a run is due one period from now. */
void ping_restart_period(void);

/* One step; returns an enum ping_action. */
uint8_t ping_step(void);

#endif
