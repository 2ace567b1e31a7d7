#include "nesting.h"

#include <gpsim/16bit-processors.h>

namespace board {

namespace {

INTCON_16 *intcon()
{
    auto *cpu = dynamic_cast<_16bit_processor *>(get_active_cpu());
    return cpu ? &cpu->intcon : nullptr;
}

void set_low_enable(INTCON_16 &control, bool on)
{
    // Not put(), which would look for interrupts at once.
    unsigned value = control.value.get() & ~INTCON_16::GIEL;
    control.value.put(on ? value | INTCON_16::GIEL : value);
}

bool edge_waits(INTCON_16 &control)
{
    constexpr unsigned both = INTCON_16::RBIF | INTCON_16::RBIE;
    return (control.value.get() & both) == both;
}

} // namespace

void Nesting::after_reset()
{
    watcher.stop();
    lent = false;
    begun = false;
    if (INTCON_16 *control = intcon()) {
        control->in_interrupt = false;
    }
}

Nesting::Nesting() : watcher([this] { after_edge(); }) {}

// While an interrupt runs, gpsim holds all others back by a flag of its own. It is taken away for the one of high
// priority and given back when that returns; meanwhile those of low priority are disabled, as they are on the chip.
// Looks again every cycle, until the edge has been served: both kinds may have been requested at the same moment.
void Nesting::after_edge()
{
    INTCON_16 *control = intcon();
    if (!control) {
        return;
    }
    if (control->in_interrupt && control->isHighPriorityInterrupt()) {
        begun = true;
    } else if (control->in_interrupt && edge_waits(*control)) {
        lent = true;
        begun = false;
        control->in_interrupt = false;
        set_low_enable(*control, false);
        control->put_value(control->value.get());
    } else if (lent && begun && !control->in_interrupt) {
        lent = false;
        control->in_interrupt = true;
        control->set_interrupt_vector(INTERRUPT_VECTOR_LO);
        set_low_enable(*control, true);
    }
    if (lent || edge_waits(*control)) {
        watcher.start(1);
    }
}

} // namespace board
