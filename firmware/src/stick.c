#include "stick.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "config.h"
#include "motor.h"
#include "multiply.h"
#include "sine.h"

#define FASTEST 8191 /* 32 counts/ms: so the sum of three dampings fits 32 bits */

struct stick stick;

static int16_t clamp(int16_t value, int16_t limit)
{
    return value > limit ? limit : value < -limit ? -limit : value;
}

static void read_counts(int16_t count[3])
{
    struct encoder_reading reading;

    encoder_read(&reading);
    stick.glitches = reading.glitches;
    for (uint8_t i = 0; i < 3; i++)
        count[i] = config.encoder_sign[i] < 0 ? -reading.count[i]
                   : config.encoder_sign[i] ? reading.count[i] : 0;
}

void stick_settle(void)
{
    memset(&stick, 0, sizeof(stick));
    read_counts(stick.motion.position);
}

void stick_feel(void)
{
    int16_t count[3];

    read_counts(count);
    for (uint8_t i = 0; i < 3; i++) {
        int16_t difference = clamp(count[i] - stick.motion.position[i], FASTEST >> 8) * 256;
        int32_t change = multiply(difference - stick.motion.rate[i], config.rate_filter);

        stick.motion.rate[i] += (int16_t)((change + 128) >> 8);
        stick.motion.position[i] = count[i];
    }
}

/* Centring and gravity compensation, 1024 steps a PWM step. */
static int32_t own_force(uint8_t i)
{
    int16_t position = stick.motion.position[i];
    int32_t force = -multiply(config.centring_stiffness[i], position) -
                    (multiply(config.centring_damping[i], stick.motion.rate[i]) >> 3);

    if (config.gravity[i]) {
        uint16_t angle = multiply(position, derived.angle_per_count[i]) >> 8;

        force -= multiply(config.gravity[i], sine(angle)) >> 5;
    }
    return force;
}

/* To whole PWM steps, 1023 at most. */
static int16_t to_duty(int32_t force, uint16_t share)
{
    const int32_t most = 1023L << 10;

    force = force > most ? most : force < -most ? -most : force;
    return (multiply(force >> 5, share) + 4096) >> 13;
}

void stick_push(uint16_t share)
{
    const int32_t *force = field_force(&stick.motion);

    stick.signs = 0;
    for (uint8_t i = 0; i < 3; i++) {
        int16_t wanted = to_duty(force[i] + own_force(i), share);
        int16_t limited = clamp(wanted, config.force_limit[i]);
        int16_t change = limited - stick.motor[i];

        if (limited != wanted)
            stick.signs |= SIGN_SATURATED_X << i;
        if (abs(change) > config.slew_limit[i]) {
            stick.signs |= SIGN_SLEWING;
            change = clamp(change, config.slew_limit[i]);
        }
        stick.motor[i] += change;
        motor_drive(i, config.motor_sign[i] < 0 ? -stick.motor[i]
                       : config.motor_sign[i] ? stick.motor[i] : 0);
    }
}

void stick_let_go(void)
{
    motors_off();
    field_forget();
    memset(stick.motor, 0, sizeof(stick.motor));
    stick.signs = 0;
}
