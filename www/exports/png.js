/**
 * What a picture of dots says of itself: chunks of text in a PNG file, UTF-8 with a keyword each (`iTXt`), and how large its
 * dots are (`pHYs`).
 *
 * @typedef {import("./colophon.js").Colophon} Colophon
 */

/** The signature, and the first chunk, which is always of this length. */
const HEAD = 8 + 25;
/** CSS pixels of an inch, and inches of a metre. */
const DOTS = 96;
const INCHES = 1 / 0.0254;

/**
 * @param {Uint8Array} png
 * @param {Colophon} of
 * @param {number} density  Pixels of the picture a CSS pixel.
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function described(png, of, density) {
  const texts = {
    Title: of.title,
    Description: of.summary,
    Software: `gear-bifurcations ${of.version} (commit ${of.commit})`,
    Source: of.link,
    "Creation Time": of.saved,
    "gear-bifurcations": JSON.stringify(of),
  };
  const dots = new DataView(new ArrayBuffer(9));
  const perMetre = Math.round(density * DOTS * INCHES);
  dots.setUint32(0, perMetre);
  dots.setUint32(4, perMetre);
  dots.setUint8(8, 1);
  const chunks = [chunk("pHYs", new Uint8Array(dots.buffer)), ...Object.entries(texts).map(([keyword, words]) => chunk("iTXt", international(keyword, words)))];
  return joined([png.subarray(0, HEAD), ...chunks, png.subarray(HEAD)]);
}

/**
 * Not compressed, no language, no other keyword.
 *
 * @param {string} keyword
 * @param {string} words
 */
function international(keyword, words) {
  return new TextEncoder().encode(`${keyword}\0\0\0\0\0${words.replaceAll("\0", " ")}`);
}

/**
 * @param {string} type
 * @param {Uint8Array} content
 */
function chunk(type, content) {
  const body = joined([new TextEncoder().encode(type), content]);
  const ends = new DataView(new ArrayBuffer(8));
  ends.setUint32(0, content.length);
  ends.setUint32(4, checksum(body));
  return joined([new Uint8Array(ends.buffer, 0, 4), body, new Uint8Array(ends.buffer, 4, 4)]);
}

/** CRC-32, as PNG has it. @param {Uint8Array} bytes */
function checksum(bytes) {
  let sum = 0xffffffff;
  for (const byte of bytes) {
    sum ^= byte;
    for (let bit = 0; bit < 8; bit += 1) sum = sum & 1 ? (sum >>> 1) ^ 0xedb88320 : sum >>> 1;
  }
  return (sum ^ 0xffffffff) >>> 0;
}

/** @param {readonly Uint8Array[]} parts @returns {Uint8Array<ArrayBuffer>} */
function joined(parts) {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
