// No text runs over another, also inside of figures and formulas, and nothing is wider than the screen.

/** Widths of a phone, a tablet and a screen. */
export const WIDTHS = [390, 800, 1400];

/** Runs in the page: pairs of texts that stand on each other, with where they are. */
const overprinted = () => {
  const boxes = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  const range = document.createRange();
  for (let node = walker.nextNode(); node; node = walker.nextNode()) {
    const parent = node.parentElement;
    if (!node.data.trim() || parent.closest("script, style, title, .skip, option") || !parent.checkVisibility()) continue;
    // What a box with a scroll bar does not show can't stand on anything.
    const frame = parent.closest(".scroll")?.getBoundingClientRect();
    range.selectNodeContents(node);
    for (const { left, top, right, bottom } of range.getClientRects()) {
      // Of the height between the lines, the part in which letters have their ink.
      const inset = 0.22 * (bottom - top);
      const box = { left: Math.max(left, frame?.left ?? left), right: Math.min(right, frame?.right ?? right), top: top + inset, bottom: bottom - inset, node };
      if (box.right - box.left > 0.5) boxes.push(box);
    }
  }
  boxes.sort((one, two) => one.top - two.top);
  const place = ({ parentElement }) => parentElement.closest("details.claim, section, header")?.id ?? "";
  const found = [];
  let open = [];
  for (const box of boxes) {
    open = open.filter(({ bottom }) => bottom > box.top);
    for (const other of open) {
      const [across, down] = [Math.min(box.right, other.right) - Math.max(box.left, other.left), Math.min(box.bottom, other.bottom) - Math.max(box.top, other.top)];
      if (other.node !== box.node && across > 1 && down > 1) {
        found.push(`${place(box.node)}: “${other.node.data.trim().slice(0, 30)}” and “${box.node.data.trim().slice(0, 30)}”`);
      }
    }
    open.push(box);
  }
  return { texts: boxes.length, found };
};

/** What is to be seen at each width, with everything open and with everything closed. */
export async function layout({ evaluate, send }, check) {
  for (const width of WIDTHS) {
    await send("Emulation.setDeviceMetricsOverride", { width, height: 900, deviceScaleFactor: 1, mobile: width < 600 });
    for (const open of [false, true]) {
      await evaluate(`document.querySelectorAll("details").forEach((details) => { details.open = ${open}; })`);
      const state = `${width} px, all ${open ? "open" : "closed"}`;
      const [content, screen] = await evaluate("[document.documentElement.scrollWidth, innerWidth]");
      check(`${state}: the page is no wider than the screen`, content <= screen, [content, screen]);
      const wide = await evaluate(`[...document.querySelectorAll("body *")].filter((element) => !element.parentElement.closest(".scroll, svg, math") && element.getBoundingClientRect().right > innerWidth + 1).slice(0, 5).map((element) => element.outerHTML.slice(0, 80))`);
      check(`${state}: no element reaches out of it`, wide.length === 0, wide);
      const { texts, found } = await evaluate(`(${overprinted})()`);
      check(`${state}: none of ${texts} pieces of text stands on another`, texts > (open ? 5000 : 300) && found.length === 0, [found.length, ...found.slice(0, 12)]);
    }
  }
  // The measure sees what it is to see.
  const seen = await evaluate(`{ const move = document.querySelector(".opening li"); move.style.transform = "translateY(2.05rem)"; const { found } = (${overprinted})(); move.style.transform = ""; found.length; }`);
  check("a text that is moved onto another one is noticed", seen > 0, seen);
  await evaluate(`document.querySelectorAll("details").forEach((details) => { details.open = false; })`);
  await send("Emulation.clearDeviceMetricsOverride");
}
