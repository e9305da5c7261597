/* The local force field and how it comes, ages and fades. Forces have 1024 steps a PWM step. */
#ifndef FIELD_H
#define FIELD_H

#include <stdbool.h>
#include <stdint.h>

#include "protocol.h"

/* Position in counts and rate in 1/256 count/ms. */
struct motion {
    int16_t position[3];
    int16_t rate[3];
};

/* No force, and none remembered. */
void field_forget(void);

/* Take a legal field; its wrench comes in a ramp as long as the last field stood. */
void field_take(const struct field *field, const struct motion *motion);

/* Let a tick pass and give the force of the three axes. */
const int32_t *field_force(const struct motion *motion);

/* Tell whether a field is in force and not stale. */
bool field_is_fresh(void);

#endif
