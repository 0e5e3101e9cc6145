// For pages that hold figures of gear-bifurcations in frames: gives each frame the height that its figure needs.
addEventListener("message", ({ data, source, origin }) => {
  if (data?.gear !== 1 || data.type !== "resize" || !(data.height > 0 && data.height < 10000)) return;
  for (const frame of document.querySelectorAll("iframe")) {
    if (frame.contentWindow !== source) continue;
    if (origin !== "null" && origin !== new URL(frame.src).origin) continue;
    frame.style.height = `${Math.ceil(data.height)}px`;
  }
});
