/**
 * What goes wrong, in the fields of a `GearError`.
 *
 * @typedef {import("./services.js").GearErrorFields} GearErrorFields
 */

/**
 * @param {string} id
 * @param {Iterable<string>} known
 * @returns {GearErrorFields}
 */
export function unknownFigure(id, known) {
  const allowed = [...known].join(", ");
  const message = `There is no figure “${id}”; there are ${allowed}.`;
  return { code: "unknown-figure", parameter: null, given: id, allowed, message };
}

/**
 * @param {unknown} thrown
 * @returns {GearErrorFields}
 */
export function fieldsOf(thrown) {
  if (thrown instanceof Error && "code" in thrown && "parameter" in thrown) {
    const { code, parameter, given, allowed, message } = /** @type {Error & GearErrorFields} */ (thrown);
    return { code, parameter, given, allowed, message };
  }
  const message = thrown instanceof Error ? thrown.message : String(thrown);
  return { code: "internal", parameter: null, given: null, allowed: null, message };
}
