/**
 * Does something in the next frame, however often it is asked for until then.
 *
 * @param {() => void} work
 */
export function onceAFrame(work) {
  let frame = 0;
  return () => {
    frame ||= requestAnimationFrame(() => {
      frame = 0;
      work();
    });
  };
}
