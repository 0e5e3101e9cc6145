/**
 * Label markup as elements and as plain text: `*x*` is italic, `_{..}` lowered, `^{..}` raised, `'` a prime, `\`
 * takes the next character as it is. What is not closed stays as written.
 */

const TOKEN = /\\(.)|\*([^*]+)\*|_\{([^}]*)\}|\^\{([^}]*)\}|'/gsu;

/**
 * @param {string} markup
 * @returns {DocumentFragment}
 */
export function elements(markup) {
  const fragment = document.createDocumentFragment();
  let from = 0;
  for (const match of markup.matchAll(TOKEN)) {
    fragment.append(plainSigns(markup.slice(from, match.index)));
    const [all, escaped, italic, lowered, raised] = match;
    if (escaped !== undefined) fragment.append(escaped);
    else if (italic !== undefined) fragment.append(element("i", italic));
    else if (lowered !== undefined) fragment.append(element("sub", lowered));
    else if (raised !== undefined) fragment.append(element("sup", raised));
    else fragment.append("′");
    from = match.index + all.length;
  }
  fragment.append(plainSigns(markup.slice(from)));
  return fragment;
}

/**
 * The same without any markup, for attributes and for the ear.
 *
 * @param {string} markup
 */
export function plain(markup) {
  return markup.replace(TOKEN, (all, escaped, italic, lowered, raised) =>
    all === "'" ? "′" : (escaped ?? italic ?? lowered ?? raised ?? ""),
  );
}

const NAME = /\b(Omega|alpha|zeta|lambda|epsilon)(?:_(\w+))?\b|\b([RBCu])_(\w+)\b|\bk0\b|\b[uRtT](?= =)|\b[ab](?=\^)|\^−?\d+|\b\d+(?:\.\d+)?e[-+]?\d+\b|'|-(?=[\d.])/g;
/** @type {Readonly<Record<string, string>>} */
const GREEK = { Omega: "Ω", alpha: "α", zeta: "ζ", lambda: "λ", epsilon: "ε" };

/**
 * A sentence in plain text, its quantities set as in the formulas: `Omega_1` becomes an italic letter with its index.
 *
 * @param {string} text
 * @returns {DocumentFragment}
 */
export function sentence(text) {
  const markup = text.replace(NAME, (all, greek, greekIndex, letter, index) => {
    if (all === "'") return "’";
    if (all === "-") return "−";
    if (all.startsWith("^")) return `^{${all.slice(1)}}`;
    if (/^\d/.test(all)) return all.replace("+", "").replace("e", " × 10^{").replace("-", "−") + "}";
    if (all === "k0") return "*k*_{0}";
    const lowered = greekIndex ?? index;
    return `*${GREEK[greek] ?? letter ?? all}*${lowered === undefined ? "" : `_{${lowered}}`}`;
  });
  return elements(markup);
}

/**
 * A hyphen before a number is a minus.
 *
 * @param {string} text
 */
function plainSigns(text) {
  return text.replace(/-(?=[\d.])/g, "−");
}

/**
 * @param {"i" | "sub" | "sup"} name
 * @param {string} markup
 */
function element(name, markup) {
  const made = document.createElement(name);
  made.append(elements(markup));
  return made;
}
