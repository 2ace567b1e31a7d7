/* A pseudo-terminal for tests: prints its path, then passes on what comes from either side until its input ends. */
#include <poll.h>
#include <pty.h>
#include <stdio.h>
#include <termios.h>
#include <unistd.h>

int main(void)
{
    int master, slave;
    struct termios raw;
    char name[256], bytes[4096];

    if (openpty(&master, &slave, name, NULL, NULL) != 0) {
        return 1;
    }
    /* The slave stays open here: readers may come and go. */
    tcgetattr(slave, &raw);
    cfmakeraw(&raw);
    tcsetattr(slave, TCSANOW, &raw);
    printf("%s\n", name);
    fflush(stdout);
    struct pollfd sides[] = {{0, POLLIN, 0}, {master, POLLIN, 0}};
    while (poll(sides, 2, -1) >= 0) {
        for (int i = 0; i < 2; i++) {
            if (sides[i].revents) {
                ssize_t n = read(sides[i].fd, bytes, sizeof bytes);
                if (n <= 0 || write(i ? 1 : master, bytes, n) != n) {
                    return 0;
                }
            }
        }
    }
    return 0;
}
