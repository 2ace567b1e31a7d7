#include "model/ping.h"

#include "model/echo.h"
#include "model/now.h"
#include "protocol.h"

/* Well before the count of milliseconds wraps. */
#define LONG_AGO_FROM_MS 60000u

ping_t ping;
uint16_t ping_period_ms;
uint8_t ping_awaits_pulse;
uint8_t ping_stage;
uint8_t ping_line_high;

static struct {
    uint16_t due_ms;
    uint16_t fired_ms;
    uint16_t since_ms; /* from the last trigger to now */
    uint8_t running;
    uint8_t singles;
    uint8_t long_ago; /* the last trigger: longer than the count of milliseconds can tell */
} beat;

void ping_reset(void)
{
    ping_period_ms = PING_DEFAULT_PERIOD_MS;
    ping_awaits_pulse = 0;
    ping.sequence = 0;
    beat.fired_ms = now_ms;
    beat.long_ago = 1;
    ping_run();
}

void ping_run(void)
{
    beat.running = 1;
    beat.singles = 0;
    beat.due_ms = now_ms;
}

void ping_halt(void)
{
    beat.running = 0;
    beat.singles = 0;
}

void ping_single(void)
{
    beat.running = 0;
    if (beat.singles != 255u) {
        beat.singles++;
    }
}

void ping_restart_period(void)
{
    beat.due_ms = now_ms + ping_period_ms;
}

static uint8_t finish(uint8_t status) BYTE_IN_W
{
    ping_awaits_pulse = 0;
    ping.status = status;
    return PING_DONE;
}

static uint8_t stuck(uint8_t high) BYTE_IN_W
{
    ping.high = high;
    return finish(STATUS_STUCK);
}

static uint8_t await_pulse(void)
{
    if (ping_stage == CAPTURE_FALLEN) {
        return finish(echo_status());
    }
    if (beat.since_ms > PING_FALL_LIMIT_MS) {
        return stuck(1);
    }
    return ping_stage != CAPTURE_RISEN && beat.since_ms > PING_RISE_LIMIT_MS ? stuck(0) : PING_NOTHING;
}

/* The count of milliseconds wraps: what is less than half its range ahead is in the future. */
static uint8_t due_is_ahead(void)
{
    return (uint8_t)((uint16_t)(now_ms - beat.due_ms) >> 8) & 0x80u;
}

/* Tells whether a ping is due, and if so, when the next one is. */
static uint8_t take_due(void)
{
    if (beat.singles) {
        beat.singles--;
        return 1;
    }
    if (!beat.running || due_is_ahead()) {
        return 0;
    }
    beat.due_ms += ping_period_ms;
    if (!due_is_ahead()) {
        /* So late that the beat is lost: a new one begins. */
        ping_restart_period();
    }
    return 1;
}

static uint8_t fire(void)
{
    ping.sequence++;
    ping.since_ms = beat.long_ago ? PING_LONG_AGO_MS : beat.since_ms;
    beat.fired_ms = now_ms;
    beat.long_ago = 0;
    if (ping_line_high) {
        /* A pulse could not be told from what is there already. */
        return stuck(1);
    }
    ping_awaits_pulse = 1;
    return PING_FIRE;
}

uint8_t ping_step(void)
{
    beat.since_ms = now_ms - beat.fired_ms;
    if (ping_awaits_pulse) {
        return await_pulse();
    }
    if (beat.since_ms >= LONG_AGO_FROM_MS) {
        beat.long_ago = 1;
    }
    return take_due() ? fire() : PING_NOTHING;
}
