# Specula @VERSION_TEXT@: @NAME@_ip as a module for LiteX.
"""In a SoC:

    self.shader = @CLASS@(platform)
    self.bus.add_slave("shader", self.shader.bus, SoCRegion(origin=None, size=0x1000, cached=False))

`sink` takes span packets, `source` gives pixels, and `bus` has the registers; @NAME@.md describes all
three. `python3 @NAME@_litex.py` writes the module alone as @NAME@_litex.v, with the ports of @NAME@_ip.
"""
from pathlib import Path

from litex.gen import LiteXModule
from litex.soc.interconnect import stream
from litex.soc.interconnect.axi import AXILiteInterface
from migen import ClockDomain, ClockSignal, Instance, ResetSignal, Signal
from migen.fhdl.verilog import convert

SOURCES = ["@NAME@.v", "@NAME@_axis.v", "@NAME@_regs.v", "@NAME@_ip.v"]


class @CLASS@(LiteXModule):
    """Span packets in, a word a transfer, and pixels out."""

    def __init__(self, platform=None, log2_depth=@LOG2_DEPTH@):
        # `last` marks the last word of a packet, and the last pixel of a span.
        self.sink = stream.Endpoint([("data", @WORD@)])
        self.source = stream.Endpoint([("data", @PIXEL_BITS@), ("begins_frame", 1)])
        self.bus = AXILiteInterface(data_width=32, address_width=32)
        bus = self.bus
        self.specials += Instance(
            "@NAME@_ip",
            p_LOG2_DEPTH=log2_depth,
            i_aclk=ClockSignal(),
            i_aresetn=~ResetSignal(),
            i_s_axis_tdata=self.sink.data,
            i_s_axis_tvalid=self.sink.valid,
            o_s_axis_tready=self.sink.ready,
            i_s_axis_tlast=self.sink.last,
            o_m_axis_tdata=self.source.data,
            o_m_axis_tvalid=self.source.valid,
            i_m_axis_tready=self.source.ready,
            o_m_axis_tuser=self.source.begins_frame,
            o_m_axis_tlast=self.source.last,
            i_s_axi_awaddr=bus.aw.addr[:12],
            i_s_axi_awvalid=bus.aw.valid,
            o_s_axi_awready=bus.aw.ready,
            i_s_axi_wdata=bus.w.data,
            i_s_axi_wstrb=bus.w.strb,
            i_s_axi_wvalid=bus.w.valid,
            o_s_axi_wready=bus.w.ready,
            o_s_axi_bresp=bus.b.resp,
            o_s_axi_bvalid=bus.b.valid,
            i_s_axi_bready=bus.b.ready,
            i_s_axi_araddr=bus.ar.addr[:12],
            i_s_axi_arvalid=bus.ar.valid,
            o_s_axi_arready=bus.ar.ready,
            o_s_axi_rdata=bus.r.data,
            o_s_axi_rresp=bus.r.resp,
            o_s_axi_rvalid=bus.r.valid,
            i_s_axi_rready=bus.r.ready,
        )
        if platform is not None:
            folder = Path(__file__).resolve().parent
            for name in SOURCES:
                platform.add_source(str(folder / name))


class Alone(LiteXModule):
    """The module between the ports of @NAME@_ip."""

    def __init__(self):
        self.cd_sys = ClockDomain()
        self.shader = shader = @CLASS@()
        self.ports = set()

        def port(name, signal, comes_in):
            outer = Signal(len(signal), name=name)
            self.ports.add(outer)
            self.comb += signal.eq(outer) if comes_in else outer.eq(signal)

        port("aclk", self.cd_sys.clk, True)
        reset = Signal()
        self.comb += self.cd_sys.rst.eq(~reset)
        port("aresetn", reset, True)
        for prefix, endpoint, is_input in [("s_axis", shader.sink, True),
                                           ("m_axis", shader.source, False)]:
            port(f"{prefix}_tdata", endpoint.data, is_input)
            port(f"{prefix}_tvalid", endpoint.valid, is_input)
            port(f"{prefix}_tready", endpoint.ready, not is_input)
            port(f"{prefix}_tlast", endpoint.last, is_input)
        port("m_axis_tuser", shader.source.begins_frame, False)
        for prefix, channel, fields, is_input in [
            ("aw", shader.bus.aw, ["addr"], True),
            ("w", shader.bus.w, ["data", "strb"], True),
            ("b", shader.bus.b, ["resp"], False),
            ("ar", shader.bus.ar, ["addr"], True),
            ("r", shader.bus.r, ["data", "resp"], False),
        ]:
            for field in fields:
                signal = getattr(channel, field)
                port(f"s_axi_{prefix}{field}", signal[:12] if field == "addr" else signal, is_input)
            port(f"s_axi_{prefix}valid", channel.valid, is_input)
            port(f"s_axi_{prefix}ready", channel.ready, not is_input)


if __name__ == "__main__":
    alone = Alone()
    convert(alone, alone.ports, name="@NAME@_litex").write("@NAME@_litex.v")
