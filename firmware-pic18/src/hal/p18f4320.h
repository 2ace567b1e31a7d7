/*
 * The registers of the PIC18F4320 that the ranger uses, by the addresses of its data sheet (DS39599, table 5-1), and
 * the bits of them. A bit is set or cleared in one instruction, so that an interrupt never falls in between.
 */
#ifndef HAL_P18F4320_H
#define HAL_P18F4320_H

/* Defined in sfr.c, known everywhere else. */
#ifdef SFR_DEFINE
#define SFR(address, name) __sfr __at(address) name
#else
#define SFR(address, name) extern __sfr __at(address) name
#endif

/* Ports: the level of the pins, the latch that drives them, their direction (1 is input). */
SFR(0xF81, PORTB);
SFR(0xF89, LATA);
SFR(0xF8A, LATB);
SFR(0xF8B, LATC);
SFR(0xF8C, LATD);
SFR(0xF8D, LATE);
SFR(0xF92, TRISA);
SFR(0xF93, TRISB);
SFR(0xF94, TRISC);
SFR(0xF95, TRISD);
SFR(0xF96, TRISE);

/* Interrupts of peripherals: enable, request, priority. */
SFR(0xF9D, PIE1);
SFR(0xF9E, PIR1);
SFR(0xF9F, IPR1);

/* The serial port. */
SFR(0xFAB, RCSTA);
SFR(0xFAC, TXSTA);
SFR(0xFAD, TXREG);
SFR(0xFAE, RCREG);
SFR(0xFAF, SPBRG);

/* Analog inputs, timer 2, power, oscillator, timer 0. */
SFR(0xFC1, ADCON1);
SFR(0xFCA, T2CON);
SFR(0xFCB, PR2);
SFR(0xFD0, RCON);
SFR(0xFD3, OSCCON);
SFR(0xFD5, T0CON);
SFR(0xFD6, TMR0L);
SFR(0xFD7, TMR0H);

/* The core's interrupts, and the call stack's pointer. */
SFR(0xFF1, INTCON2);
SFR(0xFF2, INTCON);
SFR(0xFFC, STKPTR);

/* Of the core: what compiled code and the start-up code use. */
SFR(0xFD8, STATUS);
SFR(0xFD9, FSR2L);
SFR(0xFDA, FSR2H);
SFR(0xFDB, PLUSW2);
SFR(0xFDC, PREINC2);
SFR(0xFDD, POSTDEC2);
SFR(0xFDE, POSTINC2);
SFR(0xFE0, BSR);
SFR(0xFE1, FSR1L);
SFR(0xFE2, FSR1H);
SFR(0xFE4, PREINC1);
SFR(0xFE5, POSTDEC1);
SFR(0xFE6, POSTINC1);
SFR(0xFE8, WREG);
SFR(0xFE9, FSR0L);
SFR(0xFEA, FSR0H);
SFR(0xFEB, PLUSW0);
SFR(0xFEC, PREINC0);
SFR(0xFED, POSTDEC0);
SFR(0xFEE, POSTINC0);
SFR(0xFF3, PRODL);
SFR(0xFF4, PRODH);
SFR(0xFF5, TABLAT);
SFR(0xFF6, TBLPTRL);
SFR(0xFF7, TBLPTRH);
SFR(0xFF8, TBLPTRU);
SFR(0xFFA, PCLATH);
SFR(0xFFB, PCLATU);

#include "hal/bits.h"

#endif
