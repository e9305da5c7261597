/* What each message from the host does. */
#ifndef COMMANDS_H
#define COMMANDS_H

#include <stdint.h>

#include "frame.h"

/* So far, modulo 256. */
extern uint8_t refused;
extern uint8_t field_sequence;

/* Obey a sound frame, or refuse it. */
void obey(const struct frame *frame);

/* Let an EEPROM write go on; answers when it ends. */
void go_on_saving(void);

#endif
