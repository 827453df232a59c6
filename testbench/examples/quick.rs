//! Ad hoc.
use specula_hdl::*;
use specula_scene::*;
use specula_sim::*;
use specula_testbench::*;
use std::time::Instant;
fn main() {
    let loaded = load("teapot", Some((640, 480))).unwrap();
    let spec = loaded.core_spec(Some(Method::Lyon)).unwrap();
    let bench = Bench::new(&loaded.frame, &spec, "teapot").unwrap();
    let spans = FrameSpans::new(&loaded.frame, &spec);
    let t = Instant::now();
    let packets: Vec<SpanPacket> = (0..spans.count()).map(|i| spans.packet(i)).collect();
    println!(
        "{} spans {} pixels, packets {:?}, {} nodes",
        packets.len(),
        loaded.frame.shaded_pixels(),
        t.elapsed(),
        bench.design.nodes.len()
    );
    let st = Stimulus::whole(&packets, &bench.design);
    let t = Instant::now();
    let n: usize = st.stretches().map(|s| s.inputs.len()).sum();
    println!("stretches {:?} {n}", t.elapsed());
    for _ in 0..3 {
        let short = Stimulus::whole(&packets, &bench.design).leading_to(&(0..100), &bench.design);
        let t = Instant::now();
        Fast::new(&bench.design).run(&short, &bench.design.outputs, &mut |_| Flow::Continue).unwrap();
        println!("start {:?}", t.elapsed());
    }
    for batch in [256, 512, 1024] {
        let mut e = Fast::with_settings(&bench.design, fast::Settings { batch, level: fast::Level::best() });
        let mut best = f64::MAX;
        for _ in 0..60 {
            let t = Instant::now();
            e.run(&st, &bench.design.outputs, &mut |_| Flow::Continue).unwrap();
            best = best.min(t.elapsed().as_secs_f64());
        }
        let mut all = f64::MAX;
        let nodes: Vec<_> = bench.design.iter().filter(|(_, n)| !matches!(n.op, design::Op::Constant(_))).map(|(i, _)| i).collect();
        for _ in 0..0 {
            let t = Instant::now();
            e.run(&st, &nodes, &mut |_| Flow::Continue).unwrap();
            all = all.min(t.elapsed().as_secs_f64());
        }
        let c = (st.clocks().end) as f64;
        println!("batch {batch}: outputs {:.1} ns/clock, all {:.1} ns/clock", best * 1e9 / c, all * 1e9 / c);
    }
}
