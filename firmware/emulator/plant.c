#include <math.h>

#include "emulator.h"

void axis_step(struct axis *axis, double duty, double seconds)
{
    double felt = fmax(0.0, fabs(duty) - axis->dead_band);
    double force = copysign(felt, duty) * axis->per_duty * axis->motor;
    double mass = axis->mass + axis->hand_mass;

    force -= (axis->damping + axis->hand_damping) * axis->rate;
    force += axis->hand_stiffness * (axis->hand_reference - axis->position);
    if (axis->weight != 0.0)
        force += axis->weight * sin(axis->position / axis->lever);
    axis->rate += force / mass * seconds;
    axis->position += axis->rate * seconds;
    if (fabs(axis->position) > axis->travel) {
        axis->position = copysign(axis->travel, axis->position);
        axis->rate = 0.0;
    }
}

int32_t axis_count(const struct axis *axis)
{
    return (int32_t)floor(axis->position / axis->per_count + 0.5);
}
