#include "model/command.h"

#include "model/now.h"
#include "model/ping.h"
#include "protocol.h"

command_t command;

static struct {
    uint16_t begun_ms;
    uint8_t open;
} period;

void command_reset(void)
{
    period.open = 0;
}

static uint8_t complete(uint8_t answer) BYTE_IN_W
{
    period.open = 0;
    command.answer = answer;
    return 1;
}

static uint8_t end_period(void)
{
    if (command.period_ms < PING_LEAST_PERIOD_MS || command.period_ms > PING_MOST_PERIOD_MS) {
        return complete(ANSWER_BAD_PERIOD);
    }
    return complete(command.period_ms < PING_QUIET_PERIOD_MS ? ANSWER_PERIOD_SHORT : ANSWER_DONE);
}

static uint8_t take_in_period(uint8_t byte) BYTE_IN_W
{
    if (byte == '\r' || byte == '\n') {
        return end_period();
    }
    byte -= '0';
    /* With one more digit it would be out of range, and some day overflow. */
    if (byte > 9u || command.period_ms > PING_MOST_PERIOD_MS / 10u) {
        return complete(ANSWER_BAD_PERIOD);
    }
    /* Times ten, without the library's multiplication. */
    command.period_ms += command.period_ms << 2;
    command.period_ms += command.period_ms;
    command.period_ms += byte;
    return 0;
}

uint8_t command_take(uint8_t byte) BYTE_IN_W
{
    if (period.open) {
        return take_in_period(byte);
    }
    command.byte = byte;
    switch (byte) {
    case '\r':
    case '\n':
    case ' ':
        return 0;
    case COMMAND_PERIOD:
        period.open = 1;
        period.begun_ms = now_ms;
        command.period_ms = 0;
        return 0;
    case COMMAND_FRAME:
    case COMMAND_THESIS:
    case COMMAND_RUN:
    case COMMAND_HALT:
    case COMMAND_SINGLE:
    case COMMAND_IDENTIFY:
        return complete(ANSWER_DONE);
    default:
        return complete(ANSWER_UNKNOWN_COMMAND);
    }
}

uint8_t command_overdue(void)
{
    return period.open && (uint16_t)(now_ms - period.begun_ms) > COMMAND_PATIENCE_MS ? complete(ANSWER_BAD_PERIOD) : 0;
}
