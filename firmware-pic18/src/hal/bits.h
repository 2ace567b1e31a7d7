/* The bits of the registers, the same on the chip and on the stand-in. Names as in the data sheet. */
#ifndef HAL_BITS_H
#define HAL_BITS_H

#define PORTB_TRIGGER 0x08u /* RB3, output */
#define PORTB_ECHO 0x10u    /* RB4, input with interrupt on change */

#define PORTC_RX 0x80u /* RC7 */
#define PORTC_TX 0x40u /* RC6 */

#define INTCON_GIEH 0x80u
#define INTCON_GIEL 0x40u
#define INTCON_RBIE 0x08u
#define INTCON_RBIF 0x01u
#define INTCON2_RBPU 0x80u /* 1: no pull-ups on port B */
#define INTCON2_RBIP 0x01u

/* The same places in PIE1, PIR1 and IPR1. */
#define PERIPHERAL_RC 0x20u
#define PERIPHERAL_TX 0x10u
#define PERIPHERAL_TMR2 0x02u

#define RCSTA_SPEN 0x80u
#define RCSTA_CREN 0x10u
#define RCSTA_FERR 0x04u
#define RCSTA_OERR 0x02u
#define TXSTA_TXEN 0x20u
#define TXSTA_BRGH 0x04u

#define RCON_IPEN 0x80u
#define RCON_RI 0x10u
#define RCON_POR 0x02u
#define RCON_BOR 0x01u

#define STKPTR_FULL 0x80u
#define STKPTR_UNDERFLOW 0x40u

#define OSCCON_4_MHZ 0x60u
#define OSCCON_INTERNAL 0x02u

#define T0CON_ON 0x80u
#define T0CON_NO_PRESCALER 0x08u
#define T2CON_ON 0x04u
#define T2CON_PRESCALER_4 0x01u

#define ADCON1_ALL_DIGITAL 0x0Fu

#define SET_BITS(register, bits) ((register) |= (bits))
#define CLEAR_BITS(register, bits) ((register) &= (unsigned char)~(bits))

#endif
