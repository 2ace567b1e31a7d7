#include "standin/p18f4320.h"

#include "compiler.h"

#define DEFINE(name) volatile uint8_t name;
REGISTERS(DEFINE)

unsigned stand_in_trigger_cycles;
unsigned stand_in_watchdog_turns;

void stand_in_reset(void)
{
#define CLEAR(name) name = 0;
    REGISTERS(CLEAR)
    RCON = 0x1C;
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
