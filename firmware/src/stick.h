/* The stick: what it feels, and the force that comes of it, tick by tick. */
#ifndef STICK_H
#define STICK_H

#include "encoder.h"
#include "field.h"

/* What the last tick gave, for telemetry. */
struct stick {
    struct motion motion;
    int16_t motor[3];
    uint8_t signs;    /* SATURATED and SLEWING */
    uint8_t glitches; /* so far, modulo 256 */
};

extern struct stick stick;

/* Begin at rest, with the counts as they are. */
void stick_settle(void);

/* Read the encoders and filter the rates. */
void stick_feel(void);

/* Drive the motors with `share` (0 .. 256) of the force of centring, gravity and field. */
void stick_push(uint16_t share);

/* Motors and amplifiers off at once, the field forgotten. */
void stick_let_go(void);

#endif
