#include "model/report.h"

#include "model/command.h"
#include "model/echo.h"
#include "model/line.h"
#include "model/ping.h"
#include "protocol.h"

void report_frame(void)
{
    line_begin();
    line_char('P');
    line_decimal(ping.sequence);
    if (ping.status != STATUS_STUCK) {
        line_decimal(echo_us);
    } else {
        line_word(ping.high ? WORD_HIGH : WORD_LOW);
    }
    line_word(ping.status);
    line_decimal(ping.since_ms);
    line_end();
}

void report_thesis(void)
{
    line_begin();
    if (ping.status == STATUS_STUCK) {
        line_char('?');
    } else {
        line_digits(echo_cm() / ECHO_CM_PER_THESIS_STEP);
    }
    line_char('\n');
    line_char('\r');
}

void report_line_end(void)
{
    line_begin();
    line_char('\r');
    line_char('\n');
}

void report_answer(void)
{
    line_begin();
    line_char('A');
    line_decimal(command.answer);
    line_char(' ');
    line_hex_byte(command.byte);
    line_decimal(ping_period_ms);
    line_end();
}

void report_identity(uint8_t reset_cause) BYTE_IN_W
{
    line_begin();
    line_char('I');
    line_word(WORD_IDENTITY);
    line_word(reset_cause);
    line_end();
}
