#include "pty_uart.h"

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <poll.h>
#include <pty.h>
#include <termios.h>
#include <unistd.h>

#include "commands.h"
#include "driver.h"
#include "transmitter.h"

namespace board {

PtyUart *PtyUart::instance = nullptr;

namespace {

constexpr double tick_us = 1000;
constexpr int stop_bit = 9;

// What a program may write ahead of the line; more waits in the pseudo-terminal.
constexpr size_t most_waiting = 256;

// So long may a reader leave the pseudo-terminal full before it counts as absent.
constexpr int reader_patience_ms = 500;

// Further behind than this (a stopped process, a suspended machine), the lost time is not made up for.
constexpr double most_behind_s = 0.5;

double wall_s()
{
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) * 1e-9;
}

void sleep_s(double duration_s)
{
    timespec time{};
    time.tv_sec = static_cast<time_t>(duration_s);
    time.tv_nsec = static_cast<long>((duration_s - static_cast<double>(time.tv_sec)) * 1e9);
    nanosleep(&time, nullptr);
}

// A link that is there at once or not at all, whatever stood there before.
bool place_link(const char *target, const std::string &path)
{
    std::string beside = path + ".new";
    unlink(beside.c_str());
    return symlink(target, beside.c_str()) == 0 && rename(beside.c_str(), path.c_str()) == 0;
}

} // namespace

PtyUart::PtyUart(const char *name)
    : Module(name, "serial port on a pseudo-terminal"),
      rx(new InputPin("RX", true, [this](bool level) { level_changed(level); })),
      tx(new OutputPin("TX", true)),
      sampler([this] { sample(); }),
      sender([this] { send_bit(); }),
      ticker([this] { tick(); }),
      link_attribute(
          new TextAttribute("link", "path of a link to the pseudo-terminal", [this](const char *path) { open(path); })),
      pace_attribute(new TextAttribute("pace", "simulated per real second, 0: unlimited", [this](const char *factor) {
          set_pace(strtod(factor, nullptr));
      }))
{
    create_pkg(2);
    // The module's symbol table deletes them.
    addSymbol(rx);
    addSymbol(tx);
    addSymbol(link_attribute);
    addSymbol(pace_attribute);
    assign_pin(1, rx);
    assign_pin(2, tx);
    instance = this;
    ticker.start(tick_us);
    // gpsim ends without deleting its modules.
    std::atexit([] {
        if (instance) {
            instance->close();
        }
    });
}

PtyUart::~PtyUart()
{
    close();
    instance = nullptr;
}

Module *PtyUart::construct(const char *name)
{
    return new PtyUart(name ? name : "ptyuart");
}

// ---------------------------------------------------------------- the pseudo-terminal

void PtyUart::open(const char *path)
{
    char device[256];
    if (openpty(&master, &slave, device, nullptr, nullptr)) {
        fprintf(stderr, "board: no pseudo-terminal: %s\n", strerror(errno));
        halt();
        return;
    }
    // The slave stays open, raw: readers may come and go, and nothing echoes back.
    termios mode{};
    tcgetattr(slave, &mode);
    cfmakeraw(&mode);
    tcsetattr(slave, TCSANOW, &mode);
    fcntl(master, F_SETFL, O_NONBLOCK);
    if (!place_link(device, path)) {
        fprintf(stderr, "board: %s: %s\n", path, strerror(errno));
        halt();
        return;
    }
    link_path = path;
    printf("board: serial port %s\n", path);
    fflush(stdout);
    driver.ask("port %s", path);
}

void PtyUart::close()
{
    if (!link_path.empty()) {
        unlink(link_path.c_str());
        link_path.clear();
    }
    if (master >= 0) {
        ::close(master);
        ::close(slave);
        master = slave = -1;
    }
}

// A reader that is only slow is waited for, since the simulation can run faster than anybody reads; where nobody reads,
// what waits is thrown away, as on a line that leads nowhere.
void PtyUart::write_byte(unsigned char byte)
{
    if (master < 0) {
        return;
    }
    if (write(master, &byte, 1) == 1) {
        reader_absent = false;
        return;
    }
    pollfd writable = {master, POLLOUT, 0};
    if (!reader_absent && poll(&writable, 1, reader_patience_ms) > 0 && write(master, &byte, 1) == 1) {
        return;
    }
    reader_absent = true;
    tcflush(slave, TCIFLUSH);
}

void PtyUart::read_bytes()
{
    unsigned char bytes[64];
    if (master < 0 || waiting.size() > most_waiting - sizeof bytes) {
        return;
    }
    ssize_t count = read(master, bytes, sizeof bytes);
    if (count > 0) {
        waiting.insert(waiting.end(), bytes, bytes + count);
        if (out_bits == 0) {
            send_bit();
        }
    }
}

void PtyUart::garble(int count)
{
    for (int i = 0; i < count; i++) {
        // Not rand(), which belongs to gpsim; numbers of Park and Miller (1988).
        garbage_seed = static_cast<unsigned>(garbage_seed * 48271ULL % 2147483647ULL);
        write_byte(static_cast<unsigned char>(garbage_seed >> 8));
    }
}

// ---------------------------------------------------------------- from the PIC

void PtyUart::level_changed(bool level)
{
    in_level = level;
    if (in_bit < 0 && !level) {
        in_bit = 0;
        in_shift = 0;
        sampler.start(bit_us / 2);
    }
}

// In the middle of a bit.
void PtyUart::sample()
{
    if (in_bit == 0 && in_level) {
        // No start bit, only a spike.
        in_bit = -1;
        return;
    }
    if (in_bit == stop_bit) {
        in_bit = -1;
        if (in_level) {
            take(static_cast<unsigned char>(in_shift));
        }
        // Without its stop bit a byte is dropped: a pseudo-terminal cannot carry framing errors.
        return;
    }
    if (in_bit > 0) {
        in_shift |= static_cast<unsigned>(in_level) << (in_bit - 1);
    }
    in_bit++;
    sampler.start(bit_us);
}

void PtyUart::take(unsigned char byte)
{
    if (now_us() >= silent_until_us) {
        write_byte(byte);
    }
}

// ---------------------------------------------------------------- to the PIC

void PtyUart::send_bit()
{
    if (out_bits == 0) {
        if (waiting.empty()) {
            return;
        }
        // Start bit, eight bits from the least on, stop bit.
        out_shift = static_cast<unsigned>(waiting.front()) << 1 | 0x200U;
        out_bits = 10;
        waiting.pop_front();
    }
    tx->drive(out_shift & 1U);
    out_shift >>= 1;
    out_bits--;
    sender.start(bit_us);
}

// ---------------------------------------------------------------- time

void PtyUart::tick()
{
    driver.poll();
    halt_if_ending();
    wake_transmitter();
    read_bytes();
    keep_pace();
    ticker.start(tick_us);
}

void PtyUart::set_pace(double factor)
{
    pace = factor;
    wall_start_s = wall_s();
    simulated_start_s = now_us() * 1e-6;
}

void PtyUart::keep_pace()
{
    if (pace <= 0) {
        return;
    }
    double ahead_s = (now_us() * 1e-6 - simulated_start_s) / pace - (wall_s() - wall_start_s);
    if (ahead_s < -most_behind_s) {
        set_pace(pace);
    } else if (ahead_s > 0) {
        sleep_s(ahead_s);
    }
}

} // namespace board
