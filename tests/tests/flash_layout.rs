//! Where the image lies in flash.

use mintime::firmware_image::FirmwareImage;

/// Sectors 1 and 2 of the F405 (RM0090 table 5).
const STORE: std::ops::Range<u32> = 0x0800_4000..0x0800_C000;

/// A probe or a boot loader erases the sectors that it writes: the store must be none of them.
#[test]
fn no_piece_of_the_image_touches_the_store() {
    let image = FirmwareImage::build(&mut |_| {}).expect("the firmware builds");
    let pieces = emulator::machine::loaded(image.elf()).expect("an image");
    assert!(pieces.len() >= 2, "{pieces:x?}");
    for &(address, bytes) in &pieces {
        let end = address + bytes as u32;
        assert!(end <= STORE.start || address >= STORE.end, "{address:#x}..{end:#x}");
    }
    assert!(pieces.iter().any(|(address, _)| *address == 0x0800_0000), "the vector table: {pieces:x?}");
    let content = emulator::machine::flash_content(image.elf()).expect("an image");
    let gap = &content[STORE.start as usize - 0x0800_0000..STORE.end as usize - 0x0800_0000];
    assert!(gap.iter().all(|byte| *byte == 0xFF), "erased, as the board finds it");
    assert_eq!(image.flash_bytes(), pieces.iter().map(|(_, bytes)| bytes).sum::<usize>());
    assert!(image.flash_bytes() <= 128 * 1024, "{}", image.flash_bytes());
}
