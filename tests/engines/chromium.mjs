// Chromium, driven by Playwright, as in tests/browser.

import { chromium } from "@playwright/test";
import { launchOptions } from "../../xtask/chromium.js";

/** @returns {Promise<import("./driver.mjs").Driver>} */
export async function startChromium() {
  const browser = await chromium.launch(launchOptions);
  const page = await browser.newPage();
  /** @type {string[]} */
  let noise = [];
  page.on("console", (message) => noise.push(`console ${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => noise.push(`uncaught: ${error.message}`));
  page.on("response", (response) => {
    if (response.status() >= 400) noise.push(`status ${response.status()}: ${response.url()}`);
  });
  return {
    name: `Chromium ${browser.version()}`,
    resize: (width, height) => page.setViewportSize({ width, height }),
    open: async (address) => {
      await page.goto("about:blank");
      await page.goto(address);
    },
    reload: async () => void (await page.reload()),
    evaluate: async (work, ...given) => {
      const text = await page.evaluate(`(async () => JSON.stringify(await (${work})(...${JSON.stringify(given)})))()`);
      return typeof text === "string" ? JSON.parse(text) : undefined;
    },
    drag: async ([from, ...rest]) => {
      await page.mouse.move(from.x, from.y);
      await page.mouse.down();
      for (const { x, y } of rest) await page.mouse.move(x, y);
      await page.mouse.up();
    },
    press: (keys) => page.keyboard.press(keys),
    type: (text) => page.keyboard.type(text),
    picture: () => page.screenshot(),
    inserted: "",
    noise: async () => {
      const heard = noise;
      noise = [];
      return heard;
    },
    close: () => browser.close(),
  };
}
