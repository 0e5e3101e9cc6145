// What a frame hears: exactly what has the form, and nothing else, however near to it.

import assert from "node:assert/strict";
import { test } from "node:test";
import { malformed } from "./fuzz/messages.mjs";
import { random } from "./random.mjs";

// What a browser tells of its elements, as far as the made-up messages name it.
Object.assign(globalThis, { HTMLElement: { prototype: Object.fromEntries("innerHTML textContent outerHTML innerText accessKey tabIndex".split(" ").map((name) => [name, ""])) } });
const { understood } = await import("../../www/embed/messages.js");

test("100,000 malformed messages: none is heard, none throws", () => {
  const choose = random(8);
  for (let count = 0; count < 100_000; count += 1) {
    const message = malformed(choose);
    assert.equal(understood(message), null, `${count}: ${typeof message}`);
  }
});

test("what has the form is heard whole, and nothing beside it", () => {
  const choose = random(9);
  for (let count = 0; count < 10_000; count += 1) {
    const set = {
      gear: /** @type {const} */ (1),
      type: /** @type {const} */ ("set"),
      figure: choose.of([undefined, "11a", "T", "E"]),
      params: choose.of([undefined, {}, { Omega: choose.next(), k_g: null, regime: "contact", u_p_dot0: -1, F: 1 }]),
      controls: choose.of([undefined, "full", "compact", "none"]),
      theme: choose.of([undefined, "light", "dark", "auto"]),
    };
    assert.deepEqual(understood({ ...set, extra: malformed(choose) }), set);
    const get = { gear: /** @type {const} */ (1), type: /** @type {const} */ ("get"), id: choose.of([undefined, 7, "seven"]), data: choose.of([undefined, true, false]) };
    assert.deepEqual(understood({ ...get, params: malformed(choose) }), get);
    const type = choose.of(/** @type {const} */ (["play", "pause", "reset"]));
    assert.deepEqual(understood({ gear: 1, type, id: malformed(choose) }), { gear: 1, type });
  }
});
