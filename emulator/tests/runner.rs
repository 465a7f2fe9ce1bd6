//! What the example that runs an ELF says, and how it ends.
use std::path::PathBuf;
use std::process::{Command, Output};
use std::sync::OnceLock;

/// The example, built where it is missing.
fn runner() -> &'static PathBuf {
    static RUNNER: OnceLock<PathBuf> = OnceLock::new();
    RUNNER.get_or_init(|| {
        let test = std::env::current_exe().expect("this test");
        let path = test.ancestors().nth(2).expect("a profile's folder").join("examples/run");
        if !path.exists() {
            let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
            let built = Command::new(cargo).args(["build", "-p", "emulator", "--example", "run"]).status();
            assert!(built.expect("cargo runs").success());
        }
        path
    })
}

fn run(arguments: &[&str]) -> (Option<i32>, String) {
    let Output { status, stderr, .. } = Command::new(runner()).args(arguments).output().expect("it runs");
    (status.code(), String::from_utf8_lossy(&stderr).into_owned())
}

/// A program in RAM as an ELF: machine code behind a vector table whose handlers are all the second word of code.
fn program(name: &str, machine: u16, code: &[u16]) -> String {
    const AT: u32 = 0x2000_0000;
    let words = |words: &[u32]| words.iter().flat_map(|word| word.to_le_bytes()).collect::<Vec<u8>>();
    let mut image = words(&[AT + 0x8000, AT + 0x41]);
    // b . behind the code stands for every handler.
    let handler = AT + 0x40 + 2 * code.len() as u32;
    image.extend(words(&[handler | 1; 14]));
    image.extend(code.iter().chain(&[0xE7FE, 0xBF00]).flat_map(|half| half.to_le_bytes()));
    let mut elf = b"\x7FELF\x01\x01\x01\0\0\0\0\0\0\0\0\0\x02\0".to_vec();
    elf.extend(machine.to_le_bytes());
    elf.extend(words(&[1, AT + 0x41, 52, 0, 0x0500_0200]));
    elf.extend([52_u16, 32, 1, 40, 0, 0].iter().flat_map(|half| half.to_le_bytes()));
    let length = image.len() as u32;
    elf.extend(words(&[1, 84, AT, AT, length, length, 5, 4]));
    elf.extend(image);
    let path = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::write(&path, elf).expect("a writable folder");
    path.to_str().expect("a plain path").to_owned()
}

#[test]
fn wrong_arguments_are_refused_with_a_reason() {
    for (arguments, part) in [
        (&[][..], "which ELF?"),
        (&["--fast", "x"], "there is no option `--fast`"),
        (&["--seconds", "soon", "x"], "`soon`"),
        (&["--seconds", "-1", "x"], "`-1`"),
        (&["--seconds", "inf", "x"], "`inf`"),
        (&["--seconds"], "needs a number"),
        (&["a", "b"], "one ELF at a time"),
        (&["/nowhere/at-all"], "/nowhere/at-all: "),
    ] {
        let (code, said) = run(arguments);
        assert_eq!(code, Some(2), "{arguments:?}");
        assert!(said.starts_with("error: ") && said.contains(part), "{arguments:?}: {said}");
    }
    assert_eq!(run(&["--help"]), (Some(0), String::new()));
}

#[test]
fn an_image_for_something_else_is_refused() {
    let (code, said) = run(&[&program("intel", 3, &[0xE7FE])]);
    assert_eq!(code, Some(2));
    assert!(said.contains("this is an ELF for Intel 80386, not for ARM"), "{said}");
}

#[test]
fn a_program_that_runs_on_is_told_from_one_that_stands_in_a_fault() {
    let (code, said) = run(&["--seconds", "0.01", &program("endless", 40, &[0xE7FE])]);
    assert_eq!(code, Some(124), "{said}");
    assert!(said.contains("time is up") && said.contains("no symbol _SEGGER_RTT"), "{said}");
    // movs r0, #0x40; lsls r0, r0, #24; adds r0, #0x54... : ldr r1, [r0] with r0 = 0x40005400.
    let code = &[0x2040, 0x0600, 0x2154, 0x0209, 0x1840, 0x6801];
    let (code, said) = run(&["--seconds", "0.01", &program("fault", 40, code)]);
    assert_eq!(code, Some(101), "{said}");
    assert!(said.contains("stands in the handler of a fault: data access without an answer"), "{said}");
    assert!(said.contains("to 0x40005400 (I2C1, which is not emulated)"), "{said}");
}
