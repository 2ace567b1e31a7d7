/* Composes one line of output in the one buffer that there is. Pure. */
#ifndef MODEL_LINE_H
#define MODEL_LINE_H

#include <stdint.h>

#include "compiler.h"

/* The longest line is an identity, 48 characters; more is cut off. */
#define LINE_MOST 52u

extern IN_RAM char line_buffer[LINE_MOST];
extern uint8_t line_length;

/* Empties the buffer. */
void line_begin(void);

void line_char(char c) BYTE_IN_W;

/* A blank and a word of protocol.h, by its WORD_... */
void line_word(uint8_t word) BYTE_IN_W;

/* A number in decimal digits; with a blank before it. */
void line_digits(uint16_t value);
void line_decimal(uint16_t value);

/* Two hexadecimal digits. */
void line_hex_byte(uint8_t value) BYTE_IN_W;

/* Ends a line of frame mode: '*', the checksum of all before it in four hexadecimal digits, CR LF. */
void line_end(void);

#endif
