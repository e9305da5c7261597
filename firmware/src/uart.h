/* Bytes in and out of the serial line, through buffers that interrupts fill and empty. */
#ifndef UART_H
#define UART_H

#include <stdbool.h>
#include <stdint.h>

void uart_init(void);

/* Give the next byte; false when there is none. */
bool uart_read(uint8_t *byte);

/* Tell whether bytes were lost since the last asking. */
bool uart_lost(void);

/* Bytes that can be written now. */
uint8_t uart_room(void);

/* Write a byte for which there is room, and give its place; it waits for `uart_send`, and until then
 * it can be filled in with another. */
uint8_t uart_write(uint8_t byte);
void uart_fill(uint8_t place, uint8_t byte);
void uart_send(void);

#endif
