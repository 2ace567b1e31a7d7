// A Devantech SRF04: pins TRIG (in) and ECHO (out).
#pragma once

#include <optional>
#include <string>

#include "nesting.h"
#include "pulse.h"
#include "simulation.h"

namespace board {

enum class Fault { none, no_echo, high, low };

class Srf04 : public Module {
public:
    explicit Srf04(const char *name);
    static Module *construct(const char *name);

    // The one on the board, if it is there.
    static Srf04 *instance;

    void set_distance(std::optional<double> metres) { distance_m = metres; }
    void set_temperature(double celsius) { temperature_c = celsius; }
    void set_longest(double us) { longest_us = us; }
    void set_least_trigger(double us) { least_us = us; }
    void set_burst(double us) { before_pulse_us = us; }
    // A line that is stuck is so at once; a pulse under way ends when the fault is over.
    void set_fault(Fault now);

    void processor_was_reset() { nesting.after_reset(); }

private:
    void triggered(bool level);
    void begin_pulse();
    void end_pulse();
    void drive(bool level);

    std::optional<double> distance_m = 1.0;
    double temperature_c = 20;
    double longest_us = longest_echo_us;
    double least_us = least_trigger_us;
    double before_pulse_us = burst_us;
    Fault fault = Fault::none;

    bool busy = false;
    double rose_us = 0;
    unsigned long pings = 0;

    InputPin *trigger;
    OutputPin *echo;
    Nesting nesting;
    Timer burst;
    Timer pulse;
    TextAttribute *distance_attribute;
};

} // namespace board
