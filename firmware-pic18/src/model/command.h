/* Makes commands of the bytes that come in. Pure; which bytes there are says docs/protocol.csv. */
#ifndef MODEL_COMMAND_H
#define MODEL_COMMAND_H

#include <stdint.h>

#include "compiler.h"

/* So long may the digits of a period take; then what began is dropped, and the next byte is a command again. */
#define COMMAND_PATIENCE_MS 1000u

typedef struct {
    uint16_t period_ms; /* of a period command that is done */
    uint8_t byte;       /* which command */
    uint8_t answer;     /* ANSWER_... of protocol.h: done when it can be carried out */
} command_t;

extern command_t command;

void command_reset(void);

/* Takes a byte; returns 1 when a command is complete, right or wrong, in the global. */
uint8_t command_take(uint8_t byte) BYTE_IN_W;

/* Returns 1 when a command that began has waited too long; it is then in the global, with its answer. */
uint8_t command_overdue(void);

#endif
