#include "model/checksum.h"

uint8_t checksum_high;
uint8_t checksum_low;

void checksum_start(void)
{
    checksum_high = 0xFF;
    checksum_low = 0xFF;
}

/* A byte at a time without a table: the eight shifts of the definition, folded, on each half of the register. */
void checksum_add(uint8_t byte) BYTE_IN_W
{
    uint8_t x = checksum_high ^ byte;
    x ^= x >> 4;
    checksum_high = (uint8_t)(checksum_low ^ (uint8_t)(x << 4) ^ (x >> 3));
    checksum_low = (uint8_t)(x ^ (uint8_t)(x << 5));
}
