#include "tests.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "model/line.h"
#include "protocol.h"

void for_each_row(const char *name, void (*check)(char **fields, int count))
{
    char path[512];
    char row[512];
    char *fields[8];
    int rows = 0;
    snprintf(path, sizeof path, "%s/%s", getenv("VECTORS"), name);
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    while (fgets(row, sizeof row, file)) {
        int count = 0;
        char *rest = row;
        row[strcspn(row, "\n")] = '\0';
        if (row[0] == '#' || rows++ == 0) {
            continue;
        }
        while (rest && count < 8) {
            fields[count++] = strsep(&rest, ",");
        }
        check(fields, count);
    }
    fclose(file);
    assert_true(rows > 10);
}

uint8_t status_of(const char *word)
{
    static const uint8_t all[] = {STATUS_ECHO, STATUS_NO_ECHO, STATUS_STUCK, STATUS_TOO_NEAR};
    for (size_t i = 0; i < sizeof all; i++) {
        if (strcmp(&words[all[i]], word) == 0) {
            return all[i];
        }
    }
    fail_msg("no status '%s'", word);
    return 0;
}

const char *line_text(void)
{
    static char text[LINE_MOST + 1];
    memcpy(text, line_buffer, line_length);
    text[line_length] = '\0';
    return text;
}

int main(void)
{
    return model_tests() + hal_tests() + ranger_tests() ? 1 : 0;
}
