// The journey in WebKit.

process.env.ENGINE = "webkit";
await import("./journey.mjs");
