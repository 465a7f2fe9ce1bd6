//! Output files that are whole or absent: checked before a flight, written beside their target, then renamed.

use std::ffi::OsString;
use std::fs::{self, File, OpenOptions};
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// Why a file cannot be written. Each sentence says which path and what to do.
#[derive(Debug, thiserror::Error)]
pub enum OutputError {
    /// The path is empty or names no file.
    #[error("{path:?} names no file: give a file name")]
    NoName {
        /// The path as given.
        path: PathBuf,
    },
    /// The path is a folder.
    #[error("{} is a folder: give the name of a file in it", path.display())]
    IsFolder {
        /// The path as given.
        path: PathBuf,
    },
    /// The path is a device, a pipe or the like.
    #[error("{} is not a regular file and will not be replaced: give another name", path.display())]
    NotAFile {
        /// The path as given.
        path: PathBuf,
    },
    /// The folder that should hold the file does not exist.
    #[error("{}: the folder {} does not exist: create it or choose another", path.display(), folder.display())]
    NoFolder {
        /// The path as given.
        path: PathBuf,
        /// Its folder.
        folder: PathBuf,
    },
    /// The file exists and is read-only.
    #[error("{} exists and is read-only: make it writable, remove it or choose another name", path.display())]
    FileReadOnly {
        /// The path as given.
        path: PathBuf,
    },
    /// No file can be created in the folder.
    #[error("{}: no file can be created in the folder {} ({source}): choose another", path.display(), folder.display())]
    FolderNotWritable {
        /// The path as given.
        path: PathBuf,
        /// Its folder.
        folder: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// Writing began and failed; nothing was left behind.
    #[error("{} could not be written ({source}): check the free space of the disk", path.display())]
    Interrupted {
        /// The path as given.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
}

/// Checks that a file can be written to `path`, without creating or changing it: call it before the flight.
///
/// An existing regular file is fine, it will be replaced.
///
/// # Errors
/// The [`OutputError`] that [`write_whole`] would return, as far as it can be known beforehand.
pub fn check_writable(path: &Path) -> Result<(), OutputError> {
    let target = Target::new(path)?;
    let (_, temporary) = target.create()?;
    // The probe holds nothing; a leftover would be harmless, so a failure to remove it is no reason to refuse.
    let _ = fs::remove_file(temporary);
    Ok(())
}

/// Writes a file as a whole: `fill` writes to a temporary file in the same folder, which then replaces `path`.
/// Whatever fails, `path` keeps its old content and the temporary file is removed.
///
/// # Errors
/// An [`OutputError`] made into `E`, or what `fill` returns.
pub fn write_whole<E: From<OutputError>>(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<File>) -> Result<(), E>,
) -> Result<(), E> {
    let target = Target::new(path)?;
    let (file, temporary) = target.create()?;
    let mut writer = BufWriter::new(file);
    let written = fill(&mut writer).and_then(|()| {
        let interrupted = |source| OutputError::Interrupted { path: path.to_owned(), source };
        writer.flush().map_err(interrupted)?;
        // Closed before it is renamed: not every system renames open files.
        drop(writer);
        fs::rename(&temporary, &target.file).map_err(interrupted)?;
        Ok(())
    });
    if written.is_err() {
        let _ = fs::remove_file(&temporary);
    }
    written
}

/// Where a file is going to be: symbolic links followed, so that a rename replaces the file and not the link.
struct Target<'a> {
    given: &'a Path,
    file: PathBuf,
    folder: PathBuf,
    name: OsString,
}

impl<'a> Target<'a> {
    fn new(given: &'a Path) -> Result<Self, OutputError> {
        let path = || given.to_owned();
        if given.as_os_str().is_empty() {
            return Err(OutputError::NoName { path: path() });
        }
        let file = match fs::metadata(given) {
            Ok(found) if found.is_dir() => return Err(OutputError::IsFolder { path: path() }),
            Ok(found) if !found.is_file() => return Err(OutputError::NotAFile { path: path() }),
            Ok(found) if found.permissions().readonly() => {
                return Err(OutputError::FileReadOnly { path: path() });
            }
            Ok(_) => fs::canonicalize(given).unwrap_or_else(|_| path()),
            Err(_) => path(),
        };
        let Some(name) = file.file_name().map(OsString::from) else {
            return Err(OutputError::NoName { path: path() });
        };
        if given.as_os_str().as_encoded_bytes().ends_with(std::path::MAIN_SEPARATOR_STR.as_bytes()) {
            // `results/` without such a folder: a folder was meant.
            return Err(OutputError::NoFolder { path: path(), folder: path() });
        }
        let folder = match file.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder.to_owned(),
            _ => PathBuf::from("."),
        };
        if !folder.is_dir() {
            return Err(OutputError::NoFolder { path: path(), folder });
        }
        Ok(Self { given, file, folder, name })
    }

    /// Creates a temporary file beside the target. The name is new to the folder, and hidden on most systems.
    fn create(&self) -> Result<(File, PathBuf), OutputError> {
        let mut attempt = 0_u32;
        loop {
            let mut name = OsString::from(".");
            name.push(&self.name);
            name.push(format!(".{}-{attempt}.part", std::process::id()));
            let temporary = self.folder.join(name);
            match OpenOptions::new().write(true).create_new(true).open(&temporary) {
                Ok(file) => return Ok((file, temporary)),
                Err(e) if e.kind() == ErrorKind::AlreadyExists && attempt < 100 => attempt += 1,
                Err(source) => {
                    return Err(OutputError::FolderNotWritable {
                        path: self.given.to_owned(),
                        folder: self.folder.clone(),
                        source,
                    });
                }
            }
        }
    }
}
