// What the modules need of gpsim: time, timers and pins.
#pragma once

#define IN_MODULE
#include <functional>

#include <gpsim/gpsim_time.h>
#include <gpsim/modules.h>
#include <gpsim/stimuli.h>
#include <gpsim/trigger.h>
#include <gpsim/value.h>

namespace board {

// Simulated time since the start, in microseconds. The ranger runs at 4 MHz, so that an instruction cycle is one; gpsim
// itself would count its first few cycles, before the program has set the oscillator, at another rate.
inline double now_us()
{
    return static_cast<double>(get_cycles().get());
}

// Calls back once, after a simulated time.
class Timer : public TriggerObject {
public:
    explicit Timer(std::function<void()> callback) : call(std::move(callback)) {}

    ~Timer() override { stop(); }

    // Starts the time anew when it is running already.
    void start(double delay_us)
    {
        stop();
        // The clock cannot call back in the cycle that it is in.
        due = get_cycles().get() + (delay_us < 1 ? 1 : static_cast<guint64>(delay_us + 0.5));
        get_cycles().set_break(due, this);
    }

    void stop()
    {
        if (due) {
            get_cycles().clear_break(this);
            due = 0;
        }
    }

    void callback() override
    {
        due = 0;
        call();
    }

private:
    std::function<void()> call;
    guint64 due = 0;
};

// A pin that tells when its level changes.
class InputPin : public IO_bi_directional_pu {
public:
    InputPin(const char *name, bool idle, std::function<void(bool)> listener)
        : IO_bi_directional_pu(name), listen(std::move(listener))
    {
        bDrivenState = idle;
        update_direction(0, true);
        bPullUp = idle;
        Zpullup = idle ? 10e3 : 1e9;
        Vpullup = idle ? 5 : 0;
    }

    void setDrivenState(bool level) override
    {
        bool changed = level != bDrivenState;
        IOPIN::setDrivenState(level);
        if (changed) {
            listen(level);
        }
    }

private:
    std::function<void(bool)> listen;
};

// A pin that is driven.
class OutputPin : public IO_bi_directional {
public:
    OutputPin(const char *name, bool idle) : IO_bi_directional(name)
    {
        bDrivingState = idle;
        update_direction(1, true);
    }

    void drive(bool level)
    {
        setDrivingState(level);
        updateNode();
    }
};

// An attribute of a module that can be given a text in gpsim's scripts. gpsim sets an attribute twice for one
// assignment: the second time is passed over.
class TextAttribute : public String {
public:
    TextAttribute(const char *name, const char *description, std::function<void(const char *)> taker)
        : String(name, "", description), take(std::move(taker))
    {
    }

    void set(const char *text, int length) override
    {
        String::set(text, length);
        pass_on();
    }

    void set(Value *value) override
    {
        String::set(value);
        pass_on();
    }

private:
    void pass_on()
    {
        if (taken != getVal()) {
            taken = getVal();
            take(getVal());
        }
    }

    std::function<void(const char *)> take;
    std::string taken;
};

} // namespace board
