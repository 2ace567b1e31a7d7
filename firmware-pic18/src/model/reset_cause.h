/* Why the processor started. Pure. */
#ifndef MODEL_RESET_CAUSE_H
#define MODEL_RESET_CAUSE_H

#include <stdint.h>

/*
 * Decodes the registers RCON and STKPTR as they are after a reset (data sheet DS39599, table 5-3); returns RESET_... of
 * protocol.h. RCON's flags are active low, and the program sets them again for the next time.
 */
uint8_t reset_cause(uint8_t rcon, uint8_t stkptr);

#endif
