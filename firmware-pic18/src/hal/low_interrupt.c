#include "hal/low_interrupt.h"

#include "hal/clock.h"
#include "hal/serial.h"

void low_interrupt(void) INTERRUPT_LOW
{
    clock_interrupt();
    serial_interrupt();
}
