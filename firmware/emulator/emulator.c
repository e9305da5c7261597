#include "emulator.h"

#include <simavr/avr_eeprom.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <simavr/sim_cycle_timers.h>
#include <simavr/sim_elf.h>
#include <stdlib.h>
#include <string.h>

#define HERTZ 16000000.0
#define SLICE 8000
/* simavr carries eleven bits a byte, whatever the frame is: 22 us at 500 kbaud. */
#define BYTE_CYCLES 352
#define LINE_SIZE (1 << 20)
#define BROWN_OUT 0x04
#define MCUSR_ADDRESS 0x54
#define WDTCSR_ADDRESS 0x60
#define WATCHDOG_INTERRUPT 0x40

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
    uint8_t healthy[2];
};

/* control register, its connecting bit, compare register, port, direction, bit of the pin */
static const struct {
    uint16_t control;
    uint8_t connect;
    uint16_t compare, port, direction;
    uint8_t bit;
} pins[2 * AXES] = {
    { 0xA0, 0x80, 0xA8, 0x102, 0x101, 3 }, /* D6 OC4A */
    { 0xA0, 0x20, 0xAA, 0x102, 0x101, 4 }, /* D7 OC4B */
    { 0xA0, 0x08, 0xAC, 0x102, 0x101, 5 }, /* D8 OC4C */
    { 0xB0, 0x20, 0xB4, 0x102, 0x101, 6 }, /* D9 OC2B */
    { 0xB0, 0x80, 0xB3, 0x25, 0x24, 4 },   /* D10 OC2A */
    { 0x80, 0x80, 0x88, 0x25, 0x24, 5 },   /* D11 OC1A */
};

static bool line_put(struct line *line, uint8_t byte)
{
    uint32_t next = (line->head + 1) % LINE_SIZE;

    if (next == line->tail)
        return false;
    line->bytes[line->head] = byte;
    line->head = next;
    return true;
}

static bool line_take(struct line *line, uint8_t *byte)
{
    if (line->head == line->tail)
        return false;
    *byte = line->bytes[line->tail];
    line->tail = (line->tail + 1) % LINE_SIZE;
    return true;
}

int emulator_duty(const struct emulator *emulator, int pin)
{
    const uint8_t *data = emulator->avr->data;

    if (!(data[pins[pin].direction] >> pins[pin].bit & 1))
        return 0;
    if (data[pins[pin].control] & pins[pin].connect)
        return data[pins[pin].compare];
    return (data[pins[pin].port] >> pins[pin].bit & 1) * 255;
}

static void on_motor_write(struct avr_irq_t *irq, uint32_t value, void *param)
{
    struct emulator *emulator = param;

    for (int axis = 0; axis < AXES; axis++) {
        int plus = emulator_duty(emulator, 2 * axis), minus = emulator_duty(emulator, 2 * axis + 1);
        int greater = plus > minus ? plus : minus;

        if (plus && minus)
            emulator->overlaps++;
        if (greater > emulator->greatest)
            emulator->greatest = greater;
    }
}

static void on_sent(struct avr_irq_t *irq, uint32_t value, void *param)
{
    line_put(&((struct emulator *)param)->out, (uint8_t)value);
}

/* A wire that drives a pin: stated to the port too, or its pull-ups would win at its next write. */
static void set_pin(struct emulator *emulator, char port, int bit, int level)
{
    struct wires *wires = &emulator->wires[port - 'A'];
    avr_ioport_external_t external = { .name = port };

    wires->driven |= 1 << bit;
    wires->high = (wires->high & ~(1 << bit)) | level << bit;
    external.mask = wires->driven;
    external.value = wires->high;
    avr_ioctl(emulator->avr, AVR_IOCTL_IOPORT_SET_EXTERNAL(port), &external);
    avr_raise_irq(avr_io_getirq(emulator->avr, AVR_IOCTL_IOPORT_GETIRQ(port), bit), level);
}

/* Count 0, 1, 2, 3 is (A, B) = 00, 10, 11, 01. */
static void show(struct encoder *encoder)
{
    int phase = encoder->count & 3;
    int a = (phase == 1 || phase == 2) ^ (encoder->flipped == 0);
    int b = (phase >= 2) ^ (encoder->flipped == 1);

    set_pin(encoder->emulator, encoder->port, encoder->a, a);
    set_pin(encoder->emulator, encoder->port, encoder->b, b);
}

static bool step_towards(struct encoder *encoder, int32_t target)
{
    if (encoder->count == target)
        return false;
    encoder->count += encoder->count < target ? 1 : -1;
    show(encoder);
    return encoder->count != target;
}

static avr_cycle_count_t on_edge(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct encoder *encoder = param;

    return step_towards(encoder, encoder->target) ? when + encoder->period : 0;
}

static avr_cycle_count_t on_glitch_end(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct encoder *encoder = param;

    encoder->flipped = -1;
    show(encoder);
    return 0;
}

static avr_cycle_count_t on_plant(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct emulator *emulator = param;

    for (int i = 0; i < AXES; i++) {
        struct axis *axis = &emulator->axes[i];
        struct encoder *encoder = &emulator->encoders[i];
        double duty = emulator_duty(emulator, 2 * i) - emulator_duty(emulator, 2 * i + 1);

        if (axis->moving == 0.0)
            continue;
        axis_step(axis, emulator_enabled(emulator) ? duty : 0.0, PLANT_CYCLES / HERTZ);
        if (axis->encoder != 0.0)
            step_towards(encoder, (int32_t)axis->encoder * axis_count(axis));
    }
    return when + PLANT_CYCLES;
}

static avr_cycle_count_t on_line(struct avr_t *avr, avr_cycle_count_t when, void *param)
{
    struct emulator *emulator = param;
    uint8_t byte;

    if (line_take(&emulator->in, &byte))
        avr_raise_irq(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_INPUT), byte);
    return when + BYTE_CYCLES;
}

static void show_contacts(struct emulator *emulator)
{
    set_pin(emulator, 'A', 2, emulator->estop);
    set_pin(emulator, 'A', 4, !emulator->dead_man);
}

/* Every reset of the processor, its watchdog's too, forgets the timers. */
static void keep_going(struct emulator *emulator)
{
    avr_t *avr = emulator->avr;

    if (avr_cycle_timer_status(avr, on_plant, emulator))
        return;
    avr_cycle_timer_register(avr, PLANT_CYCLES, on_plant, emulator);
    avr_cycle_timer_register(avr, BYTE_CYCLES, on_line, emulator);
    for (int i = 0; i < AXES; i++)
        show(&emulator->encoders[i]);
    show_contacts(emulator);
}

static void no_sleep(struct avr_t *avr, avr_cycle_count_t how_long)
{
}

static void no_log(struct avr_t *avr, const int level, const char *format, va_list arguments)
{
}

static void connect(struct emulator *emulator)
{
    avr_t *avr = emulator->avr;
    uint32_t flags = 0;

    for (int i = 0; i < EXTINT_COUNT; i++)
        avr_extint_set_strict_lvl_trig(avr, i, 0);
    avr_ioctl(avr, AVR_IOCTL_UART_GET_FLAGS('0'), &flags);
    flags &= ~(AVR_UART_FLAG_POLL_SLEEP | AVR_UART_FLAG_STDIO);
    avr_ioctl(avr, AVR_IOCTL_UART_SET_FLAGS('0'), &flags);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_UART_GETIRQ('0'), UART_IRQ_OUTPUT),
                            on_sent, emulator);
    for (int i = 0; i < 2 * AXES; i++) {
        const uint16_t watched[] = { pins[i].control, pins[i].compare, pins[i].port };

        for (int j = 0; j < 3; j++)
            avr_irq_register_notify(
                avr_iomem_getirq(avr, watched[j], NULL, AVR_IOMEM_IRQ_ALL), on_motor_write,
                emulator);
    }
}

struct emulator *emulator_new(const char *elf)
{
    static const struct encoder wiring[AXES] = {
        { .port = 'D', .a = 1, .b = 0, .flipped = -1 },
        { .port = 'D', .a = 3, .b = 2, .flipped = -1 },
        { .port = 'E', .a = 5, .b = 4, .flipped = -1 },
    };
    struct emulator *emulator = calloc(1, sizeof(*emulator));

    avr_global_logger_set(no_log);
    emulator->avr = avr_make_mcu_by_name("atmega2560");
    if (!emulator->avr || elf_read_firmware(elf, &emulator->firmware) != 0) {
        free(emulator);
        return NULL;
    }
    avr_init(emulator->avr);
    emulator->avr->sleep = no_sleep;
    emulator->avr->frequency = (uint32_t)HERTZ;
    avr_load_firmware(emulator->avr, &emulator->firmware);
    emulator->avr->frequency = (uint32_t)HERTZ;
    for (int i = 0; i < AXES; i++) {
        emulator->encoders[i] = wiring[i];
        emulator->encoders[i].emulator = emulator;
        emulator->encoders[i].axis = i;
    }
    connect(emulator);
    keep_going(emulator);
    return emulator;
}

void emulator_free(struct emulator *emulator)
{
    avr_terminate(emulator->avr);
    free(emulator);
}

bool emulator_run(struct emulator *emulator, uint64_t cycles)
{
    avr_t *avr = emulator->avr;
    avr_cycle_count_t end = avr->cycle + cycles;

    while (avr->cycle < end) {
        avr_cycle_count_t slice = avr->cycle + SLICE < end ? avr->cycle + SLICE : end;

        keep_going(emulator);
        while (avr->cycle < slice) {
            int state = avr_run(avr);

            if (state == cpu_Done || state == cpu_Crashed)
                return false;
        }
    }
    return true;
}

uint64_t emulator_cycle(const struct emulator *emulator)
{
    return emulator->avr->cycle;
}

void emulator_write(struct emulator *emulator, const uint8_t *bytes, uint32_t length)
{
    for (uint32_t i = 0; i < length; i++)
        line_put(&emulator->in, bytes[i]);
}

uint32_t emulator_read(struct emulator *emulator, uint8_t *bytes, uint32_t most)
{
    uint32_t length = 0;

    while (length < most && line_take(&emulator->out, &bytes[length]))
        length++;
    return length;
}

uint32_t emulator_waiting(const struct emulator *emulator)
{
    return (emulator->in.head - emulator->in.tail + LINE_SIZE) % LINE_SIZE;
}

void emulator_set(struct emulator *emulator, int axis, int which, double value)
{
    ((double *)&emulator->axes[axis])[which] = value;
}

double emulator_get(const struct emulator *emulator, int axis, int which)
{
    return ((const double *)&emulator->axes[axis])[which];
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
    show(encoder);
    avr_cycle_timer_register(emulator->avr, cycles, on_glitch_end, encoder);
}

void emulator_jump(struct emulator *emulator, int axis)
{
    avr_t *avr = emulator->avr;
    uint8_t enabled = avr->sreg[S_I];

    /* Seen by no instruction between the two lines. */
    avr->sreg[S_I] = 0;
    emulator->encoders[axis].count += 2;
    show(&emulator->encoders[axis]);
    avr->sreg[S_I] = enabled;
}

void emulator_estop(struct emulator *emulator, bool pressed)
{
    emulator->estop = pressed;
    show_contacts(emulator);
}

void emulator_dead_man(struct emulator *emulator, bool held)
{
    emulator->dead_man = held;
    show_contacts(emulator);
}

bool emulator_enabled(const struct emulator *emulator)
{
    const uint8_t *data = emulator->avr->data;

    return (data[0x21] & 1) && (data[0x22] & 1); /* DDRA, PORTA */
}

int emulator_greatest_duty(struct emulator *emulator)
{
    int greatest = emulator->greatest;

    emulator->greatest = 0;
    on_motor_write(NULL, 0, emulator);
    return greatest > emulator->greatest ? greatest : emulator->greatest;
}

uint32_t emulator_overlaps(struct emulator *emulator)
{
    uint32_t overlaps = emulator->overlaps;

    emulator->overlaps = 0;
    return overlaps;
}

void emulator_brown_out(struct emulator *emulator)
{
    avr_reset(emulator->avr);
    emulator->avr->data[MCUSR_ADDRESS] = BROWN_OUT;
    keep_going(emulator);
}

void emulator_hang(struct emulator *emulator, bool interrupts)
{
    avr_t *avr = emulator->avr;

    emulator->hung_at = avr->pc;
    memcpy(emulator->healthy, &avr->flash[avr->pc], 2);
    avr->flash[avr->pc] = 0xFF; /* rjmp .-2 */
    avr->flash[avr->pc + 1] = 0xCF;
    avr->sreg[S_I] = interrupts;
    /* The real watchdog resets at its second bite when nobody took the first as an interrupt;
     * simavr's does so only once the interrupt is off. */
    if (!interrupts)
        avr->data[WDTCSR_ADDRESS] &= ~WATCHDOG_INTERRUPT;
}

void emulator_heal(struct emulator *emulator)
{
    memcpy(&emulator->avr->flash[emulator->hung_at], emulator->healthy, 2);
}

void emulator_eeprom(struct emulator *emulator, uint16_t address, uint8_t *bytes, uint16_t length,
                     bool write)
{
    avr_eeprom_desc_t part = { .ee = bytes, .offset = address, .size = length };

    avr_ioctl(emulator->avr, write ? AVR_IOCTL_EEPROM_SET : AVR_IOCTL_EEPROM_GET, &part);
}
