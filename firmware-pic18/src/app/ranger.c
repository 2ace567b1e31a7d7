#include "app/ranger.h"

#include <stdint.h>

#include "hal/board.h"
#include "hal/capture.h"
#include "hal/clock.h"
#include "hal/serial.h"
#include "model/command.h"
#include "model/echo.h"
#include "model/line.h"
#include "model/now.h"
#include "model/ping.h"
#include "model/report.h"
#include "model/reset_cause.h"
#include "protocol.h"

static struct {
    uint8_t thesis_mode;
    /* What waits to be said; a line end first, because the reset may have come in the middle of a line. */
    uint8_t line_end;
    uint8_t result;
    uint8_t answer;
    uint8_t identity;
} state;

void ranger_open(void)
{
    board_open();
    clock_open();
    capture_open();
    serial_open();
    now_ms = clock_ms();
    command_reset();
    ping_reset();
    board_show(0);
    state.thesis_mode = 0;
    state.line_end = 1;
    state.result = 0;
    state.answer = 0;
    state.identity = 1;
    board_enable_interrupts();
}

static void carry_out(void)
{
    switch (command.byte) {
    case COMMAND_FRAME:
        state.thesis_mode = 0;
        break;
    case COMMAND_THESIS:
        state.thesis_mode = 1;
        ping_period_ms = PING_DEFAULT_PERIOD_MS;
        ping_restart_period();
        break;
    case COMMAND_RUN:
        ping_run();
        break;
    case COMMAND_HALT:
        ping_halt();
        break;
    case COMMAND_SINGLE:
        ping_single();
        break;
    case COMMAND_PERIOD:
        ping_period_ms = command.period_ms;
        ping_restart_period();
        break;
    default:
        state.identity = 1;
        break;
    }
}

/* Takes what has come; returns 1 when there is a command to answer. */
static uint8_t listen(void)
{
    if (serial_lost()) {
        command_reset();
        command.byte = 0;
        command.answer = ANSWER_BYTES_LOST;
        return 1;
    }
    return serial_has_byte() ? command_take(serial_take()) : command_overdue();
}

/* One answer at a time: what comes meanwhile waits in the port, or is said to be lost. */
static void obey(void)
{
    if (state.answer || !listen()) {
        return;
    }
    state.answer = 1;
    if (command.answer == ANSWER_DONE || command.answer == ANSWER_PERIOD_SHORT) {
        carry_out();
    }
}

/* No ping begins before the one before has been taken to be said: none is ever lost. */
static void measure(void)
{
    if (state.result) {
        return;
    }
    if (ping_awaits_pulse) {
        ping_stage = capture_stage();
        echo_us = capture_echo_us();
    } else {
        ping_line_high = capture_line_high();
    }
    switch (ping_step()) {
    case PING_FIRE:
        capture_fire();
        break;
    case PING_DONE:
        board_show(ping.status == STATUS_STUCK ? 0 : echo_leds());
        state.result = 1;
        break;
    default:
        break;
    }
}

/* What is to be said next, pings first; returns 0 when there is nothing. */
static uint8_t compose(void)
{
    if (state.line_end) {
        state.line_end = 0;
        report_line_end();
    } else if (state.result) {
        state.result = 0;
        if (state.thesis_mode) {
            report_thesis();
        } else {
            report_frame();
        }
    } else if (state.answer) {
        state.answer = 0;
        report_answer();
    } else if (state.identity) {
        state.identity = 0;
        report_identity(reset_cause(board_rcon(), board_stkptr()));
    } else {
        return 0;
    }
    return 1;
}

void ranger_step(void)
{
    now_ms = clock_ms();
    board_alive();
    obey();
    measure();
    if (serial_idle() && compose()) {
        serial_send(line_buffer, line_length);
    }
}
