#include "driver.h"

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "commands.h"

namespace board {

Driver driver;

namespace {

constexpr int patience_ms = 10000;

// More than any message takes: who sends so much without a line end speaks another language.
constexpr size_t longest_line = 200;

std::string formatted(const char *format, va_list arguments)
{
    char line[longest_line];
    vsnprintf(line, sizeof line, format, arguments);
    return line;
}

} // namespace

void Driver::connect(const char *path)
{
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (strlen(path) >= sizeof address.sun_path) {
        fprintf(stderr, "board: %s: longer than a socket's path may be\n", path);
        halt();
        return;
    }
    strcpy(address.sun_path, path);
    socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
    if (socket < 0 || ::connect(socket, reinterpret_cast<sockaddr *>(&address), sizeof address)) {
        fprintf(stderr, "board: %s: %s\n", path, strerror(errno));
        close();
    }
}

void Driver::close()
{
    if (socket >= 0) {
        ::close(socket);
        socket = -1;
    }
    received.clear();
    halt();
}

void Driver::send_line(const std::string &line)
{
    std::string rest = line + "\n";
    while (connected() && !rest.empty()) {
        ssize_t sent = ::send(socket, rest.data(), rest.size(), MSG_NOSIGNAL);
        if (sent > 0) {
            rest.erase(0, static_cast<size_t>(sent));
        } else if (errno != EINTR) {
            close();
        }
    }
}

void Driver::tell(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    send_line(formatted(format, arguments));
    va_end(arguments);
}

void Driver::ask(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    send_line(formatted(format, arguments));
    va_end(arguments);
    while (connected()) {
        std::string line;
        if (next_line(line)) {
            if (line == "go") {
                return;
            }
            obey(line);
        } else if (!receive(patience_ms)) {
            fprintf(stderr, "board: no answer in %d s\n", patience_ms / 1000);
            close();
        }
    }
}

void Driver::poll()
{
    std::string line;
    while (connected() && (next_line(line) || (receive(0) && next_line(line)))) {
        obey(line);
    }
}

// Takes what has come; false when nothing came in time.
bool Driver::receive(int wait_ms)
{
    pollfd ready = {socket, POLLIN, 0};
    int count = ::poll(&ready, 1, wait_ms);
    if (count < 0 && errno == EINTR) {
        return true;
    }
    if (count <= 0) {
        return false;
    }
    char bytes[1024];
    ssize_t size = recv(socket, bytes, sizeof bytes, MSG_DONTWAIT);
    if (size > 0) {
        received.append(bytes, static_cast<size_t>(size));
    } else {
        close();
    }
    return true;
}

bool Driver::next_line(std::string &line)
{
    size_t end = received.find('\n');
    if (end == std::string::npos) {
        if (received.size() > longest_line) {
            fprintf(stderr, "board: a message of more than %zu characters\n", longest_line);
            close();
        }
        return false;
    }
    line = received.substr(0, end);
    received.erase(0, end + 1);
    return true;
}

} // namespace board
