#include "uart.h"

#include <avr/interrupt.h>
#include <avr/io.h>

#include "protocol.h"

/* 256 bytes each, so that an index wraps by itself. */
static uint8_t in[256], out[256];
static volatile uint8_t in_head, in_tail, out_head, out_tail;
static uint8_t written;
static volatile bool lost;

ISR(USART0_RX_vect)
{
    uint8_t status = UCSR0A;
    uint8_t byte = UDR0;
    uint8_t next = in_head + 1;

    if ((status & ((1 << FE0) | (1 << DOR0))) || next == in_tail) {
        lost = true;
        return;
    }
    in[in_head] = byte;
    in_head = next;
}

ISR(USART0_UDRE_vect)
{
    uint8_t tail = out_tail;

    if (tail == out_head) {
        UCSR0B &= ~(1 << UDRIE0);
        return;
    }
    UDR0 = out[tail];
    out_tail = tail + 1;
}

void uart_init(void)
{
    in_head = in_tail = out_head = out_tail = written = 0;
    lost = false;
    /* In this order: simavr works the speed out when UBRR0 is written. */
    UCSR0A = 1 << U2X0;
    UBRR0 = F_CPU / (8 * BAUD) - 1;
    UCSR0C = (1 << UCSZ01) | (1 << UCSZ00);
    UCSR0B = (1 << RXCIE0) | (1 << RXEN0) | (1 << TXEN0);
}

bool uart_read(uint8_t *byte)
{
    uint8_t tail = in_tail;

    if (tail == in_head)
        return false;
    *byte = in[tail];
    in_tail = tail + 1;
    return true;
}

bool uart_lost(void)
{
    bool was = lost;

    if (was)
        lost = false;
    return was;
}

uint8_t uart_room(void)
{
    return out_tail - written - 1;
}

uint8_t uart_write(uint8_t byte)
{
    out[written] = byte;
    return written++;
}

void uart_fill(uint8_t place, uint8_t byte)
{
    out[place] = byte;
}

void uart_send(void)
{
    out_head = written;
    UCSR0B |= 1 << UDRIE0;
}
