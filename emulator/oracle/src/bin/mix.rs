//! What compiled code looks like: sorting, hashing, matrices in single precision, text. For measuring speed.
#![no_std]
#![no_main]

use core::{arch::global_asm, hint::black_box};
use oracle::{Hash, exit};

global_asm!(".section .vectors, \"a\"", ".word __stack", ".word reset", ".fill 14, 4, 0");

fn sort(values: &mut [u32]) {
    values.sort_unstable();
}

fn multiply(a: &[[f32; 8]; 8], b: &[[f32; 8]; 8]) -> [[f32; 8]; 8] {
    let mut product = [[0.0; 8]; 8];
    for (row, out) in a.iter().zip(product.iter_mut()) {
        for (column, cell) in out.iter_mut().enumerate() {
            *cell = row.iter().zip(b).map(|(x, y)| x * y[column]).sum();
        }
    }
    product
}

fn crc(bytes: &[u8]) -> u16 {
    bytes.iter().fold(0xFFFF, |mut crc, byte| {
        crc ^= u16::from(*byte) << 8;
        for _ in 0..8 {
            crc = if crc & 0x8000 != 0 { crc << 1 ^ 0x1021 } else { crc << 1 };
        }
        crc
    })
}

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    let mut hash = Hash::default();
    let mut state = 1_u32;
    let mut values = [0_u32; 512];
    for _ in 0..400 {
        for value in &mut values {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            *value = state;
        }
        sort(black_box(&mut values));
        hash.add(values[7]);
        let mut a = [[0.0; 8]; 8];
        for (n, cell) in a.iter_mut().flatten().enumerate() {
            *cell = (values[n] >> 8) as f32 * 1e-7;
        }
        let mut b = a;
        for _ in 0..10 {
            b = multiply(black_box(&a), black_box(&b));
            let scale = b[0][0].abs() + 1.0;
            for cell in b.iter_mut().flatten() {
                *cell /= scale;
            }
        }
        hash.add(b[3][4].to_bits());
        let bytes: [u8; 256] = core::array::from_fn(|n| values[n] as u8);
        hash.add(u32::from(crc(black_box(&bytes))));
        hash.add((values[1] / (values[0] >> 20 | 1)).wrapping_add(values[2] % (values[3] >> 16 | 1)));
    }
    hash.print("mix");
    exit(0)
}
