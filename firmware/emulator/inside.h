/* What the emulator's own files share. */
#ifndef INSIDE_H
#define INSIDE_H

#include "emulator.h"

#include <simavr/sim_cycle_timers.h>
#include <simavr/sim_elf.h>

#define HERTZ 16000000.0
#define LINE_SIZE (1 << 20)

struct line {
    uint8_t bytes[LINE_SIZE];
    uint32_t head, tail;
};

struct encoder {
    struct emulator *emulator;
    int axis;
    char port;
    int a, b;        /* bits of the port */
    int32_t count;   /* as the lines show it */
    int32_t target;
    uint32_t period; /* cycles an edge; 0: follows the mechanism */
    int flipped;     /* line under a glitch, or -1 */
};

struct wires {
    uint8_t driven, high;
};

struct emulator {
    avr_t *avr;
    elf_firmware_t firmware;
    struct axis axes[AXES];
    struct encoder encoders[AXES];
    struct line in, out;
    struct wires wires['L' - 'A' + 1];
    bool estop, dead_man;
    int greatest;
    uint32_t overlaps;
    uint32_t hung_at;
    uint8_t healthy[2], healthy_start[2];
    bool start_hangs;
};

/* Drive a pin of the board with a wire. */
void set_pin(struct emulator *emulator, char port, int bit, int level);

/* Put an encoder's lines as its count has them. */
void encoder_show(struct encoder *encoder);

/* Let an encoder make one step; false when it is there. */
bool encoder_step(struct encoder *encoder, int32_t target);

/* Watch the motors' pins from now on. */
void motors_watch(struct emulator *emulator);

#endif
