#include "commands.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <sstream>

#include <gpsim/16bit-processors.h>
#include <gpsim/breakpoints.h>

#include "driver.h"
#include "pty_uart.h"
#include "srf04.h"

namespace board {

namespace {

const std::map<std::string, Fault> faults = {
    {"none", Fault::none}, {"no-echo", Fault::no_echo}, {"high", Fault::high}, {"low", Fault::low}};

const std::map<std::string, RESET_TYPE> resets = {{"power-on", POR_RESET},
                                                  {"brown-out", BOD_RESET},
                                                  {"watchdog", WDT_RESET},
                                                  {"master-clear", MCLR_RESET}};

RESET_TYPE reset_asked_for = MCLR_RESET;

bool ending = false;

// gpsim knows no brown-out of this processor, and after its power-on in the middle of a byte the serial port stays
// silent: both are a reset of another cause, with the flags that tell of them.
void reset_now()
{
    auto *cpu = dynamic_cast<_16bit_processor *>(get_active_cpu());
    bool of_gpsim = reset_asked_for == MCLR_RESET || reset_asked_for == WDT_RESET;
    cpu->reset(of_gpsim ? reset_asked_for : MCLR_RESET);
    unsigned flags = cpu->rcon.value.get();
    if (reset_asked_for == BOD_RESET) {
        cpu->rcon.value.put(flags & ~RCON::BOR);
    } else if (reset_asked_for == POR_RESET) {
        cpu->rcon.value.put((flags | RCON::RI | RCON::TO | RCON::PD) & ~(RCON::POR | RCON::BOR));
    }
    if (Srf04::instance) {
        Srf04::instance->processor_was_reset();
    }
}

// Timers live as long as the process: gpsim's clock may be gone before its modules.
Timer &reset_timer()
{
    static Timer *timer = new Timer([] { reset_now(); });
    return *timer;
}

Timer &wake_timer()
{
    static Timer *timer = new Timer([] { driver.ask("wake %.0f", now_us()); });
    return *timer;
}

void complain(const std::string &line)
{
    fprintf(stderr, "board: what is '%s'?\n", line.c_str());
}

// True when all of the text is a number, and not below the least.
bool number(const std::string &text, double least, double &value)
{
    char *end = nullptr;
    value = strtod(text.c_str(), &end);
    return !text.empty() && *end == '\0' && std::isfinite(value) && value >= least;
}

bool obey_sensor(Srf04 &sensor, const std::string &key, const std::string &text)
{
    double value = 0;
    if (key == "distance" && text == "none") {
        sensor.set_distance(std::nullopt);
    } else if (key == "distance" && number(text, 0, value)) {
        sensor.set_distance(value);
    } else if (key == "temperature" && number(text, -273, value)) {
        sensor.set_temperature(value);
    } else if (key == "longest" && number(text, 0, value)) {
        sensor.set_longest(value);
    } else if (key == "trigger" && number(text, 0, value)) {
        sensor.set_least_trigger(value);
    } else if (key == "burst" && number(text, 1, value)) {
        sensor.set_burst(value);
    } else if (key == "fault" && faults.count(text)) {
        sensor.set_fault(faults.at(text));
    } else {
        return false;
    }
    return true;
}

bool obey_port(PtyUart &port, const std::string &key, const std::string &text)
{
    double value = 0;
    if (!number(text, 0, value)) {
        return false;
    }
    if (key == "garbage") {
        port.garble(static_cast<int>(std::fmin(value, 1000)));
    } else if (key == "baud" && value >= 1) {
        port.set_baud(value);
    } else if (key == "silence") {
        port.silence(value);
    } else if (key == "pace") {
        port.set_pace(value);
    } else {
        return false;
    }
    return true;
}

bool obey_time(const std::string &key, const std::string &text, const std::string &more)
{
    double value = 0;
    if (key == "stop") {
        halt();
    } else if (key == "wake" && number(text, 0, value)) {
        wake_timer().start(value - now_us());
    } else if (key == "reset" && resets.count(text) && number(more, 0, value)) {
        reset_asked_for = resets.at(text);
        reset_timer().start(value);
    } else {
        return false;
    }
    return true;
}

} // namespace

void obey(const std::string &line)
{
    std::istringstream words(line);
    std::string key, text, more;
    words >> key >> text >> more;
    bool done = (Srf04::instance && obey_sensor(*Srf04::instance, key, text)) ||
                (PtyUart::instance && obey_port(*PtyUart::instance, key, text)) || obey_time(key, text, more);
    if (!done) {
        complain(line);
    }
}

void halt()
{
    ending = true;
    get_bp().halt();
}

void halt_if_ending()
{
    if (ending) {
        halt();
    }
}

} // namespace board
