//! A zip file whose bytes depend on nothing but its contents: no time of writing, no owner, entries in the order given.

use flate2::{Compression, Crc, write::DeflateEncoder};
use std::io::Write;

/// 1 January 1980, the first day that the format knows, as it writes days; hours are 0.
const DAY: u16 = 1 << 5 | 1;
/// Deflate, and names in UTF-8.
const VERSION: u16 = 20;
const UTF8: u16 = 1 << 11;
const DEFLATE: u16 = 8;

/// Packs files under their names.
pub fn packed(files: &[(String, Vec<u8>)]) -> Vec<u8> {
    let (mut whole, mut directory) = (Vec::new(), Vec::new());
    for (name, content) in files {
        let mut crc = Crc::new();
        crc.update(content);
        let deflated = deflated(content);
        let mut header = Vec::new();
        for part in [VERSION, UTF8, DEFLATE, 0, DAY] {
            header.extend(part.to_le_bytes());
        }
        for part in [crc.sum(), length(&deflated), length(content)] {
            header.extend(part.to_le_bytes());
        }
        header.extend(short(name.len()).to_le_bytes());
        header.extend([0, 0]);
        let offset = length(&whole);
        directory.extend(*b"PK\x01\x02");
        directory.extend(VERSION.to_le_bytes());
        directory.extend(&header);
        // No comment, first disk, no attributes.
        directory.extend([0; 10]);
        directory.extend(offset.to_le_bytes());
        directory.extend(name.as_bytes());
        whole.extend(*b"PK\x03\x04");
        whole.extend(header);
        whole.extend(name.as_bytes());
        whole.extend(deflated);
    }
    let (start, size, count) = (length(&whole), length(&directory), short(files.len()));
    whole.extend(directory);
    whole.extend(*b"PK\x05\x06\0\0\0\0");
    for number in [count, count] {
        whole.extend(number.to_le_bytes());
    }
    whole.extend(size.to_le_bytes());
    whole.extend(start.to_le_bytes());
    whole.extend([0, 0]);
    whole
}

fn deflated(content: &[u8]) -> Vec<u8> {
    let mut encoder = DeflateEncoder::new(Vec::new(), Compression::best());
    // Writing to memory cannot fail.
    encoder.write_all(content).and_then(|()| encoder.finish()).unwrap_or_default()
}

/// Our files are some megabytes; the format ends at four gigabytes.
fn length(bytes: &[u8]) -> u32 {
    u32::try_from(bytes.len()).unwrap_or(u32::MAX)
}

/// Names and numbers of files are far below the format's limit.
fn short(number: usize) -> u16 {
    u16::try_from(number).unwrap_or(u16::MAX)
}

#[cfg(test)]
mod tests {
    use super::packed;
    use flate2::read::DeflateDecoder;
    use std::io::Read;

    #[test]
    fn what_is_packed_is_there_under_its_name_and_always_in_the_same_bytes() {
        let files = [("a/ö.txt".to_owned(), b"hello hello hello hello".to_vec()), ("b".to_owned(), vec![])];
        let zip = packed(&files);
        assert_eq!(zip, packed(&files));
        assert!(zip.starts_with(b"PK\x03\x04"));
        let end = &zip[zip.len() - 22..];
        assert_eq!((&end[..4], end[8], end[10]), (&b"PK\x05\x06"[..], 2, 2));
        let number =
            |at: usize| u32::from_le_bytes([zip[at], zip[at + 1], zip[at + 2], zip[at + 3]]) as usize;
        let (deflated, plain, name) = (number(18), number(22), usize::from(zip[26]));
        assert_eq!(&zip[30..30 + name], "a/ö.txt".as_bytes());
        let mut text = String::new();
        DeflateDecoder::new(&zip[30 + name..30 + name + deflated]).read_to_string(&mut text).unwrap();
        assert_eq!((text.as_str(), text.len()), ("hello hello hello hello", plain));
        let directory = number(zip.len() - 6);
        assert_eq!(&zip[directory..directory + 4], b"PK\x01\x02");
    }
}
