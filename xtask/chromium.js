// How every browser here is started: tests, measurements and screenshots see the same one.

/** @type {import("@playwright/test").LaunchOptions} */
export const launchOptions = {
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: [
    // Chromium's sandbox refuses to run as root, which is what build machines are.
    ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
    // It would otherwise ask its maker for updates, from machines that have no such network.
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--disable-quic",
    "--no-first-run",
  ],
};
