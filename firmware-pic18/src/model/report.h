/* The lines that the ranger says, composed in line_buffer. Pure; docs/guide/board.md describes them. */
#ifndef MODEL_REPORT_H
#define MODEL_REPORT_H

#include <stdint.h>

#include "compiler.h"

/* "P <sequence> <echo_us, low or high> <status> <since_ms>*<checksum>" of ping and echo_us. */
void report_frame(void);

/* Of the same, as the thesis's program wrote it: steps of 2 cm; "?" when the line is stuck. */
void report_thesis(void);

/* An empty line: ends a line that was torn. */
void report_line_end(void);

/* "A <answer> <command byte in hexadecimal> <period_ms in force>*<checksum>" of the command. */
void report_answer(void);

/* "I <name> <version> <build> <reset cause>*<checksum>". */
void report_identity(uint8_t reset_cause) BYTE_IN_W;

#endif
