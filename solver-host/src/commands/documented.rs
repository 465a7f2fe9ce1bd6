//! Every command line that the documentation shows is one that the command takes.

use std::path::Path;

use clap::Parser as _;

use crate::Arguments;

/// The arguments of a shell's line, without what follows a `#` that stands alone. Quotes hold words together.
fn words(line: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut quote = None;
    for c in line.chars() {
        match (quote, c) {
            (Some(open), _) if c == open => quote = None,
            (None, '"' | '\'') => quote = Some(c),
            (None, ' ') => words.push(String::new()),
            _ => words.last_mut().expect("there is always a word").push(c),
        }
    }
    words.into_iter().filter(|word| !word.is_empty()).take_while(|word| word != "#").collect()
}

/// The command lines in a page's code blocks, fenced or indented. A line with a placeholder in the reader's own words
/// (`…`, alternatives) is none.
fn command_lines(text: &str) -> Vec<String> {
    let mut fenced = false;
    let mut lines = Vec::new();
    for line in text.lines() {
        let fence = line.trim_start().starts_with("```");
        fenced ^= fence;
        if fence || !(fenced || line.starts_with("    ")) {
            continue;
        }
        let line = line.trim().trim_start_matches("$ ");
        let command = line
            .strip_prefix("mintime ")
            .or_else(|| line.strip_prefix("cargo run --release -- "))
            .filter(|rest| rest.starts_with(|c: char| c.is_ascii_lowercase()));
        if let Some(command) = command
            && !command.contains(['…', '|', '[', '>', '\\'])
            && !command.starts_with("firmware")
        {
            lines.push(command.to_owned());
        }
    }
    lines
}

#[test]
fn every_documented_command_line_is_understood() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate lies in the workspace");
    let docs = std::fs::read_dir(root.join("docs")).expect("docs is a folder");
    let mut pages: Vec<_> = docs.map(|entry| entry.expect("can be listed").path()).collect();
    pages.push(root.join("README.md"));
    let mut wrong = Vec::new();
    let mut checked = 0;
    for page in pages.iter().filter(|page| page.extension().is_some_and(|ending| ending == "md")) {
        for line in command_lines(&std::fs::read_to_string(page).expect("a page can be read")) {
            checked += 1;
            let arguments = std::iter::once("mintime".to_owned()).chain(words(&line));
            match Arguments::try_parse_from(arguments) {
                Err(error) if error.use_stderr() => {
                    wrong.push(format!("{}: mintime {line}\n{error}", page.display()))
                }
                _ => {}
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(checked > 40, "only {checked} command lines were found");
}
