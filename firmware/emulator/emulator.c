#include "inside.h"

#include <simavr/avr_eeprom.h>
#include <simavr/avr_extint.h>
#include <simavr/avr_ioport.h>
#include <simavr/avr_uart.h>
#include <stdlib.h>
#include <string.h>

#define SLICE 8000
/* simavr carries eleven bits a byte, whatever the frame is: 22 us at 500 kbaud. */
#define BYTE_CYCLES 352
#define BROWN_OUT 0x04
#define MCUSR_ADDRESS 0x54
#define WDTCSR_ADDRESS 0x60
#define WATCHDOG_INTERRUPT 0x40

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

static void on_sent(struct avr_irq_t *irq, uint32_t value, void *param)
{
    line_put(&((struct emulator *)param)->out, (uint8_t)value);
}

/* A wire that drives a pin: stated to the port too, or its pull-ups would win at its next write. */
void set_pin(struct emulator *emulator, char port, int bit, int level)
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
            encoder_step(encoder, (int32_t)axis->encoder * axis_count(axis));
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
        encoder_show(&emulator->encoders[i]);
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
    motors_watch(emulator);
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

void emulator_brown_out(struct emulator *emulator)
{
    avr_reset(emulator->avr);
    emulator->avr->data[MCUSR_ADDRESS] = BROWN_OUT;
    keep_going(emulator);
}

static void jump_to_itself(uint8_t *instruction, uint8_t *healthy)
{
    memcpy(healthy, instruction, 2);
    instruction[0] = 0xFF; /* rjmp .-2 */
    instruction[1] = 0xCF;
}

void emulator_hang(struct emulator *emulator, bool interrupts)
{
    avr_t *avr = emulator->avr;

    emulator->hung_at = avr->pc;
    jump_to_itself(&avr->flash[avr->pc], emulator->healthy);
    avr->sreg[S_I] = interrupts;
    /* The real watchdog resets at its second bite when nobody took the first as an interrupt;
     * simavr's does so only once the interrupt is off. */
    if (!interrupts)
        avr->data[WDTCSR_ADDRESS] &= ~WATCHDOG_INTERRUPT;
}

void emulator_hang_at_start(struct emulator *emulator)
{
    jump_to_itself(emulator->avr->flash, emulator->healthy_start);
    emulator->start_hangs = true;
}

void emulator_heal(struct emulator *emulator)
{
    memcpy(&emulator->avr->flash[emulator->hung_at], emulator->healthy, 2);
    if (emulator->start_hangs)
        memcpy(emulator->avr->flash, emulator->healthy_start, 2);
    emulator->start_hangs = false;
}

void emulator_eeprom(struct emulator *emulator, uint16_t address, uint8_t *bytes, uint16_t length,
                     bool write)
{
    avr_eeprom_desc_t part = { .ee = bytes, .offset = address, .size = length };

    avr_ioctl(emulator->avr, write ? AVR_IOCTL_EEPROM_SET : AVR_IOCTL_EEPROM_GET, &part);
}
