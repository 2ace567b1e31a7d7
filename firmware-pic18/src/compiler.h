/* What C has no words for, by compiler: SDCC for the PIC, any other for tests on the host. */
#ifndef COMPILER_H
#define COMPILER_H

#ifdef __SDCC_pic16
/* A pointer into data memory: two bytes and direct access, where a general one takes three and a call. */
/* Of a function: its first argument, a byte, comes in the working register, not on the stack. */
#define BYTE_IN_W __wparam
#define IN_RAM __data
/* The same for program memory, where all constants are. */
#define IN_CODE __code
#define INTERRUPT_HIGH __interrupt(1)
#define INTERRUPT_LOW __interrupt(2)
#define NO_OPERATION() __asm nop __endasm
#define CLEAR_WATCHDOG() __asm clrwdt __endasm
#else
#define BYTE_IN_W
#define IN_RAM
#define IN_CODE
#define INTERRUPT_HIGH
#define INTERRUPT_LOW
void stand_in_cycle(void);
void stand_in_watchdog(void);
#define NO_OPERATION() stand_in_cycle()
#define CLEAR_WATCHDOG() stand_in_watchdog()
#endif

#endif
