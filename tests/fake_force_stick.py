"""A force-feedback stick of umockdev's, as Linux would show it; run by the system's Python.

Under LD_PRELOAD of umockdev. Says the folder of its fake system first. Then one order a line, each
answered by one line of JSON: `move CODE VALUE`, `press CODE VALUE`, `overflow`, `unplug`, `plug`,
`serial NUMBER 0`, `log`.
The log has every effect that was uploaded, played and erased, in order.
"""

import errno
import json
import struct
import sys

import gi

gi.require_version("UMockdev", "1.0")
from gi.repository import GLib, UMockdev  # noqa: E402

DEVICE = """\
P: /devices/pci0000:00/usb1/1-1/input/input5
E: SUBSYSTEM=input
E: ID_INPUT=1
E: ID_INPUT_JOYSTICK=1
E: ID_BUS=usb
E: ID_VENDOR_ID=045e
E: ID_MODEL_ID=001b
A: name={name}\\n
A: id/vendor=045e\\n
A: id/product=001b\\n
A: id/bustype=0003\\n
A: id/version=0110\\n

P: /devices/pci0000:00/usb1/1-1/input/input5/event5
N: input/event5
E: SUBSYSTEM=input
E: DEVNAME=/dev/input/event5
E: ID_INPUT=1
E: ID_INPUT_JOYSTICK=1
A: dev=13:69\\n
"""
NODE = "/dev/input/event5"
NAME = b"Fake SideWinder FFB2"
SYN, KEY, ABS, FF = 0x00, 0x01, 0x03, 0x15
X, Y, THROTTLE, RZ, TRIGGER = 0x00, 0x01, 0x06, 0x05, 0x120
RANGES = {X: (-512, 511), Y: (-512, 511), RZ: (-32, 31), THROTTLE: (0, 255)}
CONSTANT, SPRING, DAMPER, GAIN, AUTOCENTRE = 0x52, 0x53, 0x55, 0x60, 0x61
EVENT = struct.Struct("<qqHHi")
EFFECT = struct.Struct("<HhHHHHHxx32s")
PUSH = struct.Struct("<hHHHH")
CONDITION = struct.Struct("<HHhhHh")
SLOTS = 16


def bits(*numbers: int) -> bytes:
    return sum(1 << number for number in numbers).to_bytes(96, "little")


class Stick(UMockdev.IoctlBase):
    """Answers as the kernel's event device does."""

    def __init__(self, forces: tuple[int, ...]) -> None:
        super().__init__()
        self.forces = forces
        self.serial = b"FF2-0042"
        self.values = dict.fromkeys(RANGES, 0)
        self.queue: list[bytes] = []
        self.held: set[int] = set()
        self.plugged = True
        self.slots: dict[int, bool] = {}
        self.log: list[dict] = []
        self.connect("handle-ioctl", self.on_ioctl)
        self.connect("handle-read", self.on_read)
        self.connect("handle-write", self.on_write)

    def on_ioctl(self, _, client) -> bool:
        request = client.get_request()
        number, size = request & 0xFF, (request >> 16) & 0x3FFF
        if (request >> 8) & 0xFF != ord("E"):
            client.complete(-1, errno.ENOTTY)
        elif not self.plugged:
            client.complete(-1, errno.ENODEV)
        elif number == 0x80:
            self.upload(client)
        elif number == 0x81:
            self.erase(client)
        else:
            told = self.tell(number)
            if told is None:
                client.complete(-1, errno.EINVAL)
                return True
            if size and told:
                client.get_arg().resolve(0, size).update(0, list(told[:size].ljust(size, b"\0")))
            client.complete(len(told[:size]) if number in (6, 7, 8) else 0, 0)
        return True

    def tell(self, number: int) -> bytes | None:
        """Give the bytes of an ioctl that asks for something."""
        plain = {
            0x01: struct.pack("<i", 0x010001),
            0x02: struct.pack("<HHHH", 3, 0x045E, 0x001B, 0x0110),
            0x06: NAME + b"\0",
            0x07: b"usb-1/input0\0",
            0x08: self.serial + b"\0",
            0x09: b"\0",
            0x18: bits(*self.held),
            0x20: bits(SYN, KEY, ABS, *([FF] if self.forces else [])),
            0x20 + KEY: bits(TRIGGER, TRIGGER + 1),
            0x20 + ABS: bits(*RANGES),
            0x20 + FF: bits(*self.forces),
            0x84: struct.pack("<i", SLOTS),
            0x90: b"",
        }
        if number in plain:
            return plain[number]
        if 0x20 <= number < 0x40:
            return bits()
        if 0x40 <= number < 0x80 and number - 0x40 in RANGES:
            axis = number - 0x40
            low, high = RANGES[axis]
            return struct.pack("<6i", self.values[axis], low, high, 0, 0, 0)
        return None

    def upload(self, client) -> None:
        memory = client.get_arg().resolve(0, EFFECT.size)
        kind, slot, direction, _, _, length, delay, body = EFFECT.unpack(bytes(memory.retrieve()))
        if slot == -1:
            slot = next((free for free in range(SLOTS) if free not in self.slots), -1)
            if slot == -1:
                client.complete(-1, errno.ENOSPC)
                return
            self.slots[slot] = False
        elif slot not in self.slots:
            client.complete(-1, errno.EINVAL)
            return
        told = {"do": "upload", "slot": slot, "length": length, "delay": delay}
        if kind == CONSTANT:
            level, _, _, fade, fade_level = PUSH.unpack_from(body)
            told |= {"kind": "push", "level": level, "direction": direction}
            told |= {"fade": fade, "fade_level": fade_level}
        else:
            told["kind"] = {SPRING: "spring", DAMPER: "damper"}[kind]
            both = (CONDITION.unpack_from(body, axis * CONDITION.size) for axis in (0, 1))
            names = ("right_saturation", "left_saturation", "right", "left", "dead", "centre")
            told["axes"] = [dict(zip(names, one, strict=True)) for one in both]
        self.log.append(told)
        memory.update(0, list(EFFECT.pack(kind, slot, direction, 0, 0, length, delay, body)))
        client.complete(0, 0)

    def erase(self, client) -> None:
        slot = struct.unpack("<q", bytes(client.get_arg().retrieve())[:8])[0]
        known = self.slots.pop(slot, None) is not None
        self.log.append({"do": "erase", "slot": slot})
        client.complete(0 if known else -1, 0 if known else errno.EINVAL)

    def on_read(self, _, client) -> bool:
        if not self.plugged:
            client.complete(-1, errno.ENODEV)
        elif not self.queue:
            client.complete(-1, errno.EAGAIN)
        else:
            memory = client.get_arg()
            room = len(memory.retrieve()) // EVENT.size
            sent, self.queue = self.queue[:room], self.queue[room:]
            data = b"".join(sent)
            memory.update(0, list(data))
            client.complete(len(data), 0)
        return True

    def on_write(self, _, client) -> bool:
        data = bytes(client.get_arg().retrieve())
        for start in range(0, len(data), EVENT.size):
            _, _, kind, code, value = EVENT.unpack_from(data, start)
            if kind == FF and code in self.slots:
                self.slots[code] = bool(value)
                self.log.append({"do": "play" if value else "stop", "slot": code})
            elif kind == FF:
                what = {GAIN: "gain", AUTOCENTRE: "autocentre"}[code]
                self.log.append({"do": what, "value": value})
        client.complete(len(data), 0)
        return True

    def event(self, kind: int, code: int, value: int) -> None:
        self.queue.append(EVENT.pack(0, 0, kind, code, value))
        self.queue.append(EVENT.pack(0, 0, SYN, 0, 0))


def obey(stick: Stick, testbed: UMockdev.Testbed, line: str) -> object:
    order, *numbers = line.split()
    code, value = [int(number) for number in numbers] or (0, 0)
    if order == "move":
        stick.values[code] = value
        stick.event(ABS, code, value)
    elif order == "press":
        (stick.held.add if value else stick.held.discard)(code)
        stick.event(KEY, code, value)
    elif order == "overflow":  # events were lost: the state must be asked for
        stick.queue.clear()
        stick.values[X] = 511
        stick.event(SYN, 3, 0)
    elif order == "unplug":
        stick.plugged = False
        testbed.uevent("/sys/devices/pci0000:00/usb1/1-1/input/input5/event5", "remove")
    elif order == "plug":
        stick.plugged = True
        stick.queue.clear()
        stick.values.update(dict.fromkeys(RANGES, 0))
    elif order == "serial":  # another stick of the same make
        stick.serial = f"FF2-{code:04}".encode()
    elif order == "log":
        return stick.log
    return None


def main() -> None:
    forces = {"full": (CONSTANT, SPRING, DAMPER, GAIN, AUTOCENTRE), "push": (CONSTANT,), "none": ()}
    testbed = UMockdev.Testbed.new()
    testbed.add_from_string(DEVICE.format(name=NAME.decode()))
    stick = Stick(forces[sys.argv[1]])
    testbed.attach_ioctl(NODE, stick)
    loop = GLib.MainLoop()

    def on_line(source: int, condition: GLib.IOCondition) -> bool:
        line = sys.stdin.readline()
        if not line:
            loop.quit()
            return False
        print(json.dumps(obey(stick, testbed, line)), flush=True)
        return True

    GLib.io_add_watch(0, GLib.IO_IN | GLib.IO_HUP, on_line)
    print(testbed.get_root_dir(), flush=True)
    loop.run()


if __name__ == "__main__":
    main()
