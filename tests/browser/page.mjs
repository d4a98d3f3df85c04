// Drives the page of the report as a reader would: filters, opens a claim, has its certificate checked, types and drags in the
// panel, and compares what the page says with `knotproof eval`, `shape` and `check`.
//
// usage: node tests/browser/page.mjs PAGE KNOTPROOF [FOLDER FOR PICTURES]
import { spawnSync } from "node:child_process";
import { statSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { open } from "./chromium.mjs";
import { layout } from "./layout.mjs";

const [page, knotproof, pictures] = process.argv.slice(2);
const LIMITS = { bytes: 5_500_000 };

let [passed, failed] = [0, 0];
const check = (name, holds, found) => {
  if (holds) passed += 1; else failed += 1;
  console.log(`${holds ? "ok     " : "FAILED "} ${name}${holds || found === undefined ? "" : `: ${JSON.stringify(found)}`}`);
};
const rational = (text) => { const [p, q = "1"] = text.split("/"); return Number(p) / Number(q); };

const address = pathToFileURL(resolve(page)).href;
const browser = await open(address);
const { evaluate, send } = browser;
/** Waits until something is so in the page. */
const until = (expression) => evaluate(`new Promise((done, fail) => {
  const began = performance.now();
  const look = () => {
    if (${expression}) done(performance.now());
    else if (performance.now() - began > 15000) fail(new Error(${JSON.stringify(expression)}));
    else setTimeout(look, 5);
  };
  look();
})`);
const answered = () => until(`document.getElementById("panel").dataset.state === "ready"`);
// What a person does: the value, and the event that a browser would send; then the panel has answered.
const set = async (id, value) => {
  await evaluate(`{ const field = document.getElementById("${id}"); field.value = ${JSON.stringify(value)}; field.dispatchEvent(new Event(field.matches("#instance, #family") ? "change" : "input", { bubbles: true })); }`);
  if (!filters.includes(id)) await evaluate("new Promise((done) => setTimeout(done, 30))").then(answered);
};
const filters = ["search", "status", "severity", "scope"];
const click = (selector) => evaluate(`document.querySelector(${JSON.stringify(selector)}).click()`);
const shown = () => evaluate(`[...document.querySelectorAll(".verdicts tbody tr")].filter((row) => row.checkVisibility()).map((row) => row.dataset.claim)`);
const text = (selector) => evaluate(`document.querySelector(${JSON.stringify(selector)}).textContent`);
const field = (id) => evaluate(`document.getElementById("${id}").value`);
const column = (at) => evaluate(`[...document.querySelectorAll("#values tbody tr")].map((row) => row.cells[${at}].dataset.exact)`);
const values = () => column(2);
const program = (...options) => {
  const { stdout, stderr } = spawnSync(knotproof, [...options.map(String), "--format", "json"], { encoding: "utf8", maxBuffer: 1 << 28, env: { ...process.env, KNOTPROOF_PROGRESS: "never" } });
  return JSON.parse(stdout || stderr);
};
const exact = (degree, knots, alpha, x, ...more) => program("eval", "--degree", degree, "--knots", knots, "--alpha", alpha, "--x", x, ...more);
const equal = (found, expected) => JSON.stringify(found) === JSON.stringify(expected);
// A place on the screen of something in a drawing.
const middle = (selector) => evaluate(`{ document.querySelector(${JSON.stringify(selector)}).scrollIntoView({ block: "center" }); const { x, y, width, height } = document.querySelector(${JSON.stringify(selector)}).getBoundingClientRect(); [x + width / 2, y + height / 2]; }`);
const drag = async ([x, y], [dx, dy]) => {
  const mouse = (type, at, buttons) => send("Input.dispatchMouseEvent", { type, x: at[0], y: at[1], button: "left", buttons, clickCount: 1 });
  await mouse("mousePressed", [x, y], 1);
  for (const part of [0.5, 1]) await mouse("mouseMoved", [x + part * dx, y + part * dy], 1);
  await mouse("mouseReleased", [x + dx, y + dy], 0);
  await answered();
};

try {
  // ---- The page itself
  const bytes = statSync(page).size;
  check(`the page has ${bytes} bytes, fewer than ${LIMITS.bytes}`, bytes < LIMITS.bytes);
  // To be read, not judged: other work on the machine adds to it.
  const ready = await evaluate(`performance.getEntriesByType("navigation")[0].loadEventEnd`);
  console.log(`it is ready after ${Math.round(ready)} ms`);
  await answered();
  const first = await evaluate(`(async () => { modules.panel.stop(); const began = performance.now(); await modules.panel.ask(JSON.stringify({ ask: "values", degree: "3", knots: "0 0 0 0 1 2 4 4 4 4", alpha: "5/2", x: "3/2" })); return performance.now() - began; })()`);
  console.log(`a first answer of the panel, with its module begun anew, takes ${Math.round(first)} ms`);
  const requests = browser.events.filter(({ method, params }) => method === "Network.requestWillBeSent" && !/^(data|blob):/.test(params.request.url));
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

  // ---- Its certificate, and one that is changed
  await evaluate(`document.querySelector('${claim} button.check').click()`);
  await until(`/^(accepted|rejected|internal)/.test(document.querySelector('${claim} button.check + *').textContent)`);
  const checked = await text(`${claim} button.check + *`);
  check("the checker accepts it in front of the reader", checked.startsWith("accepted: T3.5.3"), checked);
  const offered = await evaluate(`[document.querySelectorAll("button.check").length, document.querySelectorAll('#claims a[href$=".statement"]').length]`);
  check(`each of ${offered[1]} certificates can be checked`, offered[0] >= offered[1] && offered[1] > 150, offered);
  const forged = await evaluate(`(async () => { const stream = new Blob([Uint8Array.from(atob(document.getElementById("certificates").textContent), (c) => c.charCodeAt(0))]).stream().pipeThrough(new DecompressionStream("gzip")); const [statement, proof] = (await new Response(stream).json())["T3.5.2.printed"]; return modules.checker.ask(statement + "\\0" + proof.slice(0, -2)); })()`);
  check("half of a proof is rejected", forged.startsWith("rejected: "), forged);

  // ---- The panel, from the witness
  await evaluate(`new Promise((done) => { addEventListener("hashchange", () => setTimeout(done), { once: true }); document.querySelector('${claim} .to-panel').click(); })`);
  await answered();
  const state = await evaluate(`["degree", "knots", "alpha", "x"].map((id) => document.getElementById(id).value)`);
  check("the panel shows the witness", equal(state, ["1", "0,0,1,2", "-1", "3/2"]), state);
  check("with the values of eval", equal(await values(), exact(...state).values), await values());

  // ---- Instances, α and x: exact
  const CASES = [
    ["U0/3", "-1", "7/3"], ["U4/2", "inf", "2"], ["U11/2", "5", "3/4"], ["C6b/5", "-1/7", "4"], ["C6b/4", "8/7", "5/2"],
    ["S7/3", "3/2", "19/7"], ["C5/3", "1e-9", ""], ["U2/2", "1000000", "1"], ["C5/3", "1.0001", "5"],
  ];
  for (const [instance, alpha, x] of CASES) {
    await set("instance", instance);
    await set("alpha", alpha);
    if (x) await set("x", x);
    const [degree, knots] = await evaluate(`["degree", "knots"].map((id) => document.getElementById(id).value)`);
    if (alpha === "1e-9") {
      const message = await text("#panel-error");
      check("α between 0 and 1 is refused in the words of the command line", message === exact(degree, knots, alpha, 1).error.message && /D2\.3/.test(message), message);
      check("and the field is marked", (await evaluate(`document.getElementById("alpha").getAttribute("aria-invalid")`)) === "true");
      continue;
    }
    const expected = exact(degree, knots, alpha, x, "--derivatives", 1);
    check(`${instance}, α = ${alpha}, x = ${x}: all G_i(x) are those of eval`, equal(await values(), expected.values), await values());
    check(`${instance}, α = ${alpha}, x = ${x}: and their slopes`, equal(await column(3), expected.derivatives[0]), await column(3));
  }
  await set("instance", "C5/3");
  await set("alpha", "-1/2");
  const before = await evaluate(`document.querySelector("#curve .trace").getAttribute("points")`);
  await set("ratio", "0.5");
  const alpha = await field("alpha");
  check("the slider moves α", Math.abs(rational(alpha) - 10 ** 0.5 / (10 ** 0.5 - 1)) < 1e-3, alpha);
  check("the curve is redrawn", (await evaluate(`document.querySelector("#curve .trace").getAttribute("points")`)) !== before);
  const [degree, knots, x] = await evaluate(`["degree", "knots", "x"].map((id) => document.getElementById(id).value)`);
  check("and the values are those of eval", equal(await values(), exact(degree, knots, alpha, x).values), await values());
  await set("alpha", "5/2");
  await click("#conjugate");
  await answered();
  check("the conjugate of 5/2 is -3/2", (await field("alpha")) === "-3/2");

  // ---- Dragging: x, a knot, a control point
  await set("instance", "C5/3");
  const at = rational(await field("x"));
  await drag(await middle("#basis .at"), [60, 0]);
  check("dragged to the right, x grows", rational(await field("x")) > at && equal(await values(), exact(await field("degree"), await field("knots"), await field("alpha"), await field("x")).values), await field("x"));
  const knotsBefore = await field("knots");
  await drag(await middle("#basis [data-knot='1']"), [15, 0]);
  check("a knot can be dragged", (await field("knots")) !== knotsBefore && (await text("#panel-error")) === "", await field("knots"));
  const pointsBefore = await field("points");
  await drag(await middle("#curve [data-point='1']"), [20, 30]);
  const [was, is] = [pointsBefore, await field("points")].map((list) => list.split(" ")[1].split(",").map(rational));
  check("and a control point, to the right and down", is[0] > was[0] && is[1] < was[1], [was, is]);

  // ---- A family, with its parameters
  await set("degree", "2");
  await set("knots", "0 0 0 1 2 2 2");
  await set("points", "");
  await set("x", "1/3");
  await set("family", "lupas");
  check("a family has fields for its parameters", (await evaluate(`document.querySelectorAll("#members input").length`)) === 1 && (await evaluate(`document.getElementById("alpha").checkVisibility()`)) === false);
  await evaluate(`{ const input = document.querySelector("#members input"); input.value = "1/2"; input.dispatchEvent(new Event("input", { bubbles: true })); }`);
  await answered();
  const ofFamily = ["--degree", 2, "--knots", "0 0 0 1 2 2 2", "--family", "lupas", "--set", "q=1/2"];
  check("its values are those of eval", equal(await values(), program("eval", ...ofFamily, "--x", "1/3").values), await values());
  await click("#judge");
  await until(`document.getElementById("judge-count").textContent.startsWith("For every x")`);
  const verdicts = () => evaluate(`[...document.querySelectorAll("#verdicts-here tr")].map((row) => row.cells[1].textContent)`);
  check("the classical properties come to what check says", equal(await verdicts(), program("check", ...ofFamily, "--classical").properties.map(({ status }) => status)), await verdicts());
  const familyState = new URLSearchParams((await evaluate("location.hash")).slice(1));
  check("the address keeps the family", familyState.get("family") === "lupas" && familyState.get("set") === "q=1/2", [...familyState]);
  await set("family", "");

  // ---- Verdicts of the paper's claims, and of a sentence
  await set("alpha", "-1");
  await click("#judge");
  await until(`document.getElementById("judge-count").textContent.startsWith("For every x")`);
  const here = await evaluate(`Object.fromEntries([...document.querySelectorAll("#verdicts-here tr")].map((row) => [row.dataset.claim, row.cells[1].textContent]))`);
  const recorded = Object.fromEntries(program("check", "--degree", 2, "--knots", "0 0 0 1 2 2 2", "--alpha", -1).properties.map(({ id, status }) => [id, status]));
  const differing = Object.entries(here).filter(([id, status]) => recorded[id] !== status);
  check(`the verdicts on ${Object.keys(here).length} claims are those of check`, Object.keys(here).length > 30 && differing.length === 0, differing.map(([id, status]) => [id, status, recorded[id]]));
  // These are made of other claims, which the judge of the page does not know.
  const missing = Object.keys(recorded).filter((id) => !(id in here));
  check("on all but two", equal(missing, ["abstract.classical", "C6.classical"]), missing);
  await evaluate(`document.getElementById("sentence").value = "i in 0..n : G[i](t[m]) = 0"`);
  await click("#own-form button");
  await until(`/refuted|proved/.test(document.querySelector("#verdicts-here tr")?.cells[1].textContent)`);
  check("a sentence of the reader's own is judged, with its witness", /refuted.*i = 3.*it says/.test(await text("#verdicts-here tr")), await text("#verdicts-here tr"));
  await evaluate(`document.getElementById("sentence").value = "i in 0..n : maxma(G[i]) = 1"`);
  await click("#own-form button");
  await until(`/maxma/.test(document.querySelector("#verdicts-here tr")?.cells[1].textContent)`);
  check("a misspelt word is named", /did you mean `maxima`/.test(await text("#verdicts-here tr")), await text("#verdicts-here tr"));

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
  await until(`document.querySelectorAll("#values tbody tr")[2].cells[4].textContent.includes(",")`);
  const maxima = await evaluate(`document.querySelectorAll("#values tbody tr")[2].cells[4].textContent.split(", ").map((text) => Number(text.replace("≈ ", "")))`);
  const told = program("shape", "--degree", 3, "--knots", "0 0 0 0 1 2 4 4", "--alpha", "5/2", "--index", 2).functions[0].extrema.filter(({ kind }) => kind === "maximum");
  check("the maxima are those of shape, to the last digit", equal(maxima, told.map(({ x }) => Number(x))), [maxima, told]);
  const between = (value, lo, hi) => value > lo && value < hi;
  check("two local maxima are marked where the exact ones are", maxima.length === 2 && between(maxima[0], 0.9997, 0.99998) && between(maxima[1], 1.001, 1.0015), maxima);
  check("and drawn", (await evaluate(`document.querySelectorAll('#basis [data-function="2"] .maximum').length`)) === 2);

  // ---- Bad input
  for (const [id, value] of [["knots", "0 1 1 0"], ["knots", "0 0 0 0 2 1 4 4"], ["knots", "<b>"], ["degree", "-1"], ["x", "one"], ["points", "0,0 1,1"]]) {
    const old = await field(id);
    await set(id, value);
    const message = await text("#panel-error");
    const typed = { degree: "3", knots: "0 0 0 0 1 2 4 4", alpha: "5/2", x: await field("x"), points: "", [id]: value };
    const { error } = exact(typed.degree, typed.knots, typed.alpha, typed.x, ...(typed.points ? ["--points", typed.points] : []));
    check(`${id} = ${value} is refused in the words of the command line`, message === error.message, [message, error.message]);
    await set(id, old);
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

  // ---- A module that panics: memory, and four functions of which `answer` traps; what was said lies at 16
  const trap = [0, 97, 115, 109, 1, 0, 0, 0, 1, 10, 2, 96, 1, 127, 1, 127, 96, 0, 1, 127, 3, 5, 4, 0, 1, 1, 1, 5, 3, 1, 0, 1,
    7, 45, 5, 6, ...Buffer.from("memory"), 2, 0, 8, ...Buffer.from("question"), 0, 0, 6, ...Buffer.from("answer"), 0, 1, 4, ...Buffer.from("text"), 0, 2, 5, ...Buffer.from("fault"), 0, 3,
    10, 21, 4, 5, 0, 65, 128, 8, 11, 3, 0, 0, 11, 4, 0, 65, 16, 11, 4, 0, 65, 4, 11, 11, 10, 1, 0, 65, 16, 11, 4, ...Buffer.from("oops")];
  await evaluate(`globalThis.sound = document.getElementById("module-panel").textContent; modules.panel.stop(); document.getElementById("module-panel").textContent = ${JSON.stringify(gzipSync(Buffer.from(trap)).toString("base64"))};`);
  await set("x", "1");
  check("a panic is told on the page", (await text("#panel-error")) === "internal error: oops", await text("#panel-error"));
  await evaluate(`modules.panel.stop(); document.getElementById("module-panel").textContent = sound;`);
  await set("x", "3/2");
  check("and the next question is answered", (await text("#panel-error")) === "" && /At x = 3\/2/.test(await text("#panel-sum")), await text("#panel-error"));

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
