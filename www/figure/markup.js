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
