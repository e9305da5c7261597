#ifndef SINE_H
#define SINE_H

#include <stdint.h>

/* Sine of an angle of 65536 steps a turn, as 32767 steps a unit; wrong by at most 3 steps. */
int16_t sine(uint16_t angle);

#endif
