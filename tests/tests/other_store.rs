//! Why the store is the project's own: `sequential-storage`, the well-known crate for this, on flash whose erase is cut short.
//!
//! An erase that loses its supply leaves some cells as they were and others blank or anything. Where the first and the last
//! word of a page are among those that still read as written, the crate takes the page for a whole one. Found in 8.0.2; should
//! this test fail with a later one, the crate has become a choice.

use std::future::Future;
use std::pin::pin;
use std::task::{Context, Poll, Waker};

use embedded_storage_async::nor_flash::{
    ErrorType, NorFlash, NorFlashError, NorFlashErrorKind, ReadNorFlash,
};
use sequential_storage::cache::{Cache, Uncached};
use sequential_storage::map::{MapConfig, MapStorage};

/// Two sectors as the board has them.
const SECTOR_BYTES: usize = 16 * 1024;
const BYTES: usize = 2 * SECTOR_BYTES;

/// Flash that can lose its supply in an erase.
#[derive(Clone)]
struct Flash {
    bytes: Vec<u8>,
    /// Cut the next erase: what is left of it is everything but the two words at the sector's ends.
    cut: bool,
    off: bool,
    erases: Vec<usize>,
}

#[derive(Debug)]
struct Off;

impl NorFlashError for Off {
    fn kind(&self) -> NorFlashErrorKind {
        NorFlashErrorKind::Other
    }
}

impl ErrorType for Flash {
    type Error = Off;
}

impl ReadNorFlash for Flash {
    const READ_SIZE: usize = 1;

    async fn read(&mut self, offset: u32, bytes: &mut [u8]) -> Result<(), Off> {
        let from = offset as usize;
        bytes.copy_from_slice(&self.bytes[from..from + bytes.len()]);
        if self.off { Err(Off) } else { Ok(()) }
    }

    fn capacity(&self) -> usize {
        BYTES
    }
}

impl NorFlash for Flash {
    const WRITE_SIZE: usize = 4;
    const ERASE_SIZE: usize = SECTOR_BYTES;

    async fn erase(&mut self, from: u32, to: u32) -> Result<(), Off> {
        let (from, to) = (from as usize, to as usize);
        assert!(from.is_multiple_of(SECTOR_BYTES) && to - from == SECTOR_BYTES);
        if self.off {
            return Err(Off);
        }
        self.erases.push(from / SECTOR_BYTES);
        self.off = std::mem::take(&mut self.cut);
        let kept = if self.off { Self::WRITE_SIZE } else { 0 };
        self.bytes[from + kept..to - kept].fill(0xFF);
        if self.off { Err(Off) } else { Ok(()) }
    }

    async fn write(&mut self, offset: u32, bytes: &[u8]) -> Result<(), Off> {
        if self.off {
            return Err(Off);
        }
        let from = offset as usize;
        for (cell, byte) in self.bytes[from..from + bytes.len()].iter_mut().zip(bytes) {
            *cell &= byte;
        }
        Ok(())
    }
}

type Map = MapStorage<u8, Flash, Cache<Uncached, Uncached, Uncached, u8>>;

fn map(flash: Flash) -> Map {
    MapStorage::new(flash, MapConfig::new(0..BYTES as u32), Cache::new_uncached())
}

/// Nothing here ever waits.
fn now<T>(future: impl Future<Output = T>) -> T {
    match pin!(future).poll(&mut Context::from_waker(Waker::noop())) {
        Poll::Ready(done) => done,
        Poll::Pending => panic!("it waits"),
    }
}

fn store(map: &mut Map, key: u8, value: &[u8]) -> bool {
    now(map.store_item(&mut [0; 512], &key, &value)).is_ok()
}

fn fetch(map: &mut Map, key: u8) -> Option<Vec<u8>> {
    now(map.fetch_item::<&[u8]>(&mut [0; 512], &key)).ok().flatten().map(<[u8]>::to_vec)
}

/// The vehicle file, written once and never touched again, is lost by a cut while another key is written.
#[test]
fn an_erase_cut_short_loses_what_was_confirmed() {
    let blank = Flash { bytes: vec![0xFF; BYTES], cut: false, off: false, erases: Vec::new() };
    let mut map_before = map(blank);
    let vehicle = [7; 84];
    assert!(store(&mut map_before, 1, &vehicle));
    // Until a page is full, what is alive has moved and the page left behind is to be erased.
    map_before.flash().cut = true;
    let mut written = 0;
    while store(&mut map_before, 2, &[written; 200]) {
        written += 1;
        assert_eq!(fetch(&mut map_before, 1).as_deref(), Some(&vehicle[..]));
        assert!(written < 250, "no erase");
    }
    // The supply comes back.
    let (mut flash, _) = map_before.destroy();
    assert!(flash.off && flash.erases.len() == 1, "{:?}", flash.erases);
    flash.off = false;
    let erased = flash.erases[0];
    let mut after = map(flash);
    let found = fetch(&mut after, 1);
    let again = store(&mut after, 2, &[written; 200]);
    let later = fetch(&mut after, 1);
    assert!(found.is_some() && again, "it reads, and it writes");
    assert_eq!(later, None, "the crate has kept it");
    // It erased the page that held everything, to make it anew from the one whose erase was cut.
    assert_eq!(after.flash().erases[1], 1 - erased);
}
