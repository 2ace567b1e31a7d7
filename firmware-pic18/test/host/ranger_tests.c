/* The whole program on the stand-in, with a clock and a sensor that the tests play. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "app/ranger.h"
#include "hal/capture.h"
#include "hal/low_interrupt.h"
#include "hal/registers.h"
#include "protocol.h"
#include "tests.h"

/* What came out of the serial port, and the lines of it that report pings. */
static char output[200000];
static size_t output_length;

/* What the sensor answers with. */
static uint16_t pulse_us;
static uint16_t time_us;
static uint16_t pulse_left_us;

static void edge(uint8_t high)
{
    PORTB = high ? 0x10 : 0;
    stand_in_set_timer(time_us);
    capture_interrupt();
}

static void transmit(void)
{
    PIR1 |= 0x10;
    if (PIE1 & 0x10) {
        TXREG = 0;
        low_interrupt();
        if (TXREG && output_length < sizeof output - 1) {
            output[output_length++] = (char)TXREG;
            output[output_length] = '\0';
        }
    }
    /* As the chip does when the register is written. */
    PIR1 &= (uint8_t)~0x10;
}

/* A millisecond: two bytes of output at 19200 baud, a few turns of the loop, the sensor's pulse. */
static void run_ms(int count)
{
    for (int i = 0; i < count; i++) {
        stand_in_trigger_cycles = 0;
        PIR1 |= 0x02;
        low_interrupt();
        transmit();
        transmit();
        for (int turn = 0; turn < 3; turn++) {
            ranger_step();
        }
        time_us += 1000;
        if (stand_in_trigger_cycles && pulse_us) {
            edge(1);
            pulse_left_us = pulse_us;
        } else if (pulse_left_us > 1000) {
            pulse_left_us -= 1000;
        } else if (pulse_left_us) {
            uint16_t now_us = time_us;
            time_us = (uint16_t)(now_us - 1000 + pulse_left_us);
            edge(0);
            time_us = now_us;
            pulse_left_us = 0;
        }
    }
}

static void receive(uint8_t byte)
{
    RCREG = byte;
    PIR1 |= 0x20;
    low_interrupt();
    PIR1 &= (uint8_t)~0x20;
}

static void type(const char *text)
{
    while (*text) {
        receive((uint8_t)*text++);
    }
}

static int setup(void **state)
{
    (void)state;
    stand_in_reset();
    output_length = 0;
    output[0] = '\0';
    pulse_us = 5831;
    pulse_left_us = 0;
    ranger_open();
    return 0;
}

/* Counts reports of pings, and fails when a sequence number is missing. */
static int pings_in_a_row(void)
{
    int count = 0;
    for (const char *at = output; (at = strstr(at, "\nP ")); at++) {
        assert_int_equal(atoi(at + 3), ++count & 0xFFFF);
    }
    return count;
}

static void begins_with_a_line_end_and_the_identity(void **state)
{
    (void)state;
    run_ms(60);
    assert_memory_equal(output, "\r\n", 2);
    assert_non_null(strstr(output, "I simbad-ranger "));
    assert_non_null(strstr(output, " power-on*"));
}

static void pings_four_times_a_second(void **state)
{
    (void)state;
    run_ms(10100);
    assert_int_equal(pings_in_a_row(), 41);
    assert_non_null(strstr(output, "P 3 5831 echo 250*"));
    assert_int_equal(LATD, 5831 / 59);
}

static void stuck_line_never_stops_the_loop_and_darkens_the_leds(void **state)
{
    (void)state;
    pulse_us = 0;
    run_ms(2000);
    assert_int_equal(pings_in_a_row(), 8);
    assert_non_null(strstr(output, "P 3 low stuck 250*"));
    assert_int_equal(LATD, 0);
    PORTB = 0x10;
    run_ms(2000);
    assert_int_equal(pings_in_a_row(), 16);
    assert_non_null(strstr(output, " high stuck 250*"));
}

static void no_echo_saturates_the_leds(void **state)
{
    (void)state;
    pulse_us = 36000;
    run_ms(500);
    assert_non_null(strstr(output, "P 1 36000 no-echo 65535*"));
    assert_int_equal(LATD, 255);
}

static void commands_are_carried_out_and_answered(void **state)
{
    (void)state;
    run_ms(100);
    type("p20\r");
    run_ms(2000);
    assert_non_null(strstr(output, "A 1 70 20*"));
    assert_true(pings_in_a_row() > 60);
    type("h");
    run_ms(200);
    int count = pings_in_a_row();
    run_ms(2000);
    assert_int_equal(pings_in_a_row(), count);
    type("s");
    run_ms(300);
    assert_int_equal(pings_in_a_row(), count + 1);
    type("r");
    run_ms(300);
    assert_true(pings_in_a_row() > count + 3);
}

static void thesis_mode_and_back(void **state)
{
    (void)state;
    run_ms(100);
    type("p65\rt");
    output_length = 0;
    run_ms(1000);
    assert_non_null(strstr(output, "A 0 74 250*"));
    assert_non_null(strstr(output, "49\n\r49\n\r"));
    type("f");
    run_ms(400);
    assert_non_null(strstr(output, "A 0 66 250*"));
    assert_non_null(strstr(output, " echo 250*"));
}

static void short_period_waits_for_the_pulse(void **state)
{
    (void)state;
    pulse_us = 36000;
    type("p20\r");
    run_ms(1000);
    int count = pings_in_a_row();
    assert_true(count >= 20 && count <= 28);
}

static void ping_reported_before_its_answer_waits(void **state)
{
    (void)state;
    run_ms(40);
    type("xyz");
    run_ms(100);
    assert_non_null(strstr(output, "A 16 78 250*"));
    assert_non_null(strstr(output, "A 16 79 250*"));
    assert_non_null(strstr(output, "A 16 7A 250*"));
}

/* Any bytes at all, as fast as the line carries them: what is lost is said, and no ping is missing afterwards. */
static void fuzzed_commands_lose_no_ping(void **state)
{
    (void)state;
    uint32_t seed = 20140901;
    type("f");
    for (int i = 0; i < 20000; i++) {
        seed = seed * 1664525u + 1013904223u;
        uint8_t byte = (uint8_t)(seed >> 24);
        /* The thesis's mode has no sequence numbers. */
        receive(byte == COMMAND_THESIS ? 'T' : byte);
        if (i % 2) {
            run_ms(1);
        }
        if (output_length > sizeof output / 2) {
            break;
        }
    }
    assert_true(pings_in_a_row() > 10);
    assert_non_null(strstr(output, "A 18 00 "));
    run_ms(1200);
    type("\rr");
    run_ms(3000);
    int count = pings_in_a_row();
    run_ms(3000);
    assert_true(pings_in_a_row() > count);
}

static void watchdog_is_told_on_every_turn(void **state)
{
    (void)state;
    stand_in_watchdog_turns = 0;
    run_ms(1000);
    assert_int_equal(stand_in_watchdog_turns, 3000);
}

int ranger_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(begins_with_a_line_end_and_the_identity, setup),
        cmocka_unit_test_setup(pings_four_times_a_second, setup),
        cmocka_unit_test_setup(stuck_line_never_stops_the_loop_and_darkens_the_leds, setup),
        cmocka_unit_test_setup(no_echo_saturates_the_leds, setup),
        cmocka_unit_test_setup(commands_are_carried_out_and_answered, setup),
        cmocka_unit_test_setup(thesis_mode_and_back, setup),
        cmocka_unit_test_setup(short_period_waits_for_the_pulse, setup),
        cmocka_unit_test_setup(ping_reported_before_its_answer_waits, setup),
        cmocka_unit_test_setup(fuzzed_commands_lose_no_ping, setup),
        cmocka_unit_test_setup(watchdog_is_told_on_every_turn, setup),
    };
    return cmocka_run_group_tests_name("ranger", tests, NULL, NULL);
}
