// Each example of docs/embedding.md, opened where it lies in the site; of those that are not HTML, the HTML in them.

import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { test, expect } from "@playwright/test";

const FOLDER = fileURLToPath(new URL("../../docs/examples/", import.meta.url));
const names = readdirSync(FOLDER);

/** The HTML that the tool which an example is for makes of it. @param {string} name */
function html(name) {
  const text = readFileSync(`${FOLDER}${name}`, "utf8");
  if (name.endsWith(".html")) return text;
  const block = text.match(/```\{(?:=html|raw\} html)[}\s]*\n([\s\S]*?)```/);
  return block?.[1] ?? text.replace(/^#.*$/m, "");
}

test("every example is named in the document, and every name is one", () => {
  const text = readFileSync(new URL("../../docs/embedding.md", import.meta.url), "utf8");
  const named = [...text.matchAll(/\(examples\/([\w.-]+)\)/g)].map(([, name]) => name);
  expect([...new Set(named)].sort()).toEqual(names.sort());
});

for (const name of names) {
  test(`${name} shows a live figure`, async ({ page, baseURL }) => {
    const address = `${baseURL}docs/examples/${name.replace(/\.\w+$/, "")}-opened.html`;
    await page.route(address, (route) => route.fulfill({ contentType: "text/html", body: `<!doctype html><title>x</title>${html(name)}` }));
    await page.goto(address);
    const framed = (await page.locator("iframe").count()) > 0;
    const figure = framed ? page.frameLocator("iframe").locator("gear-figure") : page.locator("gear-figure");
    await expect(figure.locator(".stage.live")).toBeVisible({ timeout: 30_000 });
    if (name !== "frame.html") return;
    await page.getByRole("slider").fill("1.62");
    await expect(page.locator("output")).toHaveText("Ω = 1.62", { timeout: 30_000 });
  });
}

for (const [heading, said] of [["The element", /2T|period/], ["The frame", /Omega = 1\.65/]]) {
  test(`the example of docs/api.md under "${heading}" runs`, async ({ page, baseURL }) => {
    const text = readFileSync(new URL("../../docs/api.md", import.meta.url), "utf8");
    const code = text.split(`\n## ${heading}\n`)[1].match(/```html\n([\s\S]*?)```/)?.[1] ?? "";
    expect(code).toContain("https://host.example/gear/");
    const address = `${baseURL}docs/examples/api-opened.html`;
    const body = `<!doctype html><title>x</title>${code.replaceAll("https://host.example/gear/", `${baseURL}`)}`;
    await page.route(address, (route) => route.fulfill({ contentType: "text/html", body }));
    await page.goto(address);
    await expect(page.locator("output")).toContainText(said, { timeout: 30_000 });
  });
}
