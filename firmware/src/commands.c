#include "commands.h"

#include <string.h>

#include "clock.h"
#include "config.h"
#include "safety.h"
#include "stick.h"
#include "uart.h"

#define KEPT_FOR_TELEMETRY 64 /* bytes of the line's buffer: a frame, and half of one */

#ifndef FIRMWARE_HASH
#error "FIRMWARE_HASH is given by the Makefile"
#endif

uint8_t refused;
uint8_t field_sequence;
static bool any_sequence;
static uint8_t save_sequence;

/* However much a host asks, telemetry goes on: what finds the line full is not sent. */
static void reply(uint8_t code, const void *payload, uint8_t length)
{
    if (uart_room() > KEPT_FOR_TELEMETRY + FRAMING + length)
        frame_send(code, payload, length);
}

static void answer(uint8_t request, uint8_t sequence, uint8_t outcome)
{
    struct answer told = { request, sequence, outcome };

    if (outcome != OUTCOME_DONE)
        refused++;
    reply(MESSAGE_ANSWER, &told, sizeof(told));
}

static void take_field(const struct frame *frame)
{
    const struct field *field = (const void *)frame->payload;
    uint8_t ahead = frame->sequence - field_sequence;

    if (!field_is_legal(field) || (!any_sequence && (ahead == 0 || ahead > 127))) {
        refused++;
        return;
    }
    safety_hear();
    any_sequence = false;
    field_sequence = frame->sequence;
    if (!safety_is_off())
        field_take(field, &stick.motion);
}

static void identify(void)
{
    struct identity identity = { PROTOCOL_VERSION, reset_cause, FIRMWARE_HASH, config.serial };

    reply(MESSAGE_IDENTITY, &identity, sizeof(identity));
}

static uint8_t arm(const struct frame *frame)
{
    uint32_t key;
    uint8_t outcome;

    memcpy(&key, frame->payload, sizeof(key));
    outcome = safety_arm(key);
    if (outcome == OUTCOME_DONE)
        any_sequence = true;
    return outcome;
}

static uint8_t zero(void)
{
    if (!safety_is_off())
        return OUTCOME_NOT_NOW;
    encoder_zero();
    stick_settle();
    return OUTCOME_DONE;
}

static uint8_t configure(const struct frame *frame)
{
    const struct configuration *wanted = (const void *)frame->payload;

    if (!configuration_is_legal(wanted))
        return OUTCOME_ILLEGAL;
    if (!safety_is_off() || config_is_writing())
        return OUTCOME_NOT_NOW;
    config_use(wanted);
    stick_settle();
    return OUTCOME_DONE;
}

static uint8_t save(const struct frame *frame)
{
    if (!safety_is_off() || config_is_writing())
        return OUTCOME_NOT_NOW;
    save_sequence = frame->sequence;
    config_save();
    return OUTCOME_DONE;
}

void go_on_saving(void)
{
    if (config_write()) {
        safety.faults &= ~FAULT_DEFAULTS;
        answer(MESSAGE_SAVE_CONFIGURATION, save_sequence, OUTCOME_DONE);
    }
}

static bool length_is_right(const struct frame *frame)
{
    switch (frame->code) {
    case MESSAGE_ARM:
        return frame->length == sizeof(struct arm);
    case MESSAGE_FIELD:
        return frame->length == sizeof(struct field);
    case MESSAGE_SET_CONFIGURATION:
        return frame->length == sizeof(struct configuration);
    default:
        return frame->code >= MESSAGE_HELLO && frame->code <= MESSAGE_SAVE_CONFIGURATION &&
               frame->length == 0;
    }
}

void obey(const struct frame *frame)
{
    uint8_t outcome = OUTCOME_DONE;

    if (!length_is_right(frame)) {
        answer(frame->code, frame->sequence, OUTCOME_UNKNOWN);
        return;
    }
    if (frame->code == MESSAGE_FIELD) {
        take_field(frame);
        return;
    }
    safety_hear();
    switch (frame->code) {
    case MESSAGE_HELLO:
        identify();
        return;
    case MESSAGE_PING:
        return;
    case MESSAGE_GET_CONFIGURATION:
        reply(MESSAGE_CONFIGURATION, &config, sizeof(config));
        return;
    case MESSAGE_ARM:
        outcome = arm(frame);
        break;
    case MESSAGE_DISARM:
        outcome = safety_disarm();
        break;
    case MESSAGE_CLEAR_FAULTS:
        outcome = safety_clear();
        break;
    case MESSAGE_ZERO:
        outcome = zero();
        break;
    case MESSAGE_SET_CONFIGURATION:
        outcome = configure(frame);
        break;
    case MESSAGE_SAVE_CONFIGURATION:
        outcome = save(frame);
        if (outcome == OUTCOME_DONE)
            return;
        break;
    }
    answer(frame->code, frame->sequence, outcome);
}
