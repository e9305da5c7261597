/* Written by firmware/protocol/make.py from firmware/protocol/description.yaml. */
#ifndef PROTOCOL_H
#define PROTOCOL_H

#include <stdbool.h>
#include <stdint.h>

#define PROTOCOL_VERSION 1
#define BAUD 500000UL
#define TICK_HZ 1000
#define LONGEST_PAYLOAD 96
#define ARM_KEY 0x464f5243UL
#define FULL_DUTY 0xffUL
#define CYCLES_PER_TICK 0x3e80UL

enum {
    STATE_IDLE = 0x0,
    STATE_RISING = 0x1,
    STATE_FORCE = 0x2,
    STATE_FADING = 0x3,
    STATE_FAULT = 0x4,
};

enum {
    OUTCOME_DONE = 0x0,
    OUTCOME_UNKNOWN = 0x1,
    OUTCOME_ILLEGAL = 0x2,
    OUTCOME_NOT_NOW = 0x3,
    OUTCOME_WRONG_KEY = 0x4,
    OUTCOME_ESTOP = 0x5,
    OUTCOME_DEAD_MAN = 0x6,
    OUTCOME_FAULTY = 0x7,
    OUTCOME_MOVING = 0x8,
};

enum {
    FAULT_ESTOP = 0x1,
    FAULT_VELOCITY = 0x2,
    FAULT_TRAVEL = 0x4,
    FAULT_ENCODER = 0x8,
    FAULT_WATCHDOG = 0x10,
    FAULT_OVERRUN = 0x20,
    FAULT_DEAD_MAN = 0x100,
    FAULT_SILENT = 0x200,
    FAULT_DEFAULTS = 0x400,
};

enum {
    SIGN_SATURATED_X = 0x1,
    SIGN_SATURATED_Y = 0x2,
    SIGN_SATURATED_THETA = 0x4,
    SIGN_SLEWING = 0x8,
    SIGN_FIELD = 0x10,
    SIGN_ENABLED = 0x20,
    SIGN_HELD = 0x40,
    SIGN_STOPPED = 0x80,
};

enum {
    MESSAGE_HELLO = 0x01,
    MESSAGE_PING = 0x02,
    MESSAGE_ARM = 0x03,
    MESSAGE_DISARM = 0x04,
    MESSAGE_FIELD = 0x05,
    MESSAGE_CLEAR_FAULTS = 0x06,
    MESSAGE_ZERO = 0x07,
    MESSAGE_GET_CONFIGURATION = 0x08,
    MESSAGE_SET_CONFIGURATION = 0x09,
    MESSAGE_SAVE_CONFIGURATION = 0x0a,
    MESSAGE_IDENTITY = 0x81,
    MESSAGE_TELEMETRY = 0x82,
    MESSAGE_ANSWER = 0x83,
    MESSAGE_CONFIGURATION = 0x84,
};

struct arm {
    uint32_t key;
} __attribute__((packed));
_Static_assert(sizeof(struct arm) == 4, "arm is packed");

struct field {
    int16_t wrench[3];
    int16_t about[3];
    int16_t stiffness[9];
    int16_t damping[9];
    uint16_t valid_for;
} __attribute__((packed));
_Static_assert(sizeof(struct field) == 50, "field is packed");

static inline bool field_is_legal(const struct field *field)
{
    for (uint8_t i = 0; i < 3; i++)
        if (field->wrench[i] < -32736 || field->wrench[i] > 32736)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (field->about[i] < -16376 || field->about[i] > 16376)
            return false;
    for (uint8_t i = 0; i < 9; i++)
        if (field->stiffness[i] < -32760 || field->stiffness[i] > 32760)
            return false;
    for (uint8_t i = 0; i < 9; i++)
        if (field->damping[i] < -32760 || field->damping[i] > 32760)
            return false;
    if (field->valid_for < 1 || field->valid_for > 250)
        return false;
    return true;
}

struct identity {
    uint8_t version;
    uint8_t reset_cause;
    uint32_t firmware;
    uint32_t serial;
} __attribute__((packed));
_Static_assert(sizeof(struct identity) == 10, "identity is packed");

struct telemetry {
    uint32_t tick;
    int16_t position[3];
    int16_t rate[3];
    int16_t motor[3];
    uint8_t state;
    uint8_t signs;
    uint16_t faults;
    uint8_t field;
    uint8_t refused;
    uint8_t glitches;
    uint8_t missed;
    uint16_t late;
    uint16_t worked;
    uint16_t busy;
} __attribute__((packed));
_Static_assert(sizeof(struct telemetry) == 36, "telemetry is packed");

struct answer {
    uint8_t request;
    uint8_t sequence;
    uint8_t outcome;
} __attribute__((packed));
_Static_assert(sizeof(struct answer) == 3, "answer is packed");

struct configuration {
    int8_t motor_sign[3];
    int8_t encoder_sign[3];
    uint16_t counts_per_degree[3];
    int16_t centring_stiffness[3];
    int16_t centring_damping[3];
    int16_t gravity[3];
    uint8_t force_limit[3];
    uint8_t slew_limit[3];
    uint16_t travel[3];
    uint16_t velocity_trip[3];
    uint8_t rate_filter;
    uint16_t soft_start;
    uint16_t silence;
    uint16_t fade;
    uint8_t glitch_limit;
    uint32_t serial;
} __attribute__((packed));
_Static_assert(sizeof(struct configuration) == 60, "configuration is packed");

static inline bool configuration_is_legal(const struct configuration *configuration)
{
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->motor_sign[i] < -1 || configuration->motor_sign[i] > 1)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->encoder_sign[i] < -1 || configuration->encoder_sign[i] > 1)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->counts_per_degree[i] < 512)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->centring_stiffness[i] < 0 || configuration->centring_stiffness[i] > 16383)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->centring_damping[i] < 0 || configuration->centring_damping[i] > 8191)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->gravity[i] < -255 || configuration->gravity[i] > 255)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->slew_limit[i] < 1)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->travel[i] < 1 || configuration->travel[i] > 2047)
            return false;
    for (uint8_t i = 0; i < 3; i++)
        if (configuration->velocity_trip[i] < 1 || configuration->velocity_trip[i] > 8191)
            return false;
    if (configuration->rate_filter < 1)
        return false;
    if (configuration->soft_start < 10 || configuration->soft_start > 10000)
        return false;
    if (configuration->silence < 10 || configuration->silence > 1000)
        return false;
    if (configuration->fade < 1 || configuration->fade > 1000)
        return false;
    if (configuration->glitch_limit < 1)
        return false;
    return true;
}

#define DEFAULT_CONFIGURATION { { 1, 1, 1 }, { 1, 1, 1 }, { 3072, 3840, 1024 }, { 179, 179, 340 }, { 336, 336, 370 }, { 100, 70, 0 }, { 255, 255, 255 }, { 64, 64, 64 }, { 360, 360, 1600 }, { 2560, 2560, 2560 }, 64, 1000, 200, 100, 20, 0 }

#endif
