//! `specula wave`: where dumps come from, what is compressed, and what lies beside them.
use std::io::Write;
use std::process::Command;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;

use crate::program::Place;

const VCD: &[u8] = include_bytes!("../../../wave/tests/data/wave/counter.vcd");
const FST: &[u8] = include_bytes!("../../../wave/tests/data/wave/counter.fst");
/// GHDL wrote it, data/wave/states.vhdl says how; it is compressed as a whole.
const STATES: &[u8] = include_bytes!("../../../wave/tests/data/wave/states.fst");
/// As GHDL and nvc leave an FST file: one bit that changes every 10 ns.
const SMALL: &str = "\
/gAAAAAAAAC1AAAAAAAAAeofiwgAAAAAAAADY2AAA0ZPCA0HGpnhIt1c+1kdQBwOhDgjLvp7WnFJ\
eFFmSWoRVITeILg0T8Evv0zByFLBwMDKyNTK1FjByMDIjAtdIY0ALJCCUESBIQmlWRkZGSsYoxgY\
2FjYWJihgowMXEAAU4FOw1RJQml4YDOyQFlGUJpPvhtqP/Pv4wGT4g8cUDgw4cSBEx/kGVqyIvv4\
gBIA4XZCkuoBAAA=";

fn gzip(bytes: &[u8]) -> Vec<u8> {
    let mut packed = GzEncoder::new(vec![], Compression::default());
    packed.write_all(bytes).expect("memory can be written");
    packed.finish().expect("memory can be written")
}

/// As GHDL and nvc wrap an FST file, which states these lengths.
fn wrapped(packed: &[u8], block: u64, length: u64) -> Vec<u8> {
    [&[254][..], &block.to_be_bytes(), &length.to_be_bytes(), packed].concat()
}

#[test]
fn files_that_are_compressed_as_a_whole_are_unpacked() {
    let place = Place::new();
    place.write("small.fst", STANDARD.decode(SMALL).expect("it is base64"));
    let small = place.succeeds(&["wave", "small.fst"]);
    assert!(
        small.contains("  a  __________\u{2594}\u{2594}\u{2594}\u{2594}\u{2594}\u{2594}\u{2594}\u{2594}\u{2594}\u{2594}__________"),
        "{small}"
    );
    place.write("states.fst", STATES);
    insta::assert_snapshot!("states", place.succeeds(&["wave", "states.fst", "--width", "70"]));
    place.write("counter.fst", FST);
    place.write("counter.vcd", VCD);
    let open = [place.succeeds(&["wave", "counter.fst"]), place.succeeds(&["wave", "counter.vcd"])];
    let packed = gzip(FST);
    place.write("counter.fst", wrapped(&packed, packed.len() as u64 + 16, FST.len() as u64));
    place.write("counter.vcd", gzip(VCD));
    assert_eq!(
        [place.succeeds(&["wave", "counter.fst"]), place.succeeds(&["wave", "counter.vcd"])],
        open
    );
}

#[test]
fn wrappers_that_state_wrong_lengths_are_refused() {
    let packed = gzip(FST);
    let (block, length) = (packed.len() as u64 + 16, FST.len() as u64);
    let cases = [
        ("an end that is missing", wrapped(&packed[..packed.len() / 2], block, length)),
        ("a block that ends nowhere", wrapped(&packed, u64::MAX, length)),
        ("a block of nothing", wrapped(&packed, 1, length)),
        ("more than it holds", wrapped(&packed, block, length + 1)),
        ("more than any file holds", wrapped(&packed, block, u64::MAX)),
        ("less than it holds", wrapped(&packed, block, length / 2)),
        ("noise", wrapped(&[&packed[..10], &[7; 200]].concat(), 226, length)),
        ("a wrapper in a wrapper", {
            let inner = wrapped(&packed, block, length);
            let packed = gzip(&inner);
            wrapped(&packed, packed.len() as u64 + 16, inner.len() as u64)
        }),
        ("a simulation that has not ended", wrapped(&packed, 0, length)),
    ];
    let place = Place::new();
    let refused = cases.map(|(name, bytes)| {
        place.write("x.fst", bytes);
        let ended = place.specula(&["wave", "x.fst"]);
        assert_eq!((ended.status, ended.stdout.as_str()), (Some(2), ""), "{name}");
        let said: Vec<&str> = ended
            .stderr
            .split_whitespace()
            .filter(|word| !"\u{d7}\u{2502}".contains(word))
            .collect();
        format!("{name}: {}", said.join(" "))
    });
    insta::assert_snapshot!("wrappers", refused.join("\n"));
}

#[test]
fn standard_input_is_read() {
    let place = Place::new();
    for (name, bytes) in [("counter.vcd", VCD), ("counter.fst", FST), ("states.fst", STATES)] {
        place.write(name, bytes);
        let from_file = place.succeeds(&["wave", name]);
        let ended = place.specula_reading(name, &["wave", "-"]);
        assert_eq!((ended.status, ended.stderr.as_str()), (Some(0), ""), "{name}");
        assert_eq!(ended.stdout, from_file.replace(name, "standard input"));
    }
    place.write("empty", "");
    assert_eq!(place.specula_reading("empty", &["wave", "-"]).status, Some(2));
}

#[cfg(unix)]
#[test]
fn devices_without_an_end_are_no_dumps() {
    let place = Place::new();
    for device in ["/dev/zero", "/dev/urandom", "/dev/null"] {
        assert_eq!(place.specula(&["wave", device]).status, Some(2), "{device}");
    }
}

#[cfg(unix)]
fn pipe(place: &Place, name: &str) {
    let made = Command::new("mkfifo").arg(place.path(name)).status().expect("mkfifo runs");
    assert!(made.success());
}

#[cfg(unix)]
#[test]
fn named_pipes_are_read_and_not_waited_for_for_ever() {
    let place = Place::new();
    pipe(&place, "counter.vcd");
    place.write("copy.vcd", VCD);
    let expected = place.succeeds(&["wave", "copy.vcd"]).replace("copy.vcd", "counter.vcd");
    let path = place.path("counter.vcd");
    let writer = std::thread::spawn(move || std::fs::write(path, VCD));
    assert_eq!(place.succeeds(&["wave", "counter.vcd"]), expected);
    writer.join().expect("it does not panic").expect("somebody reads");
    let ended = place.specula(&["wave", "counter.vcd"]);
    assert_eq!(ended.status, Some(2));
    assert!(ended.stderr.contains("a pipe into which no program wrote"), "{}", ended.stderr);
}

#[cfg(unix)]
#[test]
fn pictures_are_written_through_links_and_into_no_device() {
    use std::os::unix::fs::symlink;
    let place = Place::new();
    place.write("counter.vcd", VCD);
    std::fs::create_dir(place.path("disk")).expect("a folder can be made");
    place.write("disk/old.svg", "old");
    symlink("disk/old.svg", place.path("link.svg")).expect("a link can be made");
    place.succeeds(&["wave", "counter.vcd", "-o", "link.svg"]);
    assert!(place.path("link.svg").is_symlink());
    let picture = std::fs::read_to_string(place.path("disk/old.svg")).expect("it is there");
    assert!(picture.starts_with("<svg"), "{picture}");
    pipe(&place, "pipe.png");
    symlink("/dev/null", place.path("null.svg")).expect("a link can be made");
    for name in ["pipe.png", "null.svg"] {
        let ended = place.specula(&["wave", "counter.vcd", "-o", name]);
        assert_eq!(ended.status, Some(2), "{name}");
        assert!(ended.stderr.contains("not a regular file"), "{}", ended.stderr);
        assert!(!place.path(name).metadata().expect("it is there").is_file(), "{name}");
    }
    assert_eq!(place.names("disk"), ["old.svg"]);
}

#[cfg(unix)]
#[test]
fn save_files_are_read_if_they_are_files() {
    use std::os::unix::fs::symlink;
    let place = Place::new();
    for name in ["device", "pipe", "folder", "latin"] {
        place.write(&format!("{name}.vcd"), VCD);
    }
    symlink("/dev/zero", place.path("device.gtkw")).expect("a link can be made");
    pipe(&place, "pipe.gtkw");
    std::fs::create_dir(place.path("folder.gtkw")).expect("a folder can be made");
    place.write("latin.gtkw", b"[*] caf\xe9\n@24\nbench.dut.count[3:0]\n");
    for name in ["device", "pipe", "folder"] {
        let ended = place.specula(&["wave", &format!("{name}.vcd")]);
        assert_eq!(ended.status, Some(0), "{name}");
        let told = format!(
            "warning: `{name}.vcd`: the save file beside it is passed over: it is not a regular file\n"
        );
        assert_eq!(ended.stderr, told);
        assert!(ended.stdout.contains("count hex"), "{}", ended.stdout);
    }
    assert!(place.succeeds(&["wave", "latin.vcd"]).contains("count U4.0"));
}
