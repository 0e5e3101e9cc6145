// The journey in Chromium.

process.env.ENGINE = "chromium";
await import("./journey.mjs");
