// Drives the page of the report as a reader would: filters, opens a claim, moves α, reads values, and compares them with
// `knotproof eval`.
//
// usage: node tests/browser/page.mjs PAGE KNOTPROOF [FOLDER FOR PICTURES]
import { execFileSync } from "node:child_process";
import { statSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { open } from "./chromium.mjs";
import { layout } from "./layout.mjs";

const [page, knotproof, pictures] = process.argv.slice(2);
// The panel computes in f64. Sums, products and quotients of positive numbers only: a few units in the last place for each
// of the k levels of the recursion, and the numbers typed may not be f64 either.
const RELATIVE = 1e-12;
const LIMITS = { bytes: 4_000_000 };

let [passed, failed] = [0, 0];
const check = (name, holds, found) => {
  if (holds) passed += 1; else failed += 1;
  console.log(`${holds ? "ok     " : "FAILED "} ${name}${holds || found === undefined ? "" : `: ${JSON.stringify(found)}`}`);
};
const rational = (text) => { const [p, q = "1"] = text.split("/"); return Number(p) / Number(q); };

const address = pathToFileURL(resolve(page)).href;
const browser = await open(address);
const { evaluate, send } = browser;
// What a person does: the value, and the event that a browser would send.
const set = (id, value) => evaluate(`{ const field = document.getElementById("${id}"); field.value = ${JSON.stringify(value)}; field.dispatchEvent(new Event(field.matches("#instance") ? "change" : "input", { bubbles: true })); }`);
const click = (selector) => evaluate(`document.querySelector(${JSON.stringify(selector)}).click()`);
const shown = () => evaluate(`[...document.querySelectorAll(".verdicts tbody tr")].filter((row) => row.checkVisibility()).map((row) => row.dataset.claim)`);
const text = (selector) => evaluate(`document.querySelector(${JSON.stringify(selector)}).textContent`);
const values = () => evaluate(`[...document.querySelectorAll("#values tbody tr")].map((row) => Number(row.cells[2].textContent))`);
const exact = (degree, knots, alpha, x, ...more) => {
  const options = ["eval", "--degree", degree, "--knots", knots, "--alpha", alpha, "--x", x, "--format", "json", ...more];
  return JSON.parse(execFileSync(knotproof, options.map(String), { encoding: "utf8" }));
};
const close = (found, expected) => found.length === expected.length
  && found.every((value, i) => Math.abs(value - rational(expected[i])) <= RELATIVE * Math.abs(rational(expected[i])));

try {
  // ---- The page itself
  const bytes = statSync(page).size;
  check(`the page has ${bytes} bytes, fewer than ${LIMITS.bytes}`, bytes < LIMITS.bytes);
  // To be read, not judged: other work on the machine adds to it.
  const ready = await evaluate(`performance.getEntriesByType("navigation")[0].loadEventEnd`);
  console.log(`it is ready after ${Math.round(ready)} ms`);
  const requests = browser.events.filter(({ method, params }) => method === "Network.requestWillBeSent" && !params.request.url.startsWith("data:"));
  check("it asks for nothing but itself", requests.length === 1, requests.map(({ params }) => params.request.url));

  // ---- Filter
  const all = await shown();
  check(`the table shows all ${all.length} claims`, all.length > 80);
  await set("status", "refuted");
  const refuted = await shown();
  check(`${refuted.length} of them are refuted, T3.5.1 among them`, refuted.length > 0 && refuted.length < all.length && refuted.includes("T3.5.1") && !refuted.includes("T3.5.2"));
  await set("scope", "alpha");
  const narrow = await shown();
  check("filtering by scope as well leaves fewer", narrow.length > 0 && narrow.length < refuted.length, narrow);
  await set("status", "");
  await set("scope", "");
  await set("search", "Convex Hull");
  const found = await shown();
  check("the search finds the convex hull", found.includes("P4.1.3") && found.length < 10, found);
  check("the count says so", (await text("#count")) === `${found.length} of ${all.length} claims`);
  await set("search", "no such words");
  check("a search without results says so", await evaluate(`document.getElementById("none").checkVisibility()`));

  await set("search", "");
  await set("severity", "serious");
  const serious = await shown();
  const rows = await evaluate(`[...document.querySelectorAll(".verdicts tbody tr")].filter((row) => row.dataset.severity === "serious").length`);
  check("filtering by severity leaves what is serious", serious.length === rows && serious.length < all.length && serious.includes("Conj3.1.strong.continuous"), serious);
  check("and only that is red", (await evaluate(`[...document.querySelectorAll(".verdicts tbody tr")].every((row) => (row.dataset.severity === "serious") === (row.querySelector(".badge.serious") !== null))`)));
  await set("severity", "");
  await set("search", "no such words");

  // ---- What the page opens with
  const lines = await evaluate(`[...document.querySelectorAll(".opening > li")].map((line) => line.textContent)`);
  check("it opens with six lines, of theorems first and of what Coq has checked", lines.length === 6 && lines[0].includes("No theorem of the paper falls") && lines.some((line) => line.includes("Coq has checked")), lines);
  check("with the picture of the conjecture", await evaluate(`document.querySelector(".opening figure svg").checkVisibility()`));
  check("and a drawing of what depends on what", await evaluate(`document.querySelectorAll("#dependence svg text").length > 30`));

  // ---- A claim, hidden by the filter when its address is called
  await evaluate(`new Promise((done) => { addEventListener("hashchange", () => setTimeout(done), { once: true }); location.hash = "T3.5.3"; })`);
  check("its address opens a claim and clears the filter", await evaluate(`document.getElementById("T3.5.3").open`) && (await shown()).length === all.length);
  const claim = `[id="T3.5.3"]`;
  check("it has formulas", await evaluate(`document.querySelector('${claim} .statement math munderover').checkVisibility()`));
  await evaluate(`document.querySelector('${claim} .working').open = true`);
  const working = await text(`${claim} .working`);
  check("the witness is worked out to its value", working.includes("G") && /Degree 1/.test(working), working);
  check("it has a command", (await text(`${claim} .witness .command code`)).startsWith("knotproof eval"));

  // ---- The panel, from the witness
  await evaluate(`new Promise((done) => { addEventListener("hashchange", () => setTimeout(done), { once: true }); document.querySelector('${claim} .to-panel').click(); })`);
  const state = await evaluate(`["degree", "knots", "alpha", "x"].map((id) => document.getElementById(id).value)`);
  check("the panel shows the witness", JSON.stringify(state) === JSON.stringify(["1", "0,0,1,2", "-1", "3/2"]), state);
  check("with the values of eval", close(await values(), exact(...state).values), await values());

  // ---- Instances, α and x
  const CASES = [
    ["U0/3", "-1", "7/3"], ["U4/2", "inf", "2"], ["U11/2", "5", "3/4"], ["C6b/5", "-1/7", "4"], ["C6b/4", "8/7", "5/2"],
    ["S7/3", "3/2", "19/7"], ["C5/3", "1e-9", ""], ["U2/2", "1000000", "1"], ["C5/3", "1.0001", "5"],
  ];
  for (const [instance, alpha, x] of CASES) {
    await set("instance", instance);
    await set("alpha", alpha);
    if (x) await set("x", x);
    if (alpha === "1e-9") {
      check("α between 0 and 1 is refused with its rule", /\[0, 1\].*D2\.3/.test(await text("#panel-error")), await text("#panel-error"));
      check("and the field is marked", (await evaluate(`document.getElementById("alpha").getAttribute("aria-invalid")`)) === "true");
      continue;
    }
    const [degree, knots] = await evaluate(`["degree", "knots"].map((id) => document.getElementById(id).value)`);
    const expected = exact(degree, knots, alpha, x).values;
    check(`${instance}, α = ${alpha}, x = ${x}: all G_i(x) within ${RELATIVE} of eval`, close(await values(), expected), await values());
  }
  await set("instance", "C5/3");
  await set("alpha", "-1/2");
  const before = await evaluate(`document.querySelector("#curve .trace").getAttribute("points")`);
  await set("ratio", "0.5");
  const alpha = await evaluate(`document.getElementById("alpha").value`);
  check("the slider moves α", Math.abs(Number(alpha) - 10 ** 0.5 / (10 ** 0.5 - 1)) < 1e-9, alpha);
  check("the curve is redrawn", (await evaluate(`document.querySelector("#curve .trace").getAttribute("points")`)) !== before);
  const [degree, knots, x] = await evaluate(`["degree", "knots", "x"].map((id) => document.getElementById(id).value)`);
  check("and the values are those of eval", close(await values(), exact(degree, knots, alpha, x).values), await values());
  await set("alpha", "5/2");
  await click("#conjugate");
  check("the conjugate of 5/2 is -3/2", (await evaluate(`document.getElementById("alpha").value`)) === "-3/2");

  // ---- The drawings, neither mirrored nor upside down: hats on 0, 1, 3, and a curve with its ends at control points
  await set("degree", "1");
  await set("knots", "0 0 1 3 3");
  await set("points", "0,0 2,1 3,5");
  await set("alpha", "inf");
  const places = (selector) => evaluate(`[...document.querySelectorAll(${JSON.stringify(selector)})].flatMap((line) => line.getAttribute("points").split(" ").map((point) => point.split(",").map(Number)))`);
  const hat = await places("#basis [data-function='1'] .function");
  const [from, top, to] = [hat[0], hat.reduce((high, point) => (point[1] < high[1] ? point : high)), hat.at(-1)];
  const near = (found, expected) => Math.abs(found - expected) < 0.02;
  check("a hat rises from left to right up to its knot", near((top[0] - from[0]) * 3, to[0] - from[0]) && from[0] < to[0], [from, top, to]);
  check("and falls to the height where it began", near(from[1], to[1]) && top[1] < from[1], [from, top, to]);
  const controls = await evaluate(`[...document.querySelectorAll("#curve .control")].map((dot) => ["cx", "cy"].map((name) => Number(dot.getAttribute(name))))`);
  const unit = (controls[1][0] - controls[0][0]) / 2;
  const expected = [[0, 0], [2, 1], [3, 5]].map(([a, b]) => [controls[0][0] + a * unit, controls[0][1] - b * unit]);
  check("control points stand where they are", unit > 0 && controls.flat().every((at, i) => near(at, expected.flat()[i])), controls);
  const trace = await places("#curve .trace");
  check("and the curve begins and ends at the outer ones", [[trace[0], controls[0]], [trace.at(-1), controls.at(-1)]].every(([at, dot]) => near(at[0], dot[0]) && near(at[1], dot[1])), [trace[0], trace.at(-1)]);

  // ---- Maxima: the smallest function of degree 3 with two
  await set("degree", "3");
  await set("knots", "0 0 0 0 1 2 4 4");
  await set("points", "");
  await set("alpha", "5/2");
  const maxima = await evaluate(`document.querySelectorAll("#values tbody tr")[2].cells[4].textContent.split(", ").map(Number)`);
  const between = (value, lo, hi) => value > lo && value < hi;
  check("two local maxima are marked where the exact ones are", maxima.length === 2 && between(maxima[0], 0.9997, 0.99998) && between(maxima[1], 1.001, 1.0015), maxima);
  check("and drawn", (await evaluate(`document.querySelectorAll('#basis [data-function="2"] .maximum').length`)) === 2);

  // ---- Bad input
  for (const [field, value, rule] of [["knots", "0 1 1 0", /at least 7 knots.*D3\.2/], ["knots", "0 0 0 0 2 1 4 4", /must not decrease.*D3\.1/], ["degree", "-1", /whole number/], ["x", "one", /is not a number/], ["points", "0,0 1,1", /control points are needed.*D3\.4/]]) {
    const old = await evaluate(`document.getElementById("${field}").value`);
    await set(field, value);
    const message = await text("#panel-error");
    check(`${field} = ${value} is refused with its rule`, rule.test(message), message);
    await set(field, old);
  }
  check("after that all is well again", (await text("#panel-error")) === "" && (await values()).length === 4);

  // ---- The address keeps the state
  const hash = await evaluate("location.hash");
  check("the address keeps the panel", new URLSearchParams(hash.slice(1)).get("knots") === "0 0 0 0 1 2 4 4", hash);

  // ---- Theme, phone, print
  await click("#theme");
  check("dark can be chosen", (await evaluate("document.documentElement.dataset.theme")) === "dark");
  await click("#theme");
  await layout(browser, check);
  await send("Emulation.setEmulatedMedia", { media: "print" });
  check("in print a closed claim can be read", await evaluate(`{ const element = document.querySelector('[id="L3.6"] .statement'); element.getClientRects().length > 0 && element.getBoundingClientRect().height > 0; }`));
  await send("Emulation.setEmulatedMedia", { media: "" });
  const errors = browser.events.filter(({ method, params }) => method === "Runtime.exceptionThrown" || (method === "Log.entryAdded" && params.entry.level === "error"));
  check("no error in the page", errors.length === 0, errors);

  if (pictures) {
    const shot = async (name) => {
      const { data } = await send("Page.captureScreenshot", { captureBeyondViewport: false });
      writeFileSync(join(pictures, `${name}.png`), Buffer.from(data, "base64"));
    };
    const at = (selector) => evaluate(`document.querySelector(${JSON.stringify(selector)}).scrollIntoView()`);
    for (const [name, width, height] of [["desktop", 1200, 1000], ["phone", 390, 844]]) {
      await send("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: name === "phone" });
      for (const theme of ["light", "dark"]) {
        await evaluate(`document.documentElement.dataset.theme = "${theme}"`);
        await evaluate("scrollTo(0, 0)");
        await shot(`${name}-${theme}-top`);
        await evaluate(`{ const claim = document.querySelector('[id="T3.11.2"]'); claim.open = true; claim.querySelectorAll(".working").forEach((working) => { working.open = true; }); }`);
        await at('[id="T3.11.2"]');
        await shot(`${name}-${theme}-claim`);
        await set("instance", "C5/3");
        await at("#panel");
        await shot(`${name}-${theme}-panel`);
      }
      await evaluate(`{ const claim = document.querySelector('[id="Conj3.1.strong.continuous"]'); claim.open = true; claim.querySelector(".working").open = true; }`);
      await at('[id="Conj3.1.strong.continuous"]');
      await shot(`${name}-dark-conjecture`);
    }
    await send("Emulation.clearDeviceMetricsOverride");
    const { data } = await send("Page.printToPDF", { printBackground: false });
    writeFileSync(join(pictures, "print.pdf"), Buffer.from(data, "base64"));
  }
} finally {
  await browser.close();
}
console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 && passed > 0 ? 0 : 1;
