/* The stick's board on an emulated ATmega2560, with the mechanism behind it. Time is in cycles of
 * 16 MHz; nothing here knows of wall time. */
#ifndef EMULATOR_H
#define EMULATOR_H

#include <simavr/sim_avr.h>
#include <stdbool.h>
#include <stdint.h>

#define AXES 3
#define PLANT_CYCLES 800 /* 20 kHz */

/* One axis in SI at the handle; set by `emulator_set` in this order. */
struct axis {
    double mass, damping;           /* kg, N s/m */
    double weight, lever;           /* N and m: the handle topples with weight sin(position/lever) */
    double per_count, per_duty;     /* m a count, N a PWM step */
    double travel;                  /* m, to the stop */
    double dead_band;               /* PWM steps that no force comes of */
    double hand_stiffness, hand_damping, hand_mass, hand_reference;
    double motor;                   /* 1 sound, 0 dead, -1 turned round */
    double encoder;                 /* 1 sound, 0 frozen, -1 turned round */
    double position, rate;          /* m, m/s */
    double moving;                  /* 1: the mechanism moves; 0: only `emulator_turn` moves it */
};

void axis_step(struct axis *axis, double duty, double seconds);
int32_t axis_count(const struct axis *axis);

struct emulator;

struct emulator *emulator_new(const char *elf);
void emulator_free(struct emulator *emulator);

/* Run so many cycles; false when the processor crashed. */
bool emulator_run(struct emulator *emulator, uint64_t cycles);
uint64_t emulator_cycle(const struct emulator *emulator);

/* Serial line: bytes wait at the host's end until the line has carried them. */
void emulator_write(struct emulator *emulator, const uint8_t *bytes, uint32_t length);
uint32_t emulator_read(struct emulator *emulator, uint8_t *bytes, uint32_t most);
uint32_t emulator_waiting(const struct emulator *emulator);

void emulator_set(struct emulator *emulator, int axis, int which, double value);
double emulator_get(const struct emulator *emulator, int axis, int which);

/* Turn an encoder to a count at so many edges a second, whatever the mechanism does. */
void emulator_turn(struct emulator *emulator, int axis, int32_t count, double edges_per_second);
bool emulator_is_turning(const struct emulator *emulator, int axis);
int32_t emulator_count(const struct emulator *emulator, int axis);

/* Flip line A (0) or B (1) of an encoder for so many cycles. */
void emulator_glitch(struct emulator *emulator, int axis, int line, uint32_t cycles);

/* Turn an encoder by two counts at once, as when a step was lost. */
void emulator_jump(struct emulator *emulator, int axis);

/* Contacts on the board. */
void emulator_estop(struct emulator *emulator, bool pressed);
void emulator_dead_man(struct emulator *emulator, bool held);
bool emulator_enabled(const struct emulator *emulator);

/* A pin's duty, 0 .. 255: pin 0 .. 5 are D6 .. D11. */
int emulator_duty(const struct emulator *emulator, int pin);

/* Since the last asking: the greatest duty of any pin, and how often both pins of a pair were on. */
int emulator_greatest_duty(struct emulator *emulator);
uint32_t emulator_overlaps(struct emulator *emulator);

/* Reset the processor as a brown-out does: registers and pins anew, EEPROM kept. */
void emulator_brown_out(struct emulator *emulator);

/* Let the program jump for ever to where it is, with interrupts or without; then put it right. */
void emulator_hang(struct emulator *emulator, bool interrupts);

/* Let it hang at its very start too, until it is put right. */
void emulator_hang_at_start(struct emulator *emulator);
void emulator_heal(struct emulator *emulator);

void emulator_eeprom(struct emulator *emulator, uint16_t address, uint8_t *bytes, uint16_t length, bool write);

#endif
