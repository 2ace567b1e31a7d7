/* What an echo pulse means: status, LEDs, the thesis's units. Pure; times in microseconds. */
#ifndef MODEL_ECHO_H
#define MODEL_ECHO_H

#include <stdint.h>

/*
 * Echo time per centimetre of distance, there and back, in whole microseconds. Right in air of 13 degrees C
 * (c = 338.9 m/s), 1.2 % too long at 20 degrees C (58.27 us). It is the thesis's constant, kept so that its
 * mode and the LEDs read as the original did; frames carry the raw time, and the PC knows the temperature.
 */
#define ECHO_US_PER_CM 59u

/* The thesis reported steps of 2 cm. */
#define ECHO_CM_PER_THESIS_STEP 2u

/* The SRF04 measures from 3 cm on; nearer, its blanking decides how long the pulse is. */
#define ECHO_TOO_NEAR_US (3u * ECHO_US_PER_CM)

/*
 * Between the longest echo (18 ms says the data sheet, 18.4 ms took the thesis's 3.16 m) and the shortest pulse by
 * which a sensor of this family says that nothing answered (30 ms; the SRF04's takes 36 ms).
 */
#define ECHO_NO_ECHO_US 25000u

#define ECHO_MOST_LEDS 255u

/* The pulse that the functions speak of. */
extern uint16_t echo_us;

/* Its status when it began and ended: echo, no-echo or too-near; never stuck. */
uint8_t echo_status(void);

/* Its distance in whole centimetres. */
uint16_t echo_cm(void);

/* What the bar shows, as a binary number: whole centimetres, 255 for 255 and more. */
uint8_t echo_leds(void);

#endif
