#include "standin/p18f4320.h"

#include "compiler.h"

#define DEFINE(name) volatile uint8_t name;
REGISTERS(DEFINE)

unsigned stand_in_trigger_cycles;
unsigned stand_in_watchdog_turns;

static enum stand_in_timer timer_kind;
static uint16_t timer_count;
static uint8_t timer_kept;

#define CYCLES_BETWEEN_READS 2u

static void run_timer(void)
{
    uint16_t before = timer_count;
    timer_count = (uint16_t)(timer_count + CYCLES_BETWEEN_READS);
    if (timer_count < before && timer_kind == STAND_IN_CLEARED) {
        timer_kept = 0;
    }
}

void stand_in_set_timer(uint16_t count)
{
    timer_count = count;
}

void stand_in_set_timer_kind(enum stand_in_timer kind)
{
    timer_kind = kind;
}

uint8_t stand_in_timer_low(void)
{
    uint8_t low = (uint8_t)timer_count;
    timer_kept = (uint8_t)(timer_count >> 8);
    run_timer();
    return low;
}

uint8_t stand_in_timer_high(void)
{
    uint8_t high = timer_kind == STAND_IN_UNLATCHED ? (uint8_t)(timer_count >> 8) : timer_kept;
    run_timer();
    return high;
}

void stand_in_reset(void)
{
#define CLEAR(name) name = 0;
    REGISTERS(CLEAR)
    RCON = 0x1C;
    timer_kind = STAND_IN_LATCHED;
    timer_count = 0;
    timer_kept = 0;
    stand_in_trigger_cycles = 0;
    stand_in_watchdog_turns = 0;
}

void stand_in_cycle(void)
{
    if (LATB & PORTB_TRIGGER) {
        stand_in_trigger_cycles++;
    }
}

void stand_in_watchdog(void)
{
    stand_in_watchdog_turns++;
}
