#include "hal/clock.h"

#include "hal/registers.h"

/* 4 MHz / 4 (per instruction) / 4 (prescaler) / 250 = 1 kHz; the register holds one less. */
#define STEPS_PER_MS 250u

static volatile uint16_t count_ms;

void clock_open(void)
{
    count_ms = 0;
    PR2 = STEPS_PER_MS - 1u;
    CLEAR_BITS(IPR1, PERIPHERAL_TMR2);
    CLEAR_BITS(PIR1, PERIPHERAL_TMR2);
    SET_BITS(PIE1, PERIPHERAL_TMR2);
    T2CON = T2CON_ON | T2CON_PRESCALER_4;
}

uint16_t clock_ms(void)
{
    uint16_t ms;
    /* Two bytes, read one after the other: the count has to wait until both are. */
    CLEAR_BITS(PIE1, PERIPHERAL_TMR2);
    ms = count_ms;
    SET_BITS(PIE1, PERIPHERAL_TMR2);
    return ms;
}

void clock_interrupt(void)
{
    /* The serial port's interrupt comes here too, also while the count is being read: then the flag stays for later. */
    if ((PIE1 & PERIPHERAL_TMR2) && (PIR1 & PERIPHERAL_TMR2)) {
        CLEAR_BITS(PIR1, PERIPHERAL_TMR2);
        count_ms++;
    }
}
