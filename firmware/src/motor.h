/* Three motors, each on a pair of PWM pins of which never both are on. */
#ifndef MOTOR_H
#define MOTOR_H

#include <stdbool.h>
#include <stdint.h>

void motor_init(void);

/* Drive an axis with -255 .. 255 PWM steps. */
void motor_drive(uint8_t axis, int16_t duty);

/* All pins low and the amplifiers off, at once; safe from any interrupt. */
void motors_off(void);

void amplifiers_on(void);
bool amplifiers_are_on(void);

#endif
