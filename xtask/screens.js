// Pictures of the whole page: wide and on a phone, light and dark, for a room and on paper. `cargo xtask screens` calls
// it after a build, with the page's address in GEAR_ADDRESS and a folder for the tiles in GEAR_SCREENS.

import { writeFileSync } from "node:fs";
import { chromium } from "@playwright/test";
import { launchOptions } from "./chromium.js";

const PATIENCE_MILLISECONDS = 300_000;
/** Chromium cannot draw a picture that is higher than this at once. */
const TILE = 4000;
/** A sheet of A4 less its margins, CSS pixels. */
const SHEET = { width: 627, height: 926 };

const WIDE = { width: 1440, height: 900 };
const PHONE = { width: 360, height: 740 };
const ROOM = { width: 1920, height: 1080 };

/**
 * @typedef {object} Screen
 * @property {string} name
 * @property {{width: number, height: number}} size
 * @property {"light" | "dark"} [scheme]
 * @property {string} [hash]
 * @property {boolean} [first]  Only what is seen without scrolling.
 * @property {boolean} [paper]
 */

/** With a mouse, and by touch. What follows each other needs no computing twice. @type {{touch: boolean, screens: Screen[]}[]} */
const SCREENS = [
  {
    touch: false,
    screens: [
      { name: "first-screen", size: WIDE, first: true },
      { name: "story-wide-light", size: WIDE },
      { name: "story-wide-dark", size: WIDE, scheme: "dark" },
      { name: "story-print", size: SHEET, paper: true },
      { name: "lab-wide-light", size: WIDE, hash: "#lab&v=1" },
      { name: "lab-wide-dark", size: WIDE, scheme: "dark", hash: "#lab&v=1" },
      { name: "lab-projector", size: ROOM, hash: "#lab&v=1&projector=on" },
      { name: "class-wide-light", size: WIDE, hash: "#class&v=1&lesson=tongue" },
      { name: "class-wide-dark", size: WIDE, scheme: "dark", hash: "#class&v=1&lesson=tongue" },
      { name: "class-projector", size: ROOM, hash: "#class&v=1&lesson=tongue&projector=on" },
    ],
  },
  {
    touch: true,
    screens: [
      { name: "story-phone-light", size: PHONE },
      { name: "story-phone-dark", size: PHONE, scheme: "dark" },
      { name: "lab-phone-light", size: PHONE, hash: "#lab&v=1" },
      { name: "lab-phone-dark", size: PHONE, scheme: "dark", hash: "#lab&v=1" },
      { name: "class-phone-light", size: PHONE, hash: "#class&v=1&lesson=tongue" },
      { name: "class-phone-dark", size: PHONE, scheme: "dark", hash: "#class&v=1&lesson=tongue" },
    ],
  },
];

const { GEAR_ADDRESS: address, GEAR_SCREENS: folder } = process.env;
if (!address || !folder) throw new Error("GEAR_ADDRESS says where the page is, GEAR_SCREENS where its pictures go");

const browser = await chromium.launch(launchOptions);
try {
  for (const { touch, screens } of SCREENS) {
    const context = await browser.newContext({ isMobile: touch, hasTouch: touch, reducedMotion: "reduce", deviceScaleFactor: 1 });
    const page = await context.newPage();
    page.setDefaultTimeout(PATIENCE_MILLISECONDS);
    await page.setViewportSize(screens[0].size);
    await page.goto(address);
    for (const screen of screens) await take(page, screen);
    await context.close();
  }
} finally {
  await browser.close();
}

/**
 * @param {import("@playwright/test").Page} page
 * @param {Screen} screen
 */
async function take(page, { name, size, scheme = "light", hash = "#story&v=1", first = false, paper = false }) {
  await page.setViewportSize(size);
  await page.emulateMedia({ colorScheme: scheme, media: "screen" });
  await page.evaluate((wanted) => {
    if (location.hash !== wanted) location.hash = wanted;
    scrollTo(0, 0);
  }, hash);
  await page.locator(`main > [data-view="${hash.slice(1).split("&")[0]}"]:not([hidden]) :is(h1, h2, p)`).first().waitFor();
  await settled(page, first);
  if (paper) {
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    await page.emulateMedia({ colorScheme: scheme, media: "print" });
  }
  await drawn(page);
  const height = first ? size.height : await page.evaluate(() => document.documentElement.scrollHeight);
  const session = await page.context().newCDPSession(page);
  for (let top = 0; top < height; top += TILE) {
    const clip = { x: 0, y: top, width: size.width, height: Math.min(TILE, height - top), scale: 1 };
    const { data } = await session.send("Page.captureScreenshot", { format: "png", captureBeyondViewport: true, clip });
    writeFileSync(`${folder}/${name}.${String(top / TILE).padStart(3, "0")}.png`, Buffer.from(data, "base64"));
  }
  await session.detach();
  if (paper) await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  console.log(name);
}

/**
 * Every figure that is shown is complete.
 *
 * @param {import("@playwright/test").Page} page
 * @param {boolean} first  Only those that are seen without scrolling.
 */
async function settled(page, first) {
  await page.waitForFunction(() => customElements.get("gear-figure") !== undefined);
  await page.evaluate(async (onlyFirst) => {
    const shown = [...document.querySelectorAll("gear-figure")].filter((one) => one.getClientRects().length > 0);
    const wanted = onlyFirst ? shown.filter((one) => one.getBoundingClientRect().top < innerHeight) : shown;
    await Promise.all(wanted.map((one) => /** @type {any} */ (one).data().catch(() => null)));
  }, first);
}

/**
 * What is complete is drawn within a few frames.
 *
 * @param {import("@playwright/test").Page} page
 */
async function drawn(page) {
  await page.evaluate(async () => {
    for (let frame = 0; frame < 30; frame += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  });
}
