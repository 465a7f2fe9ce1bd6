//! The documentation as a book: every page stands in its table of contents, and every link in it, in the README and to a heading
//! leads somewhere.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the tests lie in the workspace").to_path_buf()
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The pages of the book, by file name, without its table of contents.
fn pages() -> BTreeMap<String, String> {
    let folder = root().join("docs");
    std::fs::read_dir(&folder)
        .expect("docs is a folder")
        .map(|entry| entry.expect("can be listed").file_name().into_string().expect("a plain name"))
        .filter(|name| name.ends_with(".md") && name != "SUMMARY.md")
        .map(|name| {
            let text = read(&folder.join(&name));
            (name, text)
        })
        .collect()
}

/// A page without its code, where brackets are no links.
fn prose(text: &str) -> String {
    let mut fenced = false;
    let lines = text.lines().filter(|line| {
        let fence = line.trim_start().starts_with("```");
        fenced ^= fence;
        !fenced && !fence && !line.starts_with("    ")
    });
    // What stands between backticks is code, too.
    lines.flat_map(|line| line.split('`').step_by(2).chain(["\n"])).collect()
}

/// The targets of `[text](target)`.
fn links(text: &str) -> Vec<String> {
    let prose = prose(text);
    let targets = prose.match_indices("](").filter_map(|(at, _)| {
        let rest = &prose[at + 2..];
        rest.find(')').map(|end| rest[..end].to_owned())
    });
    targets.collect()
}

/// The anchors that headings get where the pages are read: lower case, spaces to hyphens, punctuation gone.
fn anchors(text: &str) -> BTreeSet<String> {
    let mut fenced = false;
    let mut seen = BTreeMap::<String, usize>::new();
    let mut found = BTreeSet::new();
    for line in text.lines() {
        fenced ^= line.starts_with("```");
        let hashes = line.chars().take_while(|&c| c == '#').count();
        if fenced || hashes == 0 || !line[hashes..].starts_with(' ') {
            continue;
        }
        let plain: String = line[hashes + 1..]
            .to_lowercase()
            .chars()
            .filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'))
            .map(|c| if c == ' ' { '-' } else { c })
            .collect();
        let count = seen.entry(plain.clone()).or_default();
        found.insert(if *count == 0 { plain.clone() } else { format!("{plain}-{count}") });
        *count += 1;
    }
    found
}

#[test]
fn every_page_stands_in_the_table_of_contents_once() {
    let contents = links(&read(&root().join("docs/SUMMARY.md")));
    let pages: Vec<String> = pages().into_keys().collect();
    let mut listed = contents.clone();
    listed.sort();
    assert_eq!(listed, pages, "docs/SUMMARY.md lists other pages than there are in docs");
}

/// Links to sources, like `../shared/src/frames.rs`, lead to them from the book, too: it lies beside the pages' folder.
#[test]
fn the_book_lies_where_links_to_sources_hold() {
    let settings = read(&root().join("docs/book.toml"));
    let folder = settings.lines().find_map(|line| line.strip_prefix("build-dir = ")).expect("a folder");
    let beside = folder.trim_matches('"').strip_prefix("../").expect("beside docs");
    assert!(
        !beside.contains('/') && read(&root().join(".gitignore")).lines().any(|l| l == format!("/{beside}/"))
    );
}

#[test]
fn every_link_leads_somewhere() {
    let root = root();
    let mut documents: Vec<(PathBuf, String)> =
        pages().into_iter().map(|(name, text)| (root.join("docs").join(name), text)).collect();
    documents.push((root.join("README.md"), read(&root.join("README.md"))));
    let mut dead = Vec::new();
    let mut checked = 0;
    for (path, text) in &documents {
        for link in links(text).iter().filter(|link| !link.contains("://") && !link.starts_with("mailto:")) {
            checked += 1;
            let (file, anchor) = link.split_once('#').map_or((link.as_str(), None), |(f, a)| (f, Some(a)));
            let target = if file.is_empty() {
                path.clone()
            } else {
                path.parent().expect("a file lies in a folder").join(file)
            };
            let there =
                target.exists() && anchor.is_none_or(|anchor| anchors(&read(&target)).contains(anchor));
            if !there {
                dead.push(format!("{}: {link}", path.display()));
            }
        }
    }
    assert!(dead.is_empty(), "links that lead nowhere:\n{}", dead.join("\n"));
    assert!(checked > 100, "only {checked} links were looked at");
}
