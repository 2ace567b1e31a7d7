/* Stands in for the registers on the host: plain variables, which tests read and write, and timer 0, which runs. */
#ifndef STANDIN_P18F4320_H
#define STANDIN_P18F4320_H

#include <stdint.h>

#define REGISTERS(each)                                                                                                \
    each(PORTB) each(LATA) each(LATB) each(LATC) each(LATD) each(LATE) each(TRISA) each(TRISB) each(TRISC) each(TRISD) \
        each(TRISE) each(PIE1) each(PIR1) each(IPR1) each(RCSTA) each(TXSTA) each(TXREG) each(RCREG) each(SPBRG)       \
            each(ADCON1) each(T2CON) each(PR2) each(RCON) each(OSCCON) each(T0CON) each(INTCON2) each(INTCON)          \
                each(STKPTR)

#define DECLARE(name) extern volatile uint8_t name;
REGISTERS(DECLARE)

#include "hal/bits.h"

/* Timer 0 runs on by two cycles with each read of one of its bytes, as it would between two instructions. */
enum stand_in_timer {
    STAND_IN_LATCHED,  /* the chip: a read of the low byte keeps the high one of that moment for its own read */
    STAND_IN_CLEARED,  /* gpsim 0.31: the same, but what is kept becomes 0 when the timer overflows */
    STAND_IN_UNLATCHED /* the high byte is the one of the moment in which it is read */
};

#define TMR0L stand_in_timer_low()
#define TMR0H stand_in_timer_high()
uint8_t stand_in_timer_low(void);
uint8_t stand_in_timer_high(void);

/* Sets timer 0, and after which of them it behaves. */
void stand_in_set_timer(uint16_t count);
void stand_in_set_timer_kind(enum stand_in_timer kind);

/* All registers as after power-on, in so far as the firmware depends on it: zero, but for RCON. */
void stand_in_reset(void);

/* Instruction cycles that passed while the trigger was high, and turns of the watchdog, since the reset. */
extern unsigned stand_in_trigger_cycles;
extern unsigned stand_in_watchdog_turns;

#endif
