//! The firmware image that the virtual board runs: a file, or built from the sources that this command was built from.

use std::path::{Path, PathBuf};
use std::process::Command;

use sha2::{Digest, Sha256};

/// The chip's target.
const TARGET: &str = "thumbv7em-none-eabihf";
/// The workspace's profile for the board.
const PROFILE: &str = "firmware";
/// Main memory, where the statics lie; the core-coupled memory, which holds the flight record, is elsewhere.
const MAIN_MEMORY: core::ops::Range<u32> = 0x2000_0000..0x2002_0000;
/// Package and binary.
const PACKAGE: &str = "mintime-firmware";

/// An image, ready to be loaded.
#[derive(Clone, Debug)]
pub struct FirmwareImage {
    elf: Vec<u8>,
    content: Vec<u8>,
    flash_bytes: usize,
    ram_bytes: usize,
    path: PathBuf,
}

/// Why there is no image.
#[derive(Debug, thiserror::Error)]
pub enum FirmwareImageError {
    /// The file cannot be read.
    #[error("{path} cannot be read ({source}): give the ELF that `cargo firmware` builds")]
    Read {
        /// Its path.
        path: PathBuf,
        /// What the system said.
        source: std::io::Error,
    },
    /// The file is no program for this chip.
    #[error("{path} is no firmware image ({reason}): give the ELF that `cargo firmware` builds")]
    Content {
        /// Its path.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The sources are gone.
    #[error(
        "the firmware's sources are not at {0} any more: give an image with --firmware FILE, or fly with --vehicle hosted"
    )]
    NoSources(PathBuf),
    /// A tool is missing.
    #[error("`{tool}` cannot be run ({source}): {advice}")]
    Tool {
        /// Which.
        tool: &'static str,
        /// What the system said.
        source: std::io::Error,
        /// What to do.
        advice: &'static str,
    },
    /// The target could not be installed.
    #[error("the compiler's target {TARGET} is missing and could not be installed: {0}")]
    Target(String),
    /// The build failed.
    #[error("the firmware does not build:\n{0}")]
    Build(String),
}

impl FirmwareImage {
    /// Reads an image.
    ///
    /// # Errors
    /// [`FirmwareImageError::Read`], [`FirmwareImageError::Content`].
    pub fn read(path: &Path) -> Result<Self, FirmwareImageError> {
        let elf = std::fs::read(path)
            .map_err(|source| FirmwareImageError::Read { path: path.to_owned(), source })?;
        let refuse = |error: emulator::machine::ImageError| FirmwareImageError::Content {
            path: path.to_owned(),
            reason: error.to_string(),
        };
        let content = emulator::machine::flash_content(&elf).map_err(refuse)?;
        let flash_bytes =
            emulator::machine::loaded(&elf).map_err(refuse)?.iter().map(|(_, bytes)| bytes).sum();
        let ram_bytes = emulator::machine::occupied(&elf)
            .map_err(refuse)?
            .iter()
            .filter_map(|(address, bytes)| MAIN_MEMORY.contains(address).then_some(bytes))
            .sum();
        Ok(Self { elf, content, flash_bytes, ram_bytes, path: path.to_owned() })
    }

    /// Builds the image from the sources beside this crate, in a target folder of its own so that no other build waits for
    /// it. Installs the compiler's target where it is missing. Fast where nothing has changed. `say` is told what
    /// takes long.
    ///
    /// # Errors
    /// [`FirmwareImageError`].
    pub fn build(say: &mut dyn FnMut(&str)) -> Result<Self, FirmwareImageError> {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap_or(Path::new("."));
        if !root.join("firmware/Cargo.toml").is_file() {
            return Err(FirmwareImageError::NoSources(root.to_owned()));
        }
        install_target(root, say)?;
        let folder = root.join("target/firmware");
        let image = folder.join(TARGET).join(PROFILE).join(PACKAGE);
        say(if image.is_file() {
            "building the firmware image"
        } else {
            "building the firmware image: one or two minutes the first time"
        });
        let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
        let output = Command::new(cargo)
            .current_dir(root)
            .args([
                "build",
                "--profile",
                PROFILE,
                "--quiet",
                "--package",
                PACKAGE,
                "--bin",
                PACKAGE,
                "--target",
                TARGET,
            ])
            .arg("--target-dir")
            .arg(&folder)
            // Flags for the host are none for the board.
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("CARGO_BUILD_TARGET")
            .output()
            .map_err(|source| FirmwareImageError::Tool {
                tool: "cargo",
                source,
                advice: "install Rust from https://rustup.rs, or give an image with --firmware FILE",
            })?;
        if !output.status.success() {
            return Err(FirmwareImageError::Build(String::from_utf8_lossy(&output.stderr).into_owned()));
        }
        Self::read(&image)
    }

    /// The ELF.
    pub fn elf(&self) -> &[u8] {
        &self.elf
    }

    /// Where it was read from.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// SHA-256 of what gets flashed, hexadecimal. It does not depend on the folder that the image was built in.
    pub fn sha256(&self) -> String {
        Sha256::digest(&self.content).iter().map(|byte| format!("{byte:02x}")).collect()
    }

    /// Bytes of flash that it takes, without the gap in which the board keeps its store.
    pub fn flash_bytes(&self) -> usize {
        self.flash_bytes
    }

    /// Bytes of main memory that its statics take, without the stack.
    pub fn ram_bytes(&self) -> usize {
        self.ram_bytes
    }
}

/// Installs the compiler's target, if it is not there yet.
fn install_target(root: &Path, say: &mut dyn FnMut(&str)) -> Result<(), FirmwareImageError> {
    let rustc = std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    let libraries = Command::new(rustc)
        .current_dir(root)
        .args(["--print", "target-libdir", "--target", TARGET])
        .output()
        .map_err(|source| FirmwareImageError::Tool {
            tool: "rustc",
            source,
            advice: "install Rust from https://rustup.rs, or give an image with --firmware FILE",
        })?;
    let folder = PathBuf::from(String::from_utf8_lossy(&libraries.stdout).trim());
    if libraries.status.success() && folder.is_dir() {
        return Ok(());
    }
    say(&format!("installing the compiler's target {TARGET}"));
    let output = Command::new("rustup").current_dir(root).args(["target", "add", TARGET]).output().map_err(
        |source| FirmwareImageError::Tool {
            tool: "rustup",
            source,
            advice: "install the target thumbv7em-none-eabihf for your Rust by hand",
        },
    )?;
    if output.status.success() {
        Ok(())
    } else {
        Err(FirmwareImageError::Target(String::from_utf8_lossy(&output.stderr).trim().to_owned()))
    }
}
