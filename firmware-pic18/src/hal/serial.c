#include "hal/serial.h"

#include "hal/registers.h"

/* 4 MHz / (16 * 13) = 19231 baud, 0.16 % too fast; the register holds one less. */
#define BAUD_DIVIDER 13u

/* A power of two. */
#define RECEIVED_MOST 16u

static IN_RAM const char *volatile next;
static volatile uint8_t left;

static volatile uint8_t received[RECEIVED_MOST];
/* Counts of bytes put in and taken out; each is written on one side only. */
static volatile uint8_t put;
static volatile uint8_t taken;
static volatile uint8_t lost;

void serial_open(void)
{
    left = 0;
    put = 0;
    taken = 0;
    lost = 0;
    SPBRG = BAUD_DIVIDER - 1u;
    TXSTA = TXSTA_TXEN | TXSTA_BRGH;
    RCSTA = RCSTA_SPEN | RCSTA_CREN;
    CLEAR_BITS(IPR1, PERIPHERAL_RC);
    CLEAR_BITS(IPR1, PERIPHERAL_TX);
    SET_BITS(PIE1, PERIPHERAL_RC);
}

uint8_t serial_idle(void)
{
    return left == 0;
}

void serial_send(IN_RAM const char *text, uint8_t length)
{
    next = text;
    left = length;
    SET_BITS(PIE1, PERIPHERAL_TX);
}

uint8_t serial_has_byte(void)
{
    return put != taken;
}

uint8_t serial_take(void)
{
    uint8_t byte = received[taken & (RECEIVED_MOST - 1u)];
    taken++;
    return byte;
}

uint8_t serial_lost(void)
{
    if (lost) {
        lost = 0;
        return 1;
    }
    return 0;
}

static void receive(void)
{
    /* The flag belongs to the byte that waits, and is gone when the byte is read. */
    uint8_t garbled = RCSTA & RCSTA_FERR;
    uint8_t byte = RCREG;
    if (garbled || (uint8_t)(put - taken) >= RECEIVED_MOST) {
        lost = 1;
        return;
    }
    received[put & (RECEIVED_MOST - 1u)] = byte;
    put++;
}

static void transmit(void)
{
    if (left) {
        TXREG = (uint8_t)*next;
        next++;
        left--;
    } else {
        CLEAR_BITS(PIE1, PERIPHERAL_TX);
    }
}

void serial_interrupt(void)
{
    if (PIR1 & PERIPHERAL_RC) {
        receive();
    }
    if (RCSTA & RCSTA_OERR) {
        /* After an overrun the receiver stands still until it is switched off and on. */
        CLEAR_BITS(RCSTA, RCSTA_CREN);
        SET_BITS(RCSTA, RCSTA_CREN);
        lost = 1;
    }
    if ((PIE1 & PERIPHERAL_TX) && (PIR1 & PERIPHERAL_TX)) {
        transmit();
    }
}
