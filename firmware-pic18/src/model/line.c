#include "model/line.h"

#include "model/checksum.h"
#include "protocol.h"

IN_RAM char line_buffer[LINE_MOST];
uint8_t line_length;

static struct {
    uint16_t rest;
    uint8_t begun;
} decimal;

void line_begin(void)
{
    line_length = 0;
    checksum_start();
}

void line_char(char c) BYTE_IN_W
{
    if (line_length < LINE_MOST) {
        line_buffer[line_length] = c;
        line_length++;
        checksum_add((uint8_t)c);
    }
}

void line_word(uint8_t word) BYTE_IN_W
{
    char c = ' ';
    do {
        line_char(c);
        c = words[word++];
    } while (c);
}

/* Subtracts powers of ten: at most nine times each, where a division would take ten times as long. */
static void decimal_digit(uint16_t power)
{
    char digit = '0';
    while (decimal.rest >= power) {
        decimal.rest -= power;
        decimal.begun = 1;
        digit++;
    }
    if (decimal.begun) {
        line_char(digit);
    }
}

void line_digits(uint16_t value)
{
    decimal.rest = value;
    decimal.begun = 0;
    decimal_digit(10000u);
    decimal_digit(1000u);
    decimal_digit(100u);
    decimal_digit(10u);
    line_char((char)('0' + (uint8_t)decimal.rest));
}

void line_decimal(uint16_t value)
{
    line_char(' ');
    line_digits(value);
}

static void hex_digit(uint8_t value) BYTE_IN_W
{
    line_char((char)(value < 10u ? '0' + value : 'A' - 10 + value));
}

void line_hex_byte(uint8_t value) BYTE_IN_W
{
    hex_digit(value >> 4);
    hex_digit(value & 0x0Fu);
}

void line_end(void)
{
    uint8_t high = checksum_high;
    uint8_t low = checksum_low;
    line_char('*');
    line_hex_byte(high);
    line_hex_byte(low);
    line_char('\r');
    line_char('\n');
}
