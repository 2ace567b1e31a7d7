/* CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, neither reflected nor inverted; "123456789" gives 0x29B1. */
#ifndef MODEL_CHECKSUM_H
#define MODEL_CHECKSUM_H

#include <stdint.h>

#include "compiler.h"

/* The checksum of all bytes since the start. */
extern uint8_t checksum_high;
extern uint8_t checksum_low;

void checksum_start(void);
void checksum_add(uint8_t byte) BYTE_IN_W;

#endif
