// The far end of the serial line, 8N1, on a pseudo-terminal: pins RX (from the PIC) and TX (to it). Keeps the simulation
// to real time, too, because it looks at the clock every simulated millisecond anyway.
#pragma once

#include <deque>
#include <string>

#include "simulation.h"

namespace board {

class PtyUart : public Module {
public:
    explicit PtyUart(const char *name);
    ~PtyUart() override;
    static Module *construct(const char *name);

    // The one on the board, if it is there.
    static PtyUart *instance;

    void set_baud(double rate) { bit_us = 1e6 / rate; }
    void set_pace(double factor);
    void silence(double us) { silent_until_us = now_us() + us; }
    void garble(int count);

private:
    void open(const char *link);
    void close();

    void level_changed(bool level);
    void sample();
    void take(unsigned char byte);
    void write_byte(unsigned char byte);

    void read_bytes();
    void send_bit();

    void tick();
    void keep_pace();

    int master = -1;
    int slave = -1;
    std::string link_path;

    double bit_us = 1e6 / 19200;
    double silent_until_us = 0;
    bool reader_absent = false;
    unsigned garbage_seed = 1;

    // Receiving: the number of the bit that is sampled next, 0 for the start bit; -1 between bytes.
    int in_bit = -1;
    bool in_level = true;
    unsigned in_shift = 0;
    // Sending.
    std::deque<unsigned char> waiting;
    int out_bits = 0;
    unsigned out_shift = 0;

    double pace = 0;
    double wall_start_s = 0;
    double simulated_start_s = 0;

    InputPin *rx;
    OutputPin *tx;
    Timer sampler;
    Timer sender;
    Timer ticker;
    TextAttribute *link_attribute;
    TextAttribute *pace_attribute;
};

} // namespace board
