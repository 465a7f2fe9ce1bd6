//! Pictures as files, SVG or PNG by their ending.

use std::io::Write as _;
use std::path::{Path, PathBuf};

use super::png;
use crate::flight_log::{OutputError, check_writable, write_whole};

/// Why a picture was not written.
#[derive(Debug, thiserror::Error)]
pub enum PictureError {
    /// The file cannot be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The file's ending names no format.
    #[error("{} ends neither in .svg nor in .png: choose one of these endings", path.display())]
    UnknownFormat {
        /// The path as given.
        path: PathBuf,
    },
    /// The picture could not be turned into pixels.
    #[error("the picture could not be drawn as PNG ({reason}): write an .svg file instead")]
    Rendering {
        /// What the renderer said.
        reason: String,
    },
}

#[derive(Clone, Copy)]
enum Format {
    Svg,
    Png,
}

impl Format {
    fn of(path: &Path) -> Result<Self, PictureError> {
        match path.extension() {
            Some(ending) if ending.eq_ignore_ascii_case("svg") => Ok(Self::Svg),
            Some(ending) if ending.eq_ignore_ascii_case("png") => Ok(Self::Png),
            _ => Err(PictureError::UnknownFormat { path: path.to_owned() }),
        }
    }
}

/// Checks that a picture can be written to `path` (ending and folder), without creating it.
pub(crate) fn check(path: &Path) -> Result<(), PictureError> {
    Format::of(path)?;
    Ok(check_writable(path)?)
}

/// Writes a picture to `path`, in the format of its ending. The file appears only when it is whole.
pub(crate) fn write(svg: &str, path: &Path) -> Result<(), PictureError> {
    let encoded;
    let bytes = match Format::of(path)? {
        Format::Svg => svg.as_bytes(),
        Format::Png => {
            encoded = png::encode(svg)?;
            &encoded
        }
    };
    write_whole::<OutputError>(path, |file| {
        file.write_all(bytes).map_err(|source| OutputError::Interrupted { path: path.to_owned(), source })
    })?;
    Ok(())
}
