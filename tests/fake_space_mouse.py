"""A SpaceMouse of umockdev's, as Linux's raw HID device would show it; run by the system's Python.

Under LD_PRELOAD of umockdev. Says the folder of its fake system first. Then one order a line, each
answered by one line of JSON: `send HEX` (a report waits to be read), `unplug`, `waiting`.
"""

import errno
import json
import os
import struct
import sys

import gi

gi.require_version("UMockdev", "1.0")
from gi.repository import GLib, UMockdev  # noqa: E402

# Usage page 1 (generic desktop), usage 8 (multi-axis controller), an empty collection.
DESCRIPTOR = bytes.fromhex("05010908a101c0")
DEVICE = f"""\
P: /devices/pci0000:00/usb1/1-1
E: SUBSYSTEM=usb
E: DEVTYPE=usb_device
A: idVendor=256f\\n
A: idProduct=c635\\n
A: manufacturer=3Dconnexion\\n
A: product=SpaceMouse Compact\\n
A: serial=SM-7\\n
A: bcdDevice=0101\\n

P: /devices/pci0000:00/usb1/1-1/0003:256F:C635.0001
E: SUBSYSTEM=hid
E: HID_ID=0003:0000256F:0000C635
E: HID_NAME=3Dconnexion SpaceMouse Compact
E: HID_UNIQ=SM-7
H: report_descriptor={DESCRIPTOR.hex().upper()}

P: /devices/pci0000:00/usb1/1-1/0003:256F:C635.0001/hidraw/hidraw0
N: hidraw0
E: SUBSYSTEM=hidraw
E: DEVNAME=/dev/hidraw0
A: dev=241:0\\n
L: device=../../../0003:256F:C635.0001
"""
NODE = "/dev/hidraw0"
HIDIOCGRDESCSIZE, HIDIOCGRDESC, HIDIOCGRAWINFO = 0x01, 0x02, 0x03


class Mouse(UMockdev.IoctlBase):
    """Hands out one report a read, as the kernel does."""

    def __init__(self) -> None:
        super().__init__()
        self.reports: list[bytes] = []
        self.plugged = True
        self.connect("handle-ioctl", self.on_ioctl)
        self.connect("handle-read", self.on_read)

    def on_ioctl(self, _, client) -> bool:
        number = client.get_request() & 0xFF
        answers = {
            HIDIOCGRDESCSIZE: struct.pack("<i", len(DESCRIPTOR)),
            HIDIOCGRDESC: struct.pack("<i", len(DESCRIPTOR)) + DESCRIPTOR,
            HIDIOCGRAWINFO: struct.pack("<IHH", 3, 0x256F, 0xC635),
        }
        told = answers.get(number)
        if told is None or not self.plugged:
            client.complete(-1, errno.EINVAL if self.plugged else errno.ENODEV)
            return True
        client.get_arg().resolve(0, len(told)).update(0, list(told))
        client.complete(0, 0)
        return True

    def on_read(self, _, client) -> bool:
        if not self.plugged:
            client.complete(-1, errno.EIO)
        elif not self.reports:
            client.complete(-1, errno.EAGAIN)
        else:
            report = self.reports.pop(0)
            client.get_arg().update(0, list(report))
            client.complete(len(report), 0)
        return True


def obey(mouse: Mouse, line: str) -> object:
    order, *rest = line.split()
    if order == "send":
        mouse.reports.append(bytes.fromhex(rest[0]))
    elif order == "unplug":
        mouse.plugged = False
    elif order == "waiting":
        return len(mouse.reports)
    return None


def main() -> None:
    testbed = UMockdev.Testbed.new()
    testbed.add_from_string(DEVICE)
    mouse = Mouse()
    testbed.attach_ioctl(NODE, mouse)
    # hidapi polls before it reads. Nobody takes this byte, so that the poll always says yes.
    os.write(testbed.get_dev_fd(NODE), b"\0")
    loop = GLib.MainLoop()

    def on_line(source: int, condition: GLib.IOCondition) -> bool:
        line = sys.stdin.readline()
        if not line:
            loop.quit()
            return False
        print(json.dumps(obey(mouse, line)), flush=True)
        return True

    GLib.io_add_watch(0, GLib.IO_IN | GLib.IO_HUP, on_line)
    print(testbed.get_root_dir(), flush=True)
    loop.run()


if __name__ == "__main__":
    main()
