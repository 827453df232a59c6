//! `specula reproduce`.
use crate::program::Place;

/// What is checked in is what the program writes.
#[test]
fn the_document_is_what_it_writes() {
    let place = Place::new();
    let printed = place.succeeds(&["reproduce", "-o", "out"]);
    assert_eq!(std::fs::read_to_string(place.path("out/reproduction.md")).unwrap(), printed);
    assert_eq!(std::fs::read_to_string("../docs/reproduction.md").unwrap(), printed);
    let of_lyon = place.succeeds(&["reproduce", "lyon"]);
    assert!(of_lyon.contains("| lyon |") && !of_lyon.contains("| hast |"), "{of_lyon}");
}
