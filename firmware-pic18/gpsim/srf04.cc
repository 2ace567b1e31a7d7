#include "srf04.h"

#include <cstdlib>

#include "driver.h"

namespace board {

Srf04 *Srf04::instance = nullptr;

Srf04::Srf04(const char *name)
    : Module(name, "Devantech SRF04 ultrasonic ranger"),
      trigger(new InputPin("TRIG", false, [this](bool level) { triggered(level); })),
      echo(new OutputPin("ECHO", false)),
      burst([this] { begin_pulse(); }),
      pulse([this] { end_pulse(); }),
      distance_attribute(new TextAttribute("distance", "of what answers, in metres, or none", [this](const char *text) {
          set_distance(std::string(text) == "none" ? std::nullopt : std::optional(strtod(text, nullptr)));
      }))
{
    create_pkg(2);
    // The module's symbol table deletes them.
    addSymbol(trigger);
    addSymbol(echo);
    addSymbol(distance_attribute);
    assign_pin(1, trigger);
    assign_pin(2, echo);
    instance = this;
}

Module *Srf04::construct(const char *name)
{
    return new Srf04(name ? name : "srf04");
}

void Srf04::set_fault(Fault now)
{
    if (fault == now) {
        return;
    }
    fault = now;
    if (fault == Fault::high || fault == Fault::low) {
        drive(fault == Fault::high);
    } else if (!busy) {
        drive(false);
    }
}

void Srf04::drive(bool level)
{
    echo->drive(level);
    nesting.after_edge();
}

// The sensor pings when the trigger falls, if it was high for long enough and no ping is under way.
void Srf04::triggered(bool level)
{
    double now = now_us();
    if (level) {
        rose_us = now;
        return;
    }
    // A microsecond is the clock's step.
    if (now - rose_us < least_us - 0.5) {
        driver.tell("refused %.0f %.0f", now, now - rose_us);
    } else if (!busy) {
        busy = true;
        pings++;
        driver.ask("ping %lu %.0f %.0f", pings, now, now - rose_us);
        burst.start(before_pulse_us);
    }
}

void Srf04::begin_pulse()
{
    double width_us =
        fault == Fault::no_echo ? no_echo_us : pulse_us(distance_m, temperature_c, longest_us);
    if (fault != Fault::low) {
        drive(true);
    }
    driver.tell("echo %lu %.0f", pings, width_us);
    pulse.start(width_us);
}

void Srf04::end_pulse()
{
    busy = false;
    if (fault != Fault::high) {
        drive(false);
    }
}

} // namespace board
