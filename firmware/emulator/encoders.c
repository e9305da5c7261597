#include "inside.h"

/* Count 0, 1, 2, 3 is (A, B) = 00, 10, 11, 01. */
void encoder_show(struct encoder *encoder)
{
    int phase = encoder->count & 3;
    int a = (phase == 1 || phase == 2) ^ (encoder->flipped == 0);
    int b = (phase >= 2) ^ (encoder->flipped == 1);

    set_pin(encoder->emulator, encoder->port, encoder->a, a);
    set_pin(encoder->emulator, encoder->port, encoder->b, b);
}

bool encoder_step(struct encoder *encoder, int32_t target)
{
    if (encoder->count == target)
        return false;
    encoder->count += encoder->count < target ? 1 : -1;
    encoder_show(encoder);
    return encoder->count != target;
}

static avr_cycle_count_t on_edge(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct encoder *encoder = param;

    return encoder_step(encoder, encoder->target) ? when + encoder->period : 0;
}

static avr_cycle_count_t on_glitch_end(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct encoder *encoder = param;

    encoder->flipped = -1;
    encoder_show(encoder);
    return 0;
}

void emulator_turn(struct emulator *emulator, int axis, int32_t count, double edges_per_second)
{
    struct encoder *encoder = &emulator->encoders[axis];

    encoder->target = count;
    encoder->period = (uint32_t)(HERTZ / edges_per_second);
    avr_cycle_timer_register(emulator->avr, encoder->period, on_edge, encoder);
}

bool emulator_is_turning(const struct emulator *emulator, int axis)
{
    void *encoder = (void *)&emulator->encoders[axis];

    return avr_cycle_timer_status(emulator->avr, on_edge, encoder) != 0;
}

int32_t emulator_count(const struct emulator *emulator, int axis)
{
    return emulator->encoders[axis].count;
}

void emulator_glitch(struct emulator *emulator, int axis, int line, uint32_t cycles)
{
    struct encoder *encoder = &emulator->encoders[axis];

    encoder->flipped = line;
    encoder_show(encoder);
    avr_cycle_timer_register(emulator->avr, cycles, on_glitch_end, encoder);
}

void emulator_jump(struct emulator *emulator, int axis)
{
    avr_t *avr = emulator->avr;
    uint8_t enabled = avr->sreg[S_I];

    /* Seen by no instruction between the two lines. */
    avr->sreg[S_I] = 0;
    emulator->encoders[axis].count += 2;
    encoder_show(&emulator->encoders[axis]);
    avr->sreg[S_I] = enabled;
}
