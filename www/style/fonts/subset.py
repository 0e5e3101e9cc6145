#!/usr/bin/env python3
"""Make the shipped faces and the metric table from the full STIX Two Text.

    npm pack @expo-google-fonts/stix-two-text @expo-google-fonts/stix-two-math   # the complete faces, OFL
    mkdir text math; tar xzf *text*.tgz -C text; tar xzf *math*.tgz -C math
    pip install fonttools brotli
    python3 subset.py text/package math/package ../../../src/chart/metrics/table.rs

Writes regular.woff2, italic.woff2, bold.woff2, signs.woff2 and math.woff2 beside this script, and the table of advance widths.
The text faces have no arrows and no relations but = < >; signs.woff2 brings these from the mathematical face. math.woff2 is
that face for the page's equations: their letters, and the table by which browsers place roots and fractions.
"""

import sys
from pathlib import Path

from fontTools import subset
from fontTools.ttLib import TTFont

HERE = Path(__file__).resolve().parent

FACES = [
    ("regular", "400Regular/STIXTwoText_400Regular.ttf"),
    ("italic", "400Regular_Italic/STIXTwoText_400Regular_Italic.ttf"),
    ("bold", "700Bold/STIXTwoText_700Bold.ttf"),
]

MATH = "400Regular/STIXTwoMath_400Regular.ttf"

LATIN = [*range(0x20, 0x7F), *range(0xA0, 0x100)]
GREEK = [c for c in range(0x391, 0x3CA) if c != 0x3A2] + [0x3D1, 0x3D5, 0x3D6, 0x3F1, 0x3F5]
# Dashes, quotes, primes, dots, minus, relations, arrows and the few signs a figure of mathematics needs.
SIGNS = [ord(c) for c in "‐–—‘’‚“”„†‡•…‰′″‴⁄−∕∂∆∏∑√∞∫≈≠≡≤≥±×·÷→←↑↓↔⇒∈∝∓∘⟨⟩ℓ€™  "]
# Advance widths are tabled for all of these.
CHARACTERS = sorted(set(LATIN + GREEK + SIGNS))

# The woff2 files hold fewer: what the page and its figures say, and what a reader of western Europe writes into them. Each letter
# costs every visitor some ninety bytes a face; one that is missing is shown in the system's serif.
ACCENTED = [ord(c) for c in "ÄÖÜäöüßÅåÆæØøÉéÈèÊêËëÁáÀàÂâÇçÍíÎîÏïÑñÓóÔôÚúÛû§°«»©µ²³¹½¼·±×÷\u00a0"]
SHIPPED_GREEK = {
    "regular": "Ωαβγδεζηθλμξπρστφψω",
    "italic": "ΔΣΩαβγδεζηθλμξπρστφψωϕ",
    "bold": "Ωαβζω",
}


def shipped(face: str) -> list[int]:
    """The characters of one of the text faces."""
    greek = [ord(c) for c in SHIPPED_GREEK[face]]
    return sorted({*range(0x20, 0x7F), *ACCENTED, *greek, *SIGNS})


# Letters and signs of the page's equations; tests/browser/story.spec.js finds those that are missing.
MATH_ITALIC = "abcdfgijkmqrtuxBCEFHIJKMRTWZ"
MATH_GREEK = "Ωαβδζθλσψω"
MATH_UPRIGHT = "{˙¨acdefgijlmnopqrstuxBCDLRT0123456789()[]|+=<>,.;:'-/  −±·×′…√"
# Signs that stretch: all other variants of glyphs are left out.
STRETCHED = "√(){|"


def math_italic(letter: str) -> int:
    """Where browsers look for a single letter of an equation."""
    if letter == "h":
        return 0x210E
    for first, italic in (("A", 0x1D434), ("a", 0x1D44E), ("Α", 0x1D6E2), ("α", 0x1D6FC)):
        if ord(first) <= ord(letter) < ord(first) + 26:
            return italic + ord(letter) - ord(first)
    raise ValueError(letter)


def shrink_math(source: Path, target: Path) -> None:
    """The mathematical face for equations, with its table of constants."""
    font = TTFont(source)
    names = font.getBestCmap()
    stretched = {names[ord(c)] for c in STRETCHED}
    variants = font["MATH"].table.MathVariants
    for way in ("Vert", "Horiz"):
        coverage = getattr(variants, f"{way}GlyphCoverage")
        kept = [
            (glyph, built)
            for glyph, built in zip(coverage.glyphs, getattr(variants, f"{way}GlyphConstruction"))
            if glyph in stretched
        ]
        coverage.glyphs = [glyph for glyph, _ in kept]
        setattr(variants, f"{way}GlyphConstruction", [built for _, built in kept])
        setattr(variants, f"{way}GlyphCount", len(kept))
    for table in ("GSUB", "GPOS", "GDEF"):
        del font[table]
    options = subset.Options()
    options.flavor = "woff2"
    options.hinting = False
    options.notdef_outline = False
    options.name_IDs = [0, 1, 2, 13, 14]
    cutter = subset.Subsetter(options)
    letters = [math_italic(c) for c in MATH_ITALIC + MATH_GREEK]
    cutter.populate(unicodes=sorted({*letters, *map(ord, MATH_UPRIGHT), *SIGNS} & set(names)))
    cutter.subset(font)
    subset.save_font(font, str(target), options)


def shrink(source: Path, target: Path, characters: list[int]) -> None:
    """Subset one face to the characters, keeping kerning and common ligatures for running text."""
    options = subset.Options()
    options.flavor = "woff2"
    options.hinting = False
    options.desubroutinize = True
    options.drop_tables += ["MATH"]
    options.layout_features = ["kern", "liga", "mark", "locl", "ccmp"]
    options.name_IDs = [0, 1, 2, 3, 4, 5, 6, 13, 14]
    font = subset.load_font(str(source), options)
    cutter = subset.Subsetter(options)
    cutter.populate(unicodes=characters)
    cutter.subset(font)
    subset.save_font(font, str(target), options)


def advances(source: Path) -> dict[int, int]:
    """Advance width of each character of the face, in thousandths of an em."""
    font = TTFont(source)
    names, widths, em = font.getBestCmap(), font["hmtx"], font["head"].unitsPerEm
    return {c: round(1000 * widths[names[c]][0] / em) for c in CHARACTERS if c in names}


def rows(widths: dict[int, int], face: str, meaning: str) -> list[str]:
    """One face as runs of neighbouring characters: where a run begins, and its widths."""
    runs: list[tuple[int, list[int]]] = []
    for code in sorted(widths):
        if runs and runs[-1][0] + len(runs[-1][1]) == code:
            runs[-1][1].append(widths[code])
        else:
            runs.append((code, [widths[code]]))
    lines = [f"/// {meaning}", "#[rustfmt::skip]", f"pub(super) const {face}: &[(u32, &[u16])] = &["]
    for start, run in runs:
        lines.append(f"    ({start:#06x}, &[")
        for i in range(0, len(run), 18):
            lines.append("        " + " ".join(f"{w}," for w in run[i : i + 18]))
        lines.append("    ]),")
    return [*lines, "];", ""]


def main() -> None:
    text, math, table = Path(sys.argv[1]), Path(sys.argv[2]) / MATH, Path(sys.argv[3])
    lines = ["//! Advance widths of STIX Two Text in thousandths of an em; written by `www/style/fonts/subset.py`.", ""]
    covered: set[int] = set()
    for face, path in FACES:
        shrink(text / path, HERE / f"{face}.woff2", shipped(face))
        widths = advances(text / path)
        covered |= set(widths)
        lines += rows(widths, face.upper(), f"The {face} face: first character of a run, widths of the run.")
    shrink(math, HERE / "signs.woff2", [c for c in CHARACTERS if c not in covered])
    shrink_math(math, HERE / "math.woff2")
    signs = {c: w for c, w in advances(math).items() if c not in covered}
    lines += rows(signs, "SIGNS", "Arrows and relations, from the mathematical face.")
    print("unicode-range:", ", ".join(f"U+{c:04X}" for c in sorted(signs)))
    table.parent.mkdir(parents=True, exist_ok=True)
    table.write_text("\n".join(lines).rstrip() + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
