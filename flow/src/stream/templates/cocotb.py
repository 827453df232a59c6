# Specula @VERSION_TEXT@: a test of @NAME@_ip for cocotb 2 with cocotbext-axi.
"""Streams the packets of @NAME@_packets.hex in, with the registers of each frame written before it,
compares every pixel and place with @NAME@_pixels.hex, and writes each frame as @NAME@_frame_N.png.

`python3 test_@NAME@.py` runs it. Of the environment, SEED pauses both streams at random (1 if it is
not set, 0 for no pauses), and SIM is the simulator.
"""
import logging
import os
import random
import re
import struct
import sys
import zlib
from pathlib import Path

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import ClockCycles, with_timeout
from cocotb_tools.check_results import get_results
from cocotb_tools.runner import get_runner
from cocotbext.axi import (AxiLiteBus, AxiLiteMaster, AxiStreamBus, AxiStreamFrame, AxiStreamSink,
                           AxiStreamSource)

NAME = "@NAME@"
PERIOD_NS = 10
# Clocks for a frame's registers, and for the pixels of a span, before the test gives up.
PATIENCE = 100_000

IDENTITY, CORE, STATUS, FRAMES, PIXELS = 0x00, 0x08, 0x14, 0x18, 0x1C


@cocotb.test()
async def every_pixel_is_the_models(dut):
    """Every pixel of every frame is as the model says, whatever the streams do."""
    frames = read_frames(len(dut.s_axis_tdata), len(dut.m_axis_tdata))
    cocotb.start_soon(Clock(dut.aclk, PERIOD_NS, "ns").start())
    bench = Bench(dut, int(os.environ.get("SEED", "1")))
    await bench.reset()
    for address, expected in [(IDENTITY, 0x@IDENTITY@), (CORE, 0x@CORE@)]:
        check(await bench.registers.read_dword(address), expected, f"register 0x{address:02x}")
    sending = cocotb.start_soon(bench.send(frames))
    count = 0
    for number, frame in enumerate(frames):
        seen = []
        for span in frame.spans:
            received = await bench.receive()
            for place, (pixel, expected) in enumerate(zip(received, span.pixels)):
                check(pixel, expected, f"pixel {count + place}, at {span.x + place}, {span.y}")
            check(len(received), len(span.pixels), f"pixels of the span behind pixel {count}")
            seen.append((span.x, span.y, [pixel.colour for pixel in received]))
            count += len(received)
        write_png(f"{NAME}_frame_{number}.png", seen)
    await sending
    check(await bench.registers.read_dword(PIXELS), count, "register `pixels`")
    check(await bench.registers.read_dword(STATUS), 0, "register `status`")
    dut._log.info("PASS: %d pixels in %d frames, seed %d", count, len(frames), bench.seed)


class Bench:
    """The block with a source of packets, a sink of pixels and a master of registers."""

    def __init__(self, dut, seed):
        self.dut, self.seed = dut, seed
        clock_and_reset = (dut.aclk, dut.aresetn, False)
        packets, pixels = [AxiStreamBus.from_prefix(dut, name) for name in ["s_axis", "m_axis"]]
        # A transfer is a word, or a pixel, and not a number of bytes.
        self.source = AxiStreamSource(packets, *clock_and_reset, byte_lanes=1)
        self.sink = AxiStreamSink(pixels, *clock_and_reset, byte_lanes=1)
        self.registers = AxiLiteMaster(AxiLiteBus.from_prefix(dut, "s_axi"), *clock_and_reset)
        for part in [self.source, self.sink, self.registers.write_if, self.registers.read_if]:
            part.log.setLevel(logging.WARNING)
        if seed:
            self.source.set_pause_generator(pauses(2 * seed))
            self.sink.set_pause_generator(pauses(2 * seed + 1))

    async def reset(self):
        self.dut.aresetn.value = 0
        await ClockCycles(self.dut.aclk, 4)
        self.dut.aresetn.value = 1
        await ClockCycles(self.dut.aclk, 2)

    async def send(self, frames):
        """Writes the registers of each frame when the one before has begun, and sends its spans."""
        for number, frame in enumerate(frames):
            while await self.registers.read_dword(FRAMES) < number:
                pass
            for address, word in frame.writes:
                await self.registers.write_dword(address, word)
            for span in frame.spans:
                await self.source.send(AxiStreamFrame(span.words))

    async def receive(self):
        """The pixels up to the next `tlast`."""
        pixels = await with_timeout(self.sink.recv(compact=False), PATIENCE * PERIOD_NS, "ns")
        ends = [0] * (len(pixels.tdata) - 1) + [1]
        return [Pixel(*pixel) for pixel in zip(pixels.tuser, ends, pixels.tdata)]


class Pixel:
    """A pixel of the output stream."""

    def __init__(self, begins_frame, ends_span, data):
        self.begins_frame, self.ends_span, self.data = begins_frame, ends_span, data

    @property
    def colour(self):
        """Red, green and blue, a byte each."""
        return (self.data & 0xFFFFFF).to_bytes(3, "little")

    def __eq__(self, other):
        return str(self) == str(other)

    def __str__(self):
        data = f"#{self.colour.hex()}"
        if self.data >> 24:
            data += f" at {self.data >> 24 & 0xFFFF}, {self.data >> 40}"
        return f"{data} (tuser {self.begins_frame}, tlast {self.ends_span})"


class Span:
    """The words of a packet and the pixels that have to come out."""

    def __init__(self, x, y, words, pixels):
        self.x, self.y, self.words, self.pixels = x, y, words, pixels


class Frame:
    """Register writes and the spans that follow them."""

    def __init__(self):
        self.writes, self.spans = [], []


def check(value, expected, what):
    """Ends the test where a value is not as expected."""
    assert value == expected, f"FAIL: {what}: {value}, not {expected}"


def pauses(seed):
    """In which clocks a stream pauses: how often changes every 64 clocks, up to nearly always."""
    generator = random.Random(seed)
    while True:
        share = generator.choice([0, generator.random()])
        for _ in range(64):
            yield generator.random() < share


def read_frames(word_bits, pixel_bits):
    """The frames of the vectors."""
    frames, pixels = [], iter(read_pixels(pixel_bits))
    # Two bits above each word tell the first one of a frame and the last one of a packet.
    words = []
    for line in open(f"{NAME}_packets.hex"):
        if place := re.match(r"// \d+ pixels from (\d+), (\d+) on", line):
            x, y = map(int, place.groups())
        elif not line.startswith("//"):
            value = int(line, 16)
            if value >> (word_bits + 1):
                frames.append(Frame())
            words.append(value & ((1 << word_bits) - 1))
            if value >> word_bits & 1:
                count = words[0] & 0xFFFF
                span = Span(x, y, words, [next(pixels) for _ in range(count)])
                frames[-1].spans.append(span)
                words = []
    if os.path.exists(f"{NAME}_registers.hex"):
        for line in open(f"{NAME}_registers.hex"):
            if not line.startswith("//"):
                value = int(line, 16)
                frames[value >> 48].writes.append((value >> 32 & 0xFFFF, value & 0xFFFFFFFF))
    return frames


def read_pixels(pixel_bits):
    """Every pixel that has to come out. Two bits above each are its `tuser` and its `tlast`."""
    values = [int(line, 16) for line in open(f"{NAME}_pixels.hex") if not line.startswith("//")]
    data = (1 << pixel_bits) - 1
    return [Pixel(v >> (pixel_bits + 1), v >> pixel_bits & 1, v & data) for v in values]


def write_png(path, spans):
    """Writes spans of colours as a picture that is as large as they reach."""
    width = max(x + len(colours) for x, _, colours in spans)
    height = max(y for _, y, _ in spans) + 1
    rows = [bytearray(3 * width) for _ in range(height)]
    for x, y, colours in spans:
        rows[y][3 * x:3 * (x + len(colours))] = b"".join(colours)
    chunks = [
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)),
        (b"IDAT", zlib.compress(b"".join(b"\0" + row for row in rows))),
        (b"IEND", b""),
    ]
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in chunks:
            file.write(struct.pack(">I", len(data)) + kind + data)
            file.write(struct.pack(">I", zlib.crc32(kind + data)))


def run():
    """Builds the simulation and runs it; how many tests fail."""
    # FuseSoC puts sources into a folder of their own.
    sources = [next(Path().rglob(f"{NAME}{part}.v")) for part in ["", "_axis", "_regs", "_ip"]]
    runner = get_runner(os.environ.get("SIM", "icarus"))
    top = f"{NAME}_ip"
    runner.build(sources=sources, hdl_toplevel=top, timescale=("1ns", "1ps"), always=True)
    results = runner.test(hdl_toplevel=top, test_module=Path(__file__).stem, test_dir=".")
    return get_results(results)[1]


if __name__ == "__main__":
    sys.exit(run())
