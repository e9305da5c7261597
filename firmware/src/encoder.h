/* Three quadrature encoders, counted by interrupt at every edge. */
#ifndef ENCODER_H
#define ENCODER_H

#include <stdint.h>

struct encoder_reading {
    int16_t count[3];
    uint8_t glitches;
};

void encoder_init(void);

/* Give all counts and the illegal steps so far (modulo 256), taken at one moment. */
void encoder_read(struct encoder_reading *reading);

void encoder_zero(void);

#endif
