//! Pages of made-up reports.
use std::io;

use super::*;

/// A temporary folder that has every file that is asked for.
struct Folder(tempfile::TempDir);

impl ReportFiles for Folder {
    type Error = io::Error;

    fn content(&self, name: &str) -> io::Result<Option<Vec<u8>>> {
        let path = self.0.path().join(name);
        path.is_file().then(|| std::fs::read(path)).transpose()
    }
}

fn folder() -> Folder {
    let folder = tempfile::tempdir().expect("there is room");
    std::fs::write(folder.path().join("a.png"), [1, 2, 3]).expect("there is room");
    std::fs::write(folder.path().join("b.svg"), "<svg><title>x</title></svg>\n")
        .expect("there is room");
    Folder(folder)
}

fn rendered(markdown: &str) -> String {
    render(markdown, &folder()).expect("files can be read")
}

#[test]
fn what_is_shown_is_in_the_page() {
    assert_eq!(
        rendered("![a \"name\"](a.png)"),
        "<p><img src=\"data:image/png;base64,AQID\" alt=\"a &quot;name&quot;\"></p>\n"
    );
    assert_eq!(
        rendered("[![b](b.svg)](b.svg)"),
        "<p><span class=\"drawing\"><svg><title>x</title></svg>\n</span></p>\n"
    );
    assert_eq!(rendered("![gone](c.png)"), "<p><em>gone</em></p>\n");
}

#[test]
fn nothing_is_loaded_from_elsewhere() {
    let page = page(
        "t",
        &rendered(
            "![x](https://example.org/x.png) [y](https://example.org/y) <https://example.org/z>",
        ),
    );
    assert!(!page.contains("src=\"http") && !page.contains("href="), "{page}");
}

#[test]
fn names_are_no_markup() {
    let name = "<script>alert(1)</script> & <b>.obj";
    let body = rendered(&format!("# {name}\n\n{name}\n\n`{name}`\n\n<div>\n{name}\n</div>\n"));
    assert!(!body.contains("<script") && !body.contains("<b>") && !body.contains("<div"), "{body}");
    assert!(
        body.contains("&lt;script&gt;")
            && body
                .contains("<code>&lt;script&gt;alert(1)&lt;/script&gt; &amp; &lt;b&gt;.obj</code>"),
        "{body}"
    );
    assert!(
        page(name, "")
            .contains("<title>&lt;script&gt;alert(1)&lt;/script&gt; &amp; &lt;b&gt;.obj</title>")
    );
}

#[test]
fn viewers_hold_each_picture_once() {
    let picture = |name| Picture { name, description: "what it is", png: vec![1, 2, 3] };
    let html = viewer(&[picture("one"), picture("two")]);
    assert_eq!(html.matches("data:image/png;base64,AQID").count(), 2);
    assert_eq!(html.matches("<option value=\"1\" selected>two</option>").count(), 1);
}
