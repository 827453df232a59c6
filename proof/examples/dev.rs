use std::time::Duration;
use rayon::prelude::*;
use specula_datapath::Builder;
use specula_proof::{Detail, Standing, answered, questions};
fn main() {
    let arguments: Vec<String> = std::env::args().collect();
    let scene = specula_scene::load(&arguments[1], None).unwrap();
    use specula_spec::SceneCore;
    let method = *specula_spec::Method::ALL.iter().find(|m| m.name() == arguments[2]).unwrap();
    let spec = scene.core_spec(Some(method)).unwrap().specialised(&scene.frame);
    let graph = specula_hdl::cores::graph(&spec, |f| Builder::new("core", f)).unwrap();
    let coarse = questions(&graph, Detail::Unit);
    let fine = questions(&graph, Detail::Narrowings);
    if let Some(which) = arguments.get(3) {
        let (path, signal) = which.split_once(' ').unwrap();
        for q in coarse.iter().chain(&fine).filter(|q| q.path == path && q.signal == signal) {
            println!("{:?} {:?} fact {:?}", q.stated, graph.real(q.real).rule, q.fact);
            for a in &q.alternatives { for s in &a.cases { println!("{}{}", s.open(&s.goals), s.stated(&s.goals)); } }
        }
        return;
    }
    let begun = std::time::Instant::now();
    let answers: Vec<_> = coarse.par_iter().zip(&fine).map(|(q, f)| answered(q, f, Duration::from_secs(5))).collect();
    let mut counts = std::collections::BTreeMap::new();
    for (q, a) in coarse.iter().zip(answers) {
        match a {
            Err(e) => println!("{} {} ERROR {e}", q.path, q.signal),
            Ok(a) => for o in a.outcomes {
                *counts.entry((o.about, o.standing)).or_insert(0) += 1;
                if o.standing != Standing::Proven || arguments.len() > 4 {
                    println!("{} {} {:?} {:?} stated [{:e} {:e}] found {:?} {:?}", q.path, q.signal, o.about, o.standing, o.stated.low, o.stated.high, o.found.map(|i| (i.low, i.high)), o.premises);
                }
            }
        }
    }
    println!("{} questions, {counts:?}, {:?}", coarse.len(), begun.elapsed());
}
