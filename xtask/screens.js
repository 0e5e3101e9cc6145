// Screenshots of the whole page, wide and on a phone, light and dark, into docs/screens/.
// `cargo xtask screens` calls it after a build, with the page's address in GEAR_ADDRESS.

import { fileURLToPath } from "node:url";
import { chromium } from "@playwright/test";
import { launchOptions } from "./chromium.js";

const FOLDER = fileURLToPath(new URL("../docs/screens/", import.meta.url));
const PATIENCE_MILLISECONDS = 60_000;
const SCREENS = [
  { name: "wide", viewport: { width: 1440, height: 900 }, deviceScaleFactor: 1, isMobile: false },
  { name: "phone", viewport: { width: 360, height: 740 }, deviceScaleFactor: 2, isMobile: true },
];

const address = process.env.GEAR_ADDRESS;
if (!address) throw new Error("GEAR_ADDRESS says where the page is");

const browser = await chromium.launch(launchOptions);
try {
  for (const { name, ...size } of SCREENS) {
    for (const colorScheme of /** @type {const} */ (["light", "dark"])) {
      const context = await browser.newContext({ ...size, colorScheme, reducedMotion: "reduce" });
      const page = await context.newPage();
      await page.goto(address);
      await allFigures(page);
      await page.screenshot({ path: `${FOLDER}${name}-${colorScheme}.png` });
      // To look at, too large to keep: .gitignore leaves it out.
      await page.screenshot({ path: `${FOLDER}${name}-${colorScheme}-whole.png`, fullPage: true });
      console.log(`${name}-${colorScheme}`);
      await context.close();
    }
  }
} finally {
  await browser.close();
}

/** @param {import("@playwright/test").Page} page */
async function allFigures(page) {
  const deadline = Date.now() + PATIENCE_MILLISECONDS;
  const marked = () => page.evaluate(() => performance.getEntriesByName("all-figures").length > 0);
  while (!(await marked())) {
    if (Date.now() > deadline) throw new Error("the page never marked all-figures");
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}
