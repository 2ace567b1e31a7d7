/* Stands in for the registers on the host: plain variables, which tests read and write. */
#ifndef STANDIN_P18F4320_H
#define STANDIN_P18F4320_H

#include <stdint.h>

#define REGISTERS(each)                                                                                                \
    each(PORTB) each(LATA) each(LATB) each(LATC) each(LATD) each(LATE) each(TRISA) each(TRISB) each(TRISC) each(TRISD) \
        each(TRISE) each(PIE1) each(PIR1) each(IPR1) each(RCSTA) each(TXSTA) each(TXREG) each(RCREG) each(SPBRG)       \
            each(ADCON1) each(T2CON) each(PR2) each(RCON) each(OSCCON) each(T0CON) each(TMR0L) each(TMR0H)             \
                each(INTCON2) each(INTCON) each(STKPTR)

#define DECLARE(name) extern volatile uint8_t name;
REGISTERS(DECLARE)

#include "hal/bits.h"

/* All registers as after power-on, in so far as the firmware depends on it: zero, but for RCON. */
void stand_in_reset(void);

/* Instruction cycles that passed while the trigger was high, and turns of the watchdog, since the reset. */
extern unsigned stand_in_trigger_cycles;
extern unsigned stand_in_watchdog_turns;

#endif
