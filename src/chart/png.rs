//! Images of few colours as PNG in a data address, for SVG: ISO/IEC 15948 with the compression of RFC 1951 in its
//! simplest form, which is short where neighbours are alike.

use super::surface::Image;

/// Longest run of equal bytes that one code stands for.
const LONGEST: usize = 258;

/// The letters of base 64, RFC 4648.
const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// A PNG as the value of an `href`.
pub fn data_address(image: &Image<'_>) -> String {
    let bytes = png(image);
    let mut text = String::with_capacity(bytes.len() * 4 / 3 + 32);
    text.push_str("data:image/png;base64,");
    for three in bytes.chunks(3) {
        let at = |index: usize| u32::from(three.get(index).copied().unwrap_or(0));
        let all = at(0) << 16 | at(1) << 8 | at(2);
        for (index, shift) in [18, 12, 6, 0].into_iter().enumerate() {
            let letter = LETTERS[(all >> shift & 63) as usize];
            text.push(if index > three.len() { '=' } else { char::from(letter) });
        }
    }
    text
}

fn png(image: &Image<'_>) -> Vec<u8> {
    let columns = image.columns.max(1);
    let rows = image.pixels.len() / columns;
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = Vec::new();
    header.extend((columns as u32).to_be_bytes());
    header.extend((rows as u32).to_be_bytes());
    // Eight bits an index, colours from a table.
    header.extend([8, 3, 0, 0, 0]);
    chunk(&mut file, *b"IHDR", &header);
    // The index after the last colour is what is not painted.
    let mut table: Vec<u8> = image.colors.iter().flat_map(|color| [color.0, color.1, color.2]).collect();
    table.extend([0, 0, 0]);
    chunk(&mut file, *b"PLTE", &table);
    let mut opacity = vec![255; image.colors.len()];
    opacity.push(0);
    chunk(&mut file, *b"tRNS", &opacity);
    let clear = image.colors.len() as u8;
    let mut lines = Vec::with_capacity((columns + 1) * rows);
    for row in image.pixels.chunks_exact(columns) {
        lines.push(0);
        lines.extend(row.iter().map(|&index| index.min(clear)));
    }
    chunk(&mut file, *b"IDAT", &compressed(&lines));
    chunk(&mut file, *b"IEND", &[]);
    file
}

fn chunk(file: &mut Vec<u8>, name: [u8; 4], content: &[u8]) {
    file.extend((content.len() as u32).to_be_bytes());
    let start = file.len();
    file.extend(name);
    file.extend(content);
    let sum = check_sum(&file[start..]);
    file.extend(sum.to_be_bytes());
}

/// The cyclic redundancy check of PNG, bit by bit.
fn check_sum(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(u32::MAX, |sum, &byte| {
        (0..8).fold(
            sum ^ u32::from(byte),
            |sum, _| {
                if sum & 1 == 1 { sum >> 1 ^ 0xEDB8_8320 } else { sum >> 1 }
            },
        )
    })
}

/// Bits, least significant first, as RFC 1951 packs them.
#[derive(Default)]
struct Bits {
    bytes: Vec<u8>,
    held: u32,
    count: u32,
}

impl Bits {
    fn push(&mut self, value: u32, length: u32) {
        self.held |= value << self.count;
        self.count += length;
        while self.count >= 8 {
            self.bytes.push(self.held as u8);
            self.held >>= 8;
            self.count -= 8;
        }
    }

    /// A code of the fixed table for a byte (0 to 255), the end (256) or a length (257 to 285): most significant first.
    fn symbol(&mut self, symbol: u32) {
        let (code, length) = match symbol {
            0..=143 => (0x30 + symbol, 8),
            144..=255 => (0x190 + symbol - 144, 9),
            256..=279 => (symbol - 256, 7),
            _ => (0xC0 + symbol - 280, 8),
        };
        self.push(code.reverse_bits() >> (32 - length), length);
    }

    /// `run` times the byte before, 3 to 258.
    fn repeat(&mut self, run: u32) {
        let (symbol, extra, length) = match run {
            LONGEST_RUN => (285, 0, 0),
            3..=10 => (254 + run, 0, 0),
            _ => {
                // Four codes to each number of further bits, from 11 on.
                let bits = (run - 3).ilog2() - 2;
                let group = (run - 3) >> bits;
                (257 + 4 * bits + group, (run - 3) & ((1 << bits) - 1), bits)
            }
        };
        self.symbol(symbol);
        self.push(extra, length);
        // Distance 1: five bits of nought.
        self.push(0, 5);
    }
}

const LONGEST_RUN: u32 = LONGEST as u32;

fn compressed(bytes: &[u8]) -> Vec<u8> {
    let mut bits = Bits { bytes: vec![0x78, 0x01], ..Bits::default() };
    // The last block, with the fixed codes.
    bits.push(0b011, 3);
    let mut at = 0;
    while at < bytes.len() {
        bits.symbol(u32::from(bytes[at]));
        let byte = bytes[at];
        at += 1;
        loop {
            let run = bytes[at..].iter().take(LONGEST).take_while(|&&next| next == byte).count();
            if run < 3 {
                break;
            }
            bits.repeat(run as u32);
            at += run;
        }
    }
    bits.symbol(256);
    bits.push(0, 7);
    let mut packed = bits.bytes;
    let (mut low, mut high) = (1_u32, 0_u32);
    for &byte in bytes {
        low = (low + u32::from(byte)) % 65_521;
        high = (high + low) % 65_521;
    }
    packed.extend((high << 16 | low).to_be_bytes());
    packed
}

#[cfg(test)]
mod tests {
    use super::{Image, check_sum, compressed, data_address};
    use crate::chart::theme::Color;

    #[test]
    fn the_check_sum_is_that_of_the_standard() {
        // The chunk that ends every PNG.
        assert_eq!(check_sum(b"IEND"), 0xAE42_6082);
    }

    /// Shortest run of each length code, RFC 1951 section 3.2.5.
    const BASE: [usize; 29] = [
        3, 4, 5, 6, 7, 8, 9, 10, 11, 13, 15, 17, 19, 23, 27, 31, 35, 43, 51, 59, 67, 83, 99, 115, 131, 163,
        195, 227, 258,
    ];
    /// Further bits of each.
    const FURTHER: [u32; 29] =
        [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3, 4, 4, 4, 4, 5, 5, 5, 5, 0];

    /// Undoes [`compressed`], with a decoder of its own for the fixed codes.
    fn expanded(packed: &[u8]) -> Vec<u8> {
        let mut at = 16 + 3;
        let bit = |at: &mut usize| {
            let value = packed[*at / 8] >> (*at % 8) & 1;
            *at += 1;
            u32::from(value)
        };
        let mut bytes: Vec<u8> = Vec::new();
        loop {
            let mut code = 0;
            let mut length = 0;
            let symbol = loop {
                code = code << 1 | bit(&mut at);
                length += 1;
                match (length, code) {
                    (7, 0..=23) => break 256 + code,
                    (8, 0x30..=0xBF) => break code - 0x30,
                    (8, 0xC0..=0xC7) => break 280 + code - 0xC0,
                    (9, 0x190..=0x1FF) => break 144 + code - 0x190,
                    (10.., _) => panic!("no code"),
                    _ => {}
                }
            };
            if symbol < 256 {
                bytes.push(symbol as u8);
                continue;
            }
            if symbol == 256 {
                return bytes;
            }
            let index = (symbol - 257) as usize;
            let extra = (0..FURTHER[index]).fold(0, |sum, place| sum | bit(&mut at) << place);
            let distance = (0..5).fold(0, |sum, _| sum << 1 | bit(&mut at));
            assert_eq!(distance, 0, "distance 1");
            let last = *bytes.last().expect("something to repeat");
            bytes.extend(vec![last; BASE[index] + extra as usize]);
        }
    }

    #[test]
    fn runs_of_every_length_come_back() {
        for run in 1..=700 {
            let mut bytes = vec![7];
            bytes.extend(vec![200; run]);
            bytes.extend([1, 2, 3, 255, 144, 143]);
            let packed = compressed(&bytes);
            assert_eq!(expanded(&packed), bytes, "{run}");
            assert!(packed.len() < 40);
        }
    }

    #[test]
    fn an_image_is_a_data_address() {
        let image = Image { pixels: &[0, 1, 255, 0], columns: 2, colors: &[Color(1, 2, 3), Color(4, 5, 6)] };
        let text = data_address(&image);
        assert!(text.starts_with("data:image/png;base64,iVBORw0KGgo"), "{text}");
        assert_eq!((text.len() - "data:image/png;base64,".len()) % 4, 0);
    }
}
