#include "model/echo.h"

#include "protocol.h"

uint16_t echo_us;

static uint16_t rest_us;
static uint16_t cm;

uint8_t echo_status(void)
{
    if (echo_us >= ECHO_NO_ECHO_US) {
        return STATUS_NO_ECHO;
    }
    return echo_us < ECHO_TOO_NEAR_US ? STATUS_TOO_NEAR : STATUS_ECHO;
}

uint16_t echo_cm(void)
{
    /* Without the library's division, which would be the largest part of the program. */
    rest_us = echo_us;
    cm = 0;
    while (rest_us >= 10u * ECHO_US_PER_CM) {
        rest_us -= 10u * ECHO_US_PER_CM;
        cm += 10u;
    }
    while (rest_us >= ECHO_US_PER_CM) {
        rest_us -= ECHO_US_PER_CM;
        cm++;
    }
    return cm;
}

uint8_t echo_leds(void)
{
    /* Compared before it is divided: the quotient always fits the eight LEDs. */
    return echo_us >= ECHO_MOST_LEDS * ECHO_US_PER_CM ? (uint8_t)ECHO_MOST_LEDS : (uint8_t)echo_cm();
}
