#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/checksum.h"
#include "model/command.h"
#include "model/echo.h"
#include "model/line.h"
#include "model/now.h"
#include "model/ping.h"
#include "model/report.h"
#include "model/reset_cause.h"
#include "protocol.h"
#include "tests.h"

/* ---------------------------------------------------------------- echo, line, report */

static void check_echo(char **fields, int count)
{
    assert_int_equal(count, 4);
    echo_us = (uint16_t)atoi(fields[0]);
    assert_string_equal(&words[echo_status()], fields[1]);
    assert_int_equal(echo_leds(), atoi(fields[2]));
    assert_int_equal(echo_cm() / ECHO_CM_PER_THESIS_STEP, atoi(fields[3]));
}

static void echo_is_what_the_vectors_say(void **state)
{
    (void)state;
    for_each_row("echoes.csv", check_echo);
}

static void echo_leds_never_wrap(void **state)
{
    (void)state;
    uint8_t before = 0;
    for (uint32_t us = 0; us <= 65535; us++) {
        echo_us = (uint16_t)us;
        assert_true(echo_leds() >= before);
        before = echo_leds();
    }
    assert_int_equal(before, 255);
}

static void checksum_of_the_check_text(void **state)
{
    (void)state;
    checksum_start();
    for (const char *c = "123456789"; *c; c++) {
        checksum_add((uint8_t)*c);
    }
    assert_int_equal(checksum_high, 0x29);
    assert_int_equal(checksum_low, 0xB1);
}

static void check_line(char **fields, int count)
{
    char expected[80];
    assert_int_equal(count, 6);
    if (strcmp(fields[0], "ping") == 0) {
        ping.sequence = (uint16_t)atoi(fields[1]);
        ping.status = status_of(fields[3]);
        ping.high = strcmp(fields[2], "high") == 0;
        ping.since_ms = (uint16_t)atoi(fields[4]);
        echo_us = (uint16_t)atoi(fields[2]);
        report_frame();
    } else {
        command.answer = (uint8_t)atoi(fields[1]);
        command.byte = (uint8_t)strtol(fields[2], NULL, 16);
        ping_period_ms = (uint16_t)atoi(fields[3]);
        report_answer();
    }
    strcpy(expected, fields[5]);
    assert_string_equal(line_text(), strcat(expected, "\r\n"));
}

static void lines_are_what_the_vectors_say(void **state)
{
    (void)state;
    for_each_row("lines.csv", check_line);
}

static void decimals_have_no_leading_zeros(void **state)
{
    (void)state;
    char expected[8];
    for (uint32_t value = 0; value <= 65535; value += value < 2000 ? 1 : 97) {
        line_begin();
        line_digits((uint16_t)value);
        snprintf(expected, sizeof expected, "%u", (unsigned)value);
        assert_string_equal(line_text(), expected);
    }
}

static void line_that_is_too_long_is_cut(void **state)
{
    (void)state;
    line_begin();
    for (int i = 0; i < 300; i++) {
        line_char('x');
    }
    assert_int_equal(line_length, LINE_MOST);
}

static void longest_identity_fits(void **state)
{
    (void)state;
    static const uint8_t causes[] = {RESET_POWER_ON,    RESET_BROWN_OUT, RESET_WATCHDOG,
                                     RESET_INSTRUCTION, RESET_STACK,     RESET_MASTER_CLEAR};
    for (size_t i = 0; i < sizeof causes; i++) {
        report_identity(causes[i]);
        assert_true(line_length < LINE_MOST);
        assert_memory_equal(line_text(), "I simbad-ranger ", 16);
        assert_non_null(strstr(line_text(), &words[causes[i]]));
        assert_string_equal(line_text() + line_length - 2, "\r\n");
    }
}

static void thesis_lines_are_numbers_and_lf_cr(void **state)
{
    (void)state;
    ping.status = STATUS_NO_ECHO;
    echo_us = 36000;
    report_thesis();
    assert_string_equal(line_text(), "305\n\r");
    ping.status = STATUS_STUCK;
    report_thesis();
    assert_string_equal(line_text(), "?\n\r");
}

/* ---------------------------------------------------------------- reset */

/* Data sheet DS39599, table 5-3, of what each reset leaves in RCON<4:0> where the program had set RI, POR and BOR. */
static void reset_causes_by_the_data_sheet(void **state)
{
    (void)state;
    assert_int_equal(reset_cause(0x1C, 0), RESET_POWER_ON);
    assert_int_equal(reset_cause(0x1E, 0), RESET_BROWN_OUT);
    assert_int_equal(reset_cause(0x17, 0), RESET_WATCHDOG);
    assert_int_equal(reset_cause(0x0F, 0), RESET_INSTRUCTION);
    assert_int_equal(reset_cause(0x1F, 0x80), RESET_STACK);
    assert_int_equal(reset_cause(0x1F, 0x40), RESET_STACK);
    assert_int_equal(reset_cause(0x1F, 0x05), RESET_MASTER_CLEAR);
}

/* ---------------------------------------------------------------- commands */

static void check_period(const char *digits, uint8_t answer, uint16_t period_ms)
{
    command_reset();
    assert_int_equal(command_take(COMMAND_PERIOD), 0);
    while (digits[1]) {
        assert_int_equal(command_take((uint8_t)*digits++), 0);
    }
    assert_int_equal(command_take((uint8_t)*digits), 1);
    assert_int_equal(command.byte, COMMAND_PERIOD);
    assert_int_equal(command.answer, answer);
    if (period_ms) {
        assert_int_equal(command.period_ms, period_ms);
    }
}

static void periods_in_and_out_of_range(void **state)
{
    (void)state;
    check_period("20\r", ANSWER_PERIOD_SHORT, 20);
    check_period("64\n", ANSWER_PERIOD_SHORT, 64);
    check_period("65\r", ANSWER_DONE, 65);
    check_period("0065\r", ANSWER_DONE, 65);
    check_period("1000\r", ANSWER_DONE, 1000);
    check_period("19\r", ANSWER_BAD_PERIOD, 0);
    check_period("1001\r", ANSWER_BAD_PERIOD, 0);
    check_period("\r", ANSWER_BAD_PERIOD, 0);
    check_period("25x", ANSWER_BAD_PERIOD, 0);
    check_period("-", ANSWER_BAD_PERIOD, 0);
    check_period("6555", ANSWER_BAD_PERIOD, 0);
}

static void every_byte_is_known_or_refused(void **state)
{
    (void)state;
    for (int byte = 0; byte < 256; byte++) {
        command_reset();
        uint8_t complete = command_take((uint8_t)byte);
        if (strchr("\r\n p", byte) && byte) {
            assert_int_equal(complete, 0);
        } else {
            assert_int_equal(complete, 1);
            assert_int_equal(command.byte, byte);
            assert_int_equal(command.answer,
                             byte && strchr("ftrhsi", byte) ? ANSWER_DONE : ANSWER_UNKNOWN_COMMAND);
        }
    }
}

static void period_without_end_is_dropped(void **state)
{
    (void)state;
    now_ms = 65000;
    command_reset();
    command_take(COMMAND_PERIOD);
    now_ms += COMMAND_PATIENCE_MS;
    assert_int_equal(command_overdue(), 0);
    now_ms++;
    assert_int_equal(command_overdue(), 1);
    assert_int_equal(command.answer, ANSWER_BAD_PERIOD);
    assert_int_equal(command_overdue(), 0);
}

/* ---------------------------------------------------------------- pings */

/* Steps on until something happens, a millisecond at a time; returns it, or nothing after the limit. */
static uint8_t step_until(uint16_t limit_ms)
{
    uint8_t action = PING_NOTHING;
    for (uint16_t i = 0; i < limit_ms && action == PING_NOTHING; i++) {
        now_ms++;
        action = ping_step();
    }
    return action;
}

static int ping_setup(void **state)
{
    (void)state;
    now_ms = 65400;
    ping_line_high = 0;
    ping_stage = CAPTURE_OFF;
    echo_us = 0;
    ping_reset();
    return 0;
}

static void answer_with(uint16_t us)
{
    ping_stage = CAPTURE_FALLEN;
    echo_us = us;
    assert_int_equal(ping_step(), PING_DONE);
    assert_int_equal(ping_awaits_pulse, 0);
}

static void first_ping_is_at_once_and_long_ago(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    answer_with(5831);
    assert_int_equal(ping.sequence, 1);
    assert_int_equal(ping.status, STATUS_ECHO);
    assert_int_equal(ping.since_ms, PING_LONG_AGO_MS);
}

static void pings_keep_the_beat_over_the_wrap(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    for (int i = 2; i < 200; i++) {
        answer_with(1000);
        assert_int_equal(step_until(PING_DEFAULT_PERIOD_MS), PING_FIRE);
        assert_int_equal(ping.since_ms, PING_DEFAULT_PERIOD_MS);
        assert_int_equal(ping.sequence, i);
    }
}

static void late_ping_begins_a_new_beat(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    now_ms += 700;
    answer_with(1000);
    assert_int_equal(ping_step(), PING_FIRE);
    assert_int_equal(ping.since_ms, 700);
    answer_with(1000);
    assert_int_equal(step_until(1000), PING_FIRE);
    assert_int_equal(ping.since_ms, PING_DEFAULT_PERIOD_MS);
}

static void no_rise_is_stuck_low(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    ping_stage = CAPTURE_ARMED;
    assert_int_equal(step_until(PING_RISE_LIMIT_MS), PING_NOTHING);
    assert_int_equal(step_until(1), PING_DONE);
    assert_int_equal(ping.status, STATUS_STUCK);
    assert_int_equal(ping.high, 0);
}

static void no_fall_is_stuck_high(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    ping_stage = CAPTURE_RISEN;
    assert_int_equal(step_until(PING_FALL_LIMIT_MS), PING_NOTHING);
    assert_int_equal(step_until(1), PING_DONE);
    assert_int_equal(ping.status, STATUS_STUCK);
    assert_int_equal(ping.high, 1);
}

static void line_that_is_high_is_not_triggered(void **state)
{
    (void)state;
    ping_line_high = 1;
    for (int i = 1; i < 10; i++) {
        assert_int_equal(step_until(PING_DEFAULT_PERIOD_MS), PING_DONE);
        assert_int_equal(ping.status, STATUS_STUCK);
        assert_int_equal(ping.high, 1);
        assert_int_equal(ping.sequence, i);
    }
}

static void singles_are_counted_and_end_the_run(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    for (int i = 0; i < 300; i++) {
        ping_single();
    }
    answer_with(1000);
    for (int i = 0; i < 255; i++) {
        assert_int_equal(ping_step(), PING_FIRE);
        answer_with(1000);
    }
    assert_int_equal(step_until(3000), PING_NOTHING);
    ping_run();
    assert_int_equal(ping_step(), PING_FIRE);
}

static void halt_ends_the_run_and_long_rest_is_long_ago(void **state)
{
    (void)state;
    assert_int_equal(ping_step(), PING_FIRE);
    ping_halt();
    answer_with(1000);
    for (int i = 0; i < 70; i++) {
        assert_int_equal(step_until(1000), PING_NOTHING);
    }
    ping_single();
    assert_int_equal(ping_step(), PING_FIRE);
    assert_int_equal(ping.since_ms, PING_LONG_AGO_MS);
}

static void change_of_period_counts_from_now(void **state)
{
    (void)state;
    ping_period_ms = 1000;
    ping_restart_period();
    assert_int_equal(step_until(999), PING_NOTHING);
    ping_period_ms = 20;
    ping_restart_period();
    assert_int_equal(step_until(19), PING_NOTHING);
    assert_int_equal(step_until(1), PING_FIRE);
}

int model_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(echo_is_what_the_vectors_say),
        cmocka_unit_test(echo_leds_never_wrap),
        cmocka_unit_test(checksum_of_the_check_text),
        cmocka_unit_test(lines_are_what_the_vectors_say),
        cmocka_unit_test(decimals_have_no_leading_zeros),
        cmocka_unit_test(line_that_is_too_long_is_cut),
        cmocka_unit_test(longest_identity_fits),
        cmocka_unit_test(thesis_lines_are_numbers_and_lf_cr),
        cmocka_unit_test(reset_causes_by_the_data_sheet),
        cmocka_unit_test(periods_in_and_out_of_range),
        cmocka_unit_test(every_byte_is_known_or_refused),
        cmocka_unit_test(period_without_end_is_dropped),
        cmocka_unit_test_setup(first_ping_is_at_once_and_long_ago, ping_setup),
        cmocka_unit_test_setup(pings_keep_the_beat_over_the_wrap, ping_setup),
        cmocka_unit_test_setup(late_ping_begins_a_new_beat, ping_setup),
        cmocka_unit_test_setup(no_rise_is_stuck_low, ping_setup),
        cmocka_unit_test_setup(no_fall_is_stuck_high, ping_setup),
        cmocka_unit_test_setup(line_that_is_high_is_not_triggered, ping_setup),
        cmocka_unit_test_setup(singles_are_counted_and_end_the_run, ping_setup),
        cmocka_unit_test_setup(halt_ends_the_run_and_long_rest_is_long_ago, ping_setup),
        cmocka_unit_test_setup(change_of_period_counts_from_now, ping_setup),
    };
    return cmocka_run_group_tests_name("model", tests, NULL, NULL);
}
