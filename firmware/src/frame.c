#include "frame.h"

#include "crc.h"
#include "uart.h"

#define HEAD 2
#define TAIL 2

static uint8_t left;      /* bytes until the next COBS code */
static uint8_t last_code; /* 0 before the first */
static uint8_t length;    /* of what is decoded */
static uint16_t crc = CRC_START;
static bool spoilt;       /* until the next zero byte */

static void begin(void)
{
    left = last_code = length = 0;
    crc = CRC_START;
    spoilt = false;
}

static void push(struct frame *frame, uint8_t byte)
{
    uint8_t *bytes = (uint8_t *)frame;

    if (length >= HEAD + LONGEST_PAYLOAD + TAIL) {
        spoilt = true;
        return;
    }
    /* Code and sequence come first in the struct, the payload after its length. */
    bytes[length < HEAD ? length : length + 1] = byte;
    length++;
    crc = crc_update(crc, byte);
}

enum reception frame_take(struct frame *frame, uint8_t byte)
{
    if (byte == 0) {
        bool empty = last_code == 0 && !spoilt;
        bool sound = !spoilt && left == 0 && length >= HEAD + TAIL && crc == 0;

        frame->length = length - HEAD - TAIL;
        begin();
        return sound ? RECEPTION_FRAME : empty ? RECEPTION_NONE : RECEPTION_DAMAGED;
    }
    if (spoilt)
        return RECEPTION_NONE;
    if (left == 0) {
        if (last_code != 0 && last_code != 0xFF)
            push(frame, 0);
        last_code = byte;
        left = byte - 1;
    } else {
        push(frame, byte);
        left--;
    }
    return RECEPTION_NONE;
}

void frame_spoil(void)
{
    spoilt = true;
    last_code = 0xFF;
}

_Static_assert(HEAD + LONGEST_PAYLOAD + TAIL < 254, "one COBS block holds a frame without zeros");
_Static_assert(FRAMING == HEAD + TAIL + 2, "and a code before it and a zero behind it");

/* Writes COBS as it goes: each code is filled in when its run of bytes ends. */
struct stuffing {
    uint8_t code_at, run;
    uint16_t crc;
};

static inline __attribute__((always_inline)) void stuff(struct stuffing *stuffing, uint8_t byte)
{
    stuffing->crc = crc_update(stuffing->crc, byte);
    if (byte != 0) {
        uart_write(byte);
        stuffing->run++;
    } else {
        uart_fill(stuffing->code_at, stuffing->run);
        stuffing->code_at = uart_write(0);
        stuffing->run = 1;
    }
}

bool frame_send(uint8_t code, const void *payload, uint8_t size)
{
    static uint8_t sequence;
    const uint8_t *bytes = payload;
    struct stuffing stuffing = { 0, 1, CRC_START };
    uint16_t crc;

    if (uart_room() < FRAMING + size)
        return false;
    stuffing.code_at = uart_write(0);
    stuff(&stuffing, code);
    stuff(&stuffing, sequence++);
    for (uint8_t i = 0; i < size; i++)
        stuff(&stuffing, bytes[i]);
    crc = stuffing.crc;
    stuff(&stuffing, crc >> 8);
    stuff(&stuffing, crc);
    uart_fill(stuffing.code_at, stuffing.run);
    uart_write(0);
    uart_send();
    return true;
}
