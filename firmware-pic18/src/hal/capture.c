#include "hal/capture.h"

#include "hal/registers.h"
#include "model/ping.h"

/* Timer 0 at an edge; it is read a byte at a time. */
typedef union {
    uint16_t us;
    struct {
        uint8_t low;
        uint8_t high;
    } byte;
} edge_t;

static volatile uint8_t stage;
/* Of the interrupt alone. */
static edge_t now;
static uint8_t line;

static volatile uint16_t rise_us;
static volatile uint16_t fall_us;

void capture_open(void)
{
    stage = CAPTURE_OFF;
    /* Free running: a difference of two readings needs no start and no stop, and the way to them cancels out. */
    T0CON = T0CON_ON | T0CON_NO_PRESCALER;
    SET_BITS(INTCON2, INTCON2_RBPU | INTCON2_RBIP);
    (void)PORTB;
    CLEAR_BITS(INTCON, INTCON_RBIF);
    SET_BITS(INTCON, INTCON_RBIE);
}

void capture_fire(void)
{
    stage = CAPTURE_ARMED;
    SET_BITS(LATB, PORTB_TRIGGER);
    /* 12 us and the instruction that ends them, 2 % less or more by the oscillator; an interrupt only adds. */
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    NO_OPERATION();
    CLEAR_BITS(LATB, PORTB_TRIGGER);
}

uint8_t capture_stage(void)
{
    return stage;
}

uint16_t capture_echo_us(void)
{
    return fall_us - rise_us;
}

uint8_t capture_line_high(void)
{
    return (PORTB & PORTB_ECHO) ? 1 : 0;
}

/*
 * Timer 0 is read first, on the same way at both edges. The chip latches its high byte when the low one is read (data
 * sheet DS39599, "16-bit mode timer reads and writes"); in gpsim the timer clears that latch when it overflows. So this
 * relies on no latch: where the low byte has wrapped since, the high one is read once more, and it was one less before.
 * Reading port B ends the mismatch that set the request; without it the chip would set it again, though gpsim would not.
 */
void capture_interrupt(void) INTERRUPT_HIGH
{
    now.byte.low = TMR0L;
    now.byte.high = TMR0H;
    if (TMR0L < now.byte.low) {
        now.byte.high = TMR0H - 1u;
    }
    line = PORTB;
    CLEAR_BITS(INTCON, INTCON_RBIF);
    if (line & PORTB_ECHO) {
        if (stage == CAPTURE_ARMED) {
            rise_us = now.us;
            stage = CAPTURE_RISEN;
        }
    } else if (stage == CAPTURE_RISEN) {
        fall_us = now.us;
        stage = CAPTURE_FALLEN;
    }
}
