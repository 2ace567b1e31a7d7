/* What the files of the host tests share. */
#ifndef TESTS_H
#define TESTS_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
/* After those that it asks for. */
#include <cmocka.h>

int model_tests(void);
int hal_tests(void);
int ranger_tests(void);

/* Reads a csv file under test/vectors row by row; lines with # and the header are left out. */
void for_each_row(const char *name, void (*check)(char **fields, int count));

/* The code of a status word of the protocol, as the firmware has it. */
uint8_t status_of(const char *word);

/* line_buffer as a text of C. */
const char *line_text(void);

#endif
