// The journey in Firefox.

process.env.ENGINE = "firefox";
await import("./journey.mjs");
