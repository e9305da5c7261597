/* Frames: COBS( code, sequence, payload, CRC ), 0. */
#ifndef FRAME_H
#define FRAME_H

#include <stdbool.h>
#include <stdint.h>

#include "protocol.h"

struct frame {
    uint8_t code;
    uint8_t sequence;
    uint8_t length; /* of the payload */
    uint8_t payload[LONGEST_PAYLOAD + 2];
};

#define FRAMING 6 /* bytes of a frame besides its payload, in a block without zeros */

enum reception { RECEPTION_NONE, RECEPTION_FRAME, RECEPTION_DAMAGED };

/* Take one byte; a frame, when one is whole, is in `frame` until the next byte. */
enum reception frame_take(struct frame *frame, uint8_t byte);

/* Begin anew at the next zero byte. */
void frame_spoil(void);

/* Send a message; false when the line has no room for it. */
bool frame_send(uint8_t code, const void *payload, uint8_t length);

#endif
