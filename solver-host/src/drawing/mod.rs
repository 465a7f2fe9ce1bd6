//! What all pictures share: SVG text, plots with axes, legends, colours, tables, the vehicle seen from the side, and files.
//!
//! The SVG asks for common sans-serif fonts by name. The PNG is drawn with Noto Sans, embedded from the crate
//! `ttf-noto-sans` (the font is licensed under Apache-2.0, Copyright 2012 Google Inc.; the crate carries the licence
//! text), and with no font of the machine, so that it looks the same everywhere and works where there are none. A
//! font of our own strokes would have saved 400 kB and cost legibility, kerning and every letter we forgot.

pub(crate) mod axis;
pub(crate) mod csv;
pub(crate) mod file;
pub(crate) mod legend;
pub(crate) mod page;
pub(crate) mod plot;
pub(crate) mod png;
pub(crate) mod style;
pub(crate) mod svg;
pub(crate) mod symbol;

pub use file::PictureError;
pub use png::PNG_SCALE;
