//! How often the host works in a run.
use std::sync::atomic::{AtomicUsize, Ordering};

use specula_scene::load;
use specula_sim::SpanSource;
use specula_spec::{Method, SceneCore};
use specula_testbench::{Bench, EngineKind, FrameSpans};

/// Counts how often each span is set up.
struct Counted<'a> {
    spans: FrameSpans<'a>,
    set_ups: Vec<AtomicUsize>,
}

impl SpanSource for Counted<'_> {
    fn count(&self) -> usize {
        self.spans.count()
    }

    fn length(&self, index: usize) -> u32 {
        self.spans.length(index)
    }

    fn append_inputs(&self, index: usize, inputs: &mut Vec<i64>) {
        self.set_ups[index].fetch_add(1, Ordering::Relaxed);
        self.spans.append_inputs(index, inputs);
    }
}

/// Engine, bit-true model and both pictures have to do with it, in batches, blocks and threads.
#[test]
fn a_span_is_set_up_once_in_a_run() {
    for (scene, method) in
        [("teapot", Method::Lyon), ("torus", Method::Slerp), ("lamps", Method::Phong)]
    {
        let loaded = load(scene, Some((320, 240))).unwrap();
        let spec = loaded.core_spec(Some(method)).unwrap();
        let bench = Bench::new(&loaded.frame, &spec, "core").unwrap();
        let spans = FrameSpans::new(&loaded.frame, &spec);
        let set_ups = loaded.frame.spans.iter().map(|_| AtomicUsize::new(0)).collect();
        let counted = Counted { spans, set_ups };
        let outcome = bench.run_given(&counted, EngineKind::Fast, &mut |_, _| ()).unwrap();
        assert_eq!(outcome.fault(), None);
        let set_ups: Vec<usize> =
            counted.set_ups.into_iter().map(AtomicUsize::into_inner).collect();
        assert_eq!(set_ups, vec![1; loaded.frame.spans.len()]);
        let own = bench.run(EngineKind::Fast, &mut |_, _| ()).unwrap();
        assert_eq!(own.simulated, outcome.simulated);
    }
}
