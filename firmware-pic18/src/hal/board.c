#include "hal/board.h"

#include "compiler.h"
#include "hal/registers.h"

static uint8_t rcon;
static uint8_t stkptr;

static void note_reset(void)
{
    rcon = RCON;
    stkptr = STKPTR;
    /* Only the program sets them; the next reset clears the one that it is. */
    SET_BITS(RCON, RCON_RI | RCON_POR | RCON_BOR);
    CLEAR_BITS(STKPTR, STKPTR_FULL);
    CLEAR_BITS(STKPTR, STKPTR_UNDERFLOW);
}

static void open_pins(void)
{
    ADCON1 = ADCON1_ALL_DIGITAL;
    LATA = 0;
    LATB = 0;
    LATC = 0;
    LATD = 0;
    LATE = 0;
    /* What is not connected is an output: a floating RB5 to RB7 would set off the interrupt of the echo. */
    TRISA = 0;
    TRISB = PORTB_ECHO;
    /* Inputs both, as the data sheet asks for: the serial port takes them over. */
    TRISC = PORTC_RX | PORTC_TX;
    TRISD = 0;
    TRISE = 0;
}

void board_open(void)
{
    note_reset();
    OSCCON = OSCCON_4_MHZ | OSCCON_INTERNAL;
    open_pins();
    SET_BITS(RCON, RCON_IPEN);
}

void board_enable_interrupts(void)
{
    SET_BITS(INTCON, INTCON_GIEL);
    SET_BITS(INTCON, INTCON_GIEH);
}

uint8_t board_rcon(void)
{
    return rcon;
}

uint8_t board_stkptr(void)
{
    return stkptr;
}

void board_show(uint8_t leds) BYTE_IN_W
{
    LATD = leds;
}

void board_alive(void)
{
    CLEAR_WATCHDOG();
}
