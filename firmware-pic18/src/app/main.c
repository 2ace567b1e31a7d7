/* Where the program starts, and the configuration that is burnt in with it. */
#include "app/ranger.h"
/* The interrupts' functions, which nobody calls: their place in the program comes from their declarations. */
#include "hal/capture.h"
#include "hal/low_interrupt.h"

/* The internal oscillator, pins RA6 and RA7 for input and output; no second oscillator to fall back to. */
#pragma config OSC = INTIO2, FSCM = OFF, IESO = OFF
/* 65 ms of rest after power-on; a reset when the supply falls under 4.5 V: the sensor needs it. */
#pragma config PWRT = ON, BOR = ON, BORV = 45
/* About 4 ms times 128: half a second. */
#pragma config WDT = ON, WDTPS = 128
/* Port B digital after a reset, the reset pin in use, no programming at low voltage, no debugger. */
#pragma config PBAD = DIG, MCLRE = ON, LVP = OFF, DEBUG = OFF
/* A reset when the call stack runs over or under. */
#pragma config STVR = ON

/* For arguments and saved registers, from the top of RAM down; below it lies RAM that nothing else uses. */
#pragma stack 0x1C0 64

void main(void)
{
    ranger_open();
    for (;;) {
        ranger_step();
    }
}
