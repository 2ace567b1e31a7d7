// The line to the program that decides what the board meets: a UNIX stream socket, one text line per message.
//
// To the program:   port PATH                      the serial port is open under this path; waits for "go"
//                   ping NUMBER TIME_US TRIGGER_US the sensor was triggered; waits for "go"
//                   echo NUMBER PULSE_US           what came of it, to a microsecond
//                   refused TIME_US TRIGGER_US     a trigger too short for the sensor
//                   wake TIME_US                   the time that was asked for has come; waits for "go"
// From the program: what Board::obey of commands.cc takes, and "go" that lets the simulation run on. Without a program
// the modules' attributes decide. The end of the program is the end of the simulation.
#pragma once

#include <string>

namespace board {

class Driver {
public:
    // Connects; a failure is said on standard error and ends the simulation.
    void connect(const char *path);

    bool connected() const { return socket >= 0; }

    // Tells something. Without a program nothing happens.
    void tell(const char *format, ...) __attribute__((format(printf, 2, 3)));

    // Tells something and obeys until "go". A program that is silent for ten seconds is given up.
    void ask(const char *format, ...) __attribute__((format(printf, 2, 3)));

    // Obeys what has come, without waiting.
    void poll();

    void close();

private:
    bool receive(int wait_ms);
    bool next_line(std::string &line);
    void send_line(const std::string &line);

    int socket = -1;
    std::string received;
};

extern Driver driver;

} // namespace board
