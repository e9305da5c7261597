#include "field.h"

#include <string.h>

#include "multiply.h"

/* force = offset - stiffness·position - damping·rate. The wrench and the point it is about are in
 * the offset, which alone is ramped: the hand feels no step, not even when stiffness changes. */
static struct {
    int16_t stiffness[9];
    int16_t damping[9];
    int32_t offset[3];
    int32_t target[3];
    int32_t step[3];
    int32_t force[3]; /* of the last tick */
    uint8_t ramp;     /* ticks until the offset is at its target */
    uint8_t valid;    /* ticks until the field is stale */
    uint8_t fade;     /* ticks that a stale field takes to fade */
    uint8_t since;    /* ticks since the last field, 255 at most */
    bool pushing;     /* a field is in force and not stale */
} now;

void field_forget(void)
{
    memset(&now, 0, sizeof(now));
    now.since = UINT8_MAX;
}

/* A division of 32 bits would take 640 cycles an axis; what the reciprocal gets wrong, half a percent
 * at most, the ramp's last tick makes good. */
static void ramp_over(uint8_t ticks)
{
    int16_t reciprocal = (0x7FFFU + ticks / 2) / ticks;

    if (reciprocal < 0)
        reciprocal = 0x7FFF;
    for (uint8_t i = 0; i < 3; i++) {
        int32_t whole = now.target[i] - now.offset[i];
        int32_t high = multiply(whole >> 16, reciprocal);
        int32_t low = multiply((uint16_t)whole >> 1, reciprocal);

        now.step[i] = (high << 1) + (low >> 14);
    }
    now.ramp = ticks;
}

/* Stiffness·position + damping·rate of one row. */
static int32_t hold(const int16_t *stiffness, const int16_t *damping, const struct motion *motion)
{
    return dot3(stiffness, motion->position) + (dot3(damping, motion->rate) >> 3);
}

void field_take(const struct field *field, const struct motion *motion)
{
    uint8_t ticks = now.since < field->valid_for ? now.since : field->valid_for;

    for (uint8_t i = 0; i < 3; i++) {
        const int16_t *row = &field->stiffness[3 * i];

        now.target[i] = ((int32_t)field->wrench[i] << 5) + (dot3(row, field->about) >> 3);
        /* The force goes on from what it was at the last tick. */
        now.offset[i] = now.force[i] + hold(row, &field->damping[3 * i], motion);
    }
    memcpy(now.stiffness, field->stiffness, sizeof(now.stiffness));
    memcpy(now.damping, field->damping, sizeof(now.damping));
    now.pushing = true;
    now.valid = now.fade = field->valid_for;
    now.since = 0;
    ramp_over(ticks ? ticks : 1);
}

/* From here the force fades, from what it is to nothing, over as long as the field was valid. */
static void go_stale(void)
{
    memset(now.stiffness, 0, sizeof(now.stiffness));
    memset(now.damping, 0, sizeof(now.damping));
    memset(now.target, 0, sizeof(now.target));
    memcpy(now.offset, now.force, sizeof(now.offset));
    now.pushing = false;
    ramp_over(now.fade);
}

static void age(void)
{
    if (now.since != UINT8_MAX)
        now.since++;
    if (now.pushing) {
        if (now.valid)
            now.valid--;
        else
            go_stale();
    }
    if (now.ramp && --now.ramp)
        for (uint8_t i = 0; i < 3; i++)
            now.offset[i] += now.step[i];
    else
        memcpy(now.offset, now.target, sizeof(now.offset));
}

const int32_t *field_force(const struct motion *motion)
{
    age();
    memcpy(now.force, now.offset, sizeof(now.force));
    if (now.pushing)
        for (uint8_t i = 0; i < 3; i++)
            now.force[i] -= hold(&now.stiffness[3 * i], &now.damping[3 * i], motion);
    return now.force;
}

bool field_is_fresh(void)
{
    return now.pushing;
}
