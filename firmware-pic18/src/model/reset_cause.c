#include "model/reset_cause.h"

#include "protocol.h"

/* As in the data sheet; hal/bits.h is not for this layer. */
#define BOR 0x01u
#define POR 0x02u
#define TO 0x08u
#define RI 0x10u
#define UNDERFLOW 0x40u
#define FULL 0x80u

uint8_t reset_cause(uint8_t rcon, uint8_t stkptr)
{
    /* At power-on the other flags mean nothing yet. */
    if (!(rcon & POR)) {
        return RESET_POWER_ON;
    }
    if (!(rcon & BOR)) {
        return RESET_BROWN_OUT;
    }
    if (!(rcon & TO)) {
        return RESET_WATCHDOG;
    }
    if (!(rcon & RI)) {
        return RESET_INSTRUCTION;
    }
    return (stkptr & (FULL | UNDERFLOW)) ? RESET_STACK : RESET_MASTER_CLEAR;
}
