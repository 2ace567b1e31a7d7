#include "hal/board.h"
#include "hal/capture.h"
#include "hal/clock.h"
#include "hal/low_interrupt.h"
#include "hal/registers.h"
#include "hal/serial.h"
#include "model/ping.h"
#include "tests.h"

static int setup(void **state)
{
    (void)state;
    stand_in_reset();
    return 0;
}

/* ---------------------------------------------------------------- board */

static void board_sets_oscillator_pins_and_priorities(void **state)
{
    (void)state;
    board_open();
    assert_int_equal(OSCCON, 0x62);
    assert_int_equal(ADCON1, 0x0F);
    /* Only the echo and the serial port's two are inputs. */
    assert_int_equal(TRISB, 0x10);
    assert_int_equal(TRISC, 0xC0);
    assert_int_equal(TRISA | TRISD | TRISE, 0);
    assert_true(RCON & 0x80);
    board_show(0xA5);
    assert_int_equal(LATD, 0xA5);
    board_alive();
    assert_int_equal(stand_in_watchdog_turns, 1);
}

static void board_notes_and_rearms_the_cause_of_the_reset(void **state)
{
    (void)state;
    RCON = 0x1C;
    STKPTR = 0x83;
    board_open();
    assert_int_equal(board_rcon(), 0x1C);
    assert_int_equal(board_stkptr(), 0x83);
    assert_int_equal(RCON & 0x13, 0x13);
    /* The flags only: the rest is where the program returns to. */
    assert_int_equal(STKPTR, 0x03);
}

static void board_enables_both_priorities_last(void **state)
{
    (void)state;
    board_open();
    assert_int_equal(INTCON & 0xC0, 0);
    board_enable_interrupts();
    assert_int_equal(INTCON & 0xC0, 0xC0);
}

/* ---------------------------------------------------------------- clock */

static void clock_counts_milliseconds(void **state)
{
    (void)state;
    clock_open();
    assert_int_equal(PR2, 249);
    assert_int_equal(T2CON, 0x05);
    assert_int_equal(IPR1 & 0x02, 0);
    assert_int_equal(PIE1 & 0x02, 0x02);
    clock_interrupt();
    assert_int_equal(clock_ms(), 0);
    for (int i = 0; i < 300; i++) {
        PIR1 |= 0x02;
        low_interrupt();
        assert_int_equal(PIR1 & 0x02, 0);
    }
    assert_int_equal(clock_ms(), 300);
    assert_int_equal(PIE1 & 0x02, 0x02);
}

/* While the count is being read its own interrupt is disabled; the one of the serial port goes through the same code. */
static void clock_waits_while_it_is_read(void **state)
{
    (void)state;
    clock_open();
    PIE1 &= (uint8_t)~0x02;
    PIR1 |= 0x02;
    low_interrupt();
    assert_int_equal(PIR1 & 0x02, 0x02);
    /* Reading enables it again. */
    assert_int_equal(clock_ms(), 0);
    low_interrupt();
    assert_int_equal(PIR1 & 0x02, 0);
    assert_int_equal(clock_ms(), 1);
}

/* ---------------------------------------------------------------- capture */

static void edge(uint8_t high, uint16_t at_us)
{
    PORTB = high ? 0x10 : 0;
    stand_in_set_timer(at_us);
    INTCON |= 0x01;
    capture_interrupt();
    assert_int_equal(INTCON & 0x01, 0);
}

static void capture_has_the_high_priority(void **state)
{
    (void)state;
    capture_open();
    assert_int_equal(INTCON2 & 0x01, 0x01);
    assert_int_equal(INTCON & 0x09, 0x08);
    /* On, 16 bits, instruction clock, no prescaler. */
    assert_int_equal(T0CON, 0x88);
}

static void trigger_is_at_least_ten_microseconds(void **state)
{
    (void)state;
    capture_open();
    capture_fire();
    assert_true(stand_in_trigger_cycles >= 12);
    assert_int_equal(LATB & 0x08, 0);
    assert_int_equal(capture_stage(), CAPTURE_ARMED);
}

static void check_pulse(uint16_t from_us, uint16_t length_us)
{
    capture_fire();
    edge(1, from_us);
    assert_int_equal(capture_stage(), CAPTURE_RISEN);
    edge(0, (uint16_t)(from_us + length_us));
    assert_int_equal(capture_stage(), CAPTURE_FALLEN);
    assert_int_equal(capture_echo_us(), length_us);
}

static void pulses_are_timed_over_the_timers_wrap(void **state)
{
    (void)state;
    capture_open();
    check_pulse(1000, 100);
    check_pulse(65500, 36000);
    check_pulse(255, 1);
    check_pulse(40000, 60000);
}

/* Wherever an edge falls, also between the reads of two bytes of which the first has wrapped. */
static void check_every_phase(enum stand_in_timer kind)
{
    stand_in_set_timer_kind(kind);
    capture_open();
    for (uint32_t at_us = 0; at_us <= 65535; at_us++) {
        check_pulse((uint16_t)at_us, 5753);
    }
}

static void pulses_are_timed_wherever_the_timer_is(void **state)
{
    (void)state;
    check_every_phase(STAND_IN_LATCHED);
    check_every_phase(STAND_IN_CLEARED);
    check_every_phase(STAND_IN_UNLATCHED);
}

static void edges_that_are_not_awaited_change_nothing(void **state)
{
    (void)state;
    capture_open();
    edge(1, 5);
    assert_int_equal(capture_stage(), CAPTURE_OFF);
    capture_fire();
    edge(0, 10);
    assert_int_equal(capture_stage(), CAPTURE_ARMED);
    edge(1, 100);
    edge(1, 150);
    edge(0, 300);
    edge(1, 400);
    edge(0, 500);
    assert_int_equal(capture_echo_us(), 200);
    assert_int_equal(capture_line_high(), 0);
}

/* ---------------------------------------------------------------- serial port */

static void receive(uint8_t byte, uint8_t flags)
{
    RCREG = byte;
    RCSTA = (uint8_t)((RCSTA & 0xF8) | flags);
    PIR1 |= 0x20;
    low_interrupt();
    PIR1 &= (uint8_t)~0x20;
}

static void serial_is_19200_8n1_of_low_priority(void **state)
{
    (void)state;
    serial_open();
    assert_int_equal(SPBRG, 12);
    assert_int_equal(TXSTA, 0x24);
    assert_int_equal(RCSTA, 0x90);
    assert_int_equal(IPR1 & 0x30, 0);
    assert_int_equal(PIE1 & 0x30, 0x20);
}

static void serial_sends_a_text_byte_by_byte(void **state)
{
    (void)state;
    static const char text[] = "ab";
    serial_open();
    serial_send(text, 2);
    assert_false(serial_idle());
    PIR1 |= 0x10;
    low_interrupt();
    assert_int_equal(TXREG, 'a');
    low_interrupt();
    assert_int_equal(TXREG, 'b');
    assert_true(serial_idle());
    assert_int_equal(PIE1 & 0x10, 0x10);
    low_interrupt();
    assert_int_equal(PIE1 & 0x10, 0);
    assert_int_equal(TXREG, 'b');
}

static void serial_keeps_sixteen_bytes_and_says_what_is_lost(void **state)
{
    (void)state;
    serial_open();
    for (int round = 0; round < 40; round++) {
        for (uint8_t i = 0; i < 16; i++) {
            receive(i, 0);
        }
        assert_false(serial_lost());
        receive(99, 0);
        assert_true(serial_lost());
        assert_false(serial_lost());
        for (uint8_t i = 0; i < 16; i++) {
            assert_true(serial_has_byte());
            assert_int_equal(serial_take(), i);
        }
        assert_false(serial_has_byte());
    }
}

static void serial_drops_what_is_garbled(void **state)
{
    (void)state;
    serial_open();
    receive('x', 0x04);
    assert_false(serial_has_byte());
    assert_true(serial_lost());
}

static void serial_recovers_from_an_overrun(void **state)
{
    (void)state;
    serial_open();
    receive('x', 0x02);
    assert_true(serial_has_byte());
    assert_true(serial_lost());
    assert_int_equal(RCSTA & 0x10, 0x10);
}

int hal_tests(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(board_sets_oscillator_pins_and_priorities, setup),
        cmocka_unit_test_setup(board_notes_and_rearms_the_cause_of_the_reset, setup),
        cmocka_unit_test_setup(board_enables_both_priorities_last, setup),
        cmocka_unit_test_setup(clock_counts_milliseconds, setup),
        cmocka_unit_test_setup(clock_waits_while_it_is_read, setup),
        cmocka_unit_test_setup(capture_has_the_high_priority, setup),
        cmocka_unit_test_setup(trigger_is_at_least_ten_microseconds, setup),
        cmocka_unit_test_setup(pulses_are_timed_over_the_timers_wrap, setup),
        cmocka_unit_test_setup(pulses_are_timed_wherever_the_timer_is, setup),
        cmocka_unit_test_setup(edges_that_are_not_awaited_change_nothing, setup),
        cmocka_unit_test_setup(serial_is_19200_8n1_of_low_priority, setup),
        cmocka_unit_test_setup(serial_sends_a_text_byte_by_byte, setup),
        cmocka_unit_test_setup(serial_keeps_sixteen_bytes_and_says_what_is_lost, setup),
        cmocka_unit_test_setup(serial_drops_what_is_garbled, setup),
        cmocka_unit_test_setup(serial_recovers_from_an_overrun, setup),
    };
    return cmocka_run_group_tests_name("hal", tests, NULL, NULL);
}
