"use strict";
// The panel: what is typed or dragged is asked of the program, and what it answers is drawn and written down. Nothing is computed
// here but places on the screen.
const panel = (() => {
  const byId = (id) => document.getElementById(id);
  // Okabe and Ito's colours but for black and yellow, told apart by dashes as well.
  const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
  const DASHES = ["", "9 4", "3 3", "12 3 3 3"];
  const [WIDTH, HEIGHT] = [640, 360];
  // So long may a question take that has been overtaken by another one, in milliseconds.
  const PATIENCE = 1500;
  const FIELDS = ["degree", "knots", "points", "alpha", "x"];
  const OPTIONS = { "--degree": "degree", "--knots": "knots", "--points": "points", "--alpha": "alpha", "--x": "x", "--set": "members", "--family": "family", "--claim": "sentence" };
  const { instances, claims, classical } = JSON.parse(byId("paper").textContent);

  let chosen = null; // The function that a witness is about.
  let shown = {}; // The last answers, and what they are about.

  // ---- Asking --------------------------------------------------------------------------------------------------------

  /** What the program refuses, in its words. */
  class Refused extends Error {
    constructor({ message, argument }) {
      super(message);
      this.argument = argument;
    }
  }

  const ask = async (module, question) => {
    const answer = JSON.parse(await module.ask(JSON.stringify(question)));
    if (answer.error) throw new Refused(answer.error);
    return answer;
  };

  const settings = () => [...byId("members").querySelectorAll("input")].map(({ dataset, value }) => `${dataset.name}=${value}`);
  const texts = () => Object.fromEntries(FIELDS.map((id) => [id, byId(id).value]));
  const asked = () => ({ ...texts(), family: byId("family").value, set: settings() });
  /** What functions depend on, as text. */
  const aboutFunctions = ({ degree, knots, alpha, family, set }) => JSON.stringify([degree, knots, family ? [family, set] : alpha]);

  const clear = () => {
    for (const id of [...Object.values(OPTIONS), "panel-form"]) byId(id).removeAttribute("aria-invalid");
    byId("panel-error").textContent = "";
  };

  const complain = (error) => {
    if (error instanceof modules.Stopped) return;
    clear();
    byId("panel-error").textContent = error.message;
    byId(OPTIONS[error.argument] ?? "panel-form").setAttribute("aria-invalid", "true");
    if (!(error instanceof Refused || error instanceof modules.Fault)) throw error;
  };

  // One round at a time; what is typed meanwhile is asked when that is over, or at once if it takes too long.
  let [begun, again] = [null, false];
  const busy = () => { byId("panel").dataset.state = "busy"; };
  const update = async (keep = false) => {
    busy();
    if (!keep) remember();
    if (begun !== null) {
      again = true;
      if (performance.now() - begun < PATIENCE) return;
      modules.panel.stop();
      return;
    }
    try {
      do {
        [begun, again] = [performance.now(), false];
        await round().catch(complain);
      } while (again);
    } finally {
      begun = null;
      byId("panel").dataset.state = "ready";
    }
  };

  const round = async () => {
    const on = asked();
    const values = await ask(modules.panel, { ask: "values", ...on });
    clear();
    const about = aboutFunctions(on);
    if (about !== shown.about) forgetVerdicts();
    if (about !== shown.about || on.points !== shown.points) {
      const drawing = await ask(modules.panel, { ask: "drawing", ...on });
      shown = { ...shown, drawing, points: on.points, shapes: about === shown.about ? shown.shapes : undefined, about };
    }
    if (chosen !== null && chosen >= values.values.length) chosen = null;
    shown.values = values;
    draw();
    if (!shown.shapes) {
      shown.shapes = (await ask(modules.panel, { ask: "shapes", ...on })).functions;
      draw();
    }
  };

  // ---- Drawing -------------------------------------------------------------------------------------------------------

  /** The float next to a fraction, for a place on the screen. */
  const float = (text) => {
    const [p, q = "1"] = text.split("/");
    const cut = Math.max(0, Math.min(p.length, q.length) - 30);
    return Number(p.slice(0, p.length - cut)) / Number(q.slice(0, q.length - cut));
  };
  const element = (parent, name, attributes, text) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    if (text !== undefined) made.textContent = text;
    parent.append(made);
    return made;
  };
  const line = (places) => places.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");
  const short = (value) => String(Number(value.toPrecision(6)));

  // How places of a drawing and of the screen belong together; for dragging too.
  const frames = { basis: null, curve: null };

  const drawBasis = () => {
    const { drawing: { knots, spans, count }, shapes, values } = shown;
    const svg = byId("basis");
    svg.replaceChildren();
    frames.basis = null;
    // Knots beyond all floats can't be drawn.
    if (spans.length === 0 || knots.some(({ at }) => at === null)) return;
    const [first, last] = [knots[0].at, knots.at(-1).at];
    const all = spans.flatMap(({ functions }) => functions.flat());
    const [low, high] = [Math.min(0, ...all), Math.max(1, ...all)];
    const [left, right, top, bottom] = [40, WIDTH - 16, 20, HEIGHT - 52];
    const px = (value) => left + (value - first) / (last - first) * (right - left);
    const py = (value) => bottom - (value - low) / (high - low) * (bottom - top);
    frames.basis = { x: (at) => first + (at - left) / (right - left) * (last - first), step: (last - first) / (right - left) };
    for (const value of [0, 0.5, 1]) {
      element(svg, "line", { x1: left, x2: right, y1: py(value), y2: py(value), class: value === 0 ? "axis" : "tick" });
      element(svg, "text", { x: left - 12, y: py(value) + 4, "text-anchor": "end" }, String(value));
    }
    const x = float(values.x);
    if (x >= first && x <= last) element(svg, "line", { x1: px(x), x2: px(x), y1: top, y2: bottom, class: "at" });
    for (let i = 0; i < count; i++) {
      const [stroke, dash] = [COLOURS[i % COLOURS.length], DASHES[Math.floor(i / COLOURS.length) % DASHES.length]];
      const g = element(svg, "g", { "data-function": i, class: chosen === null || chosen === i ? "" : "faded" });
      element(g, "title", {}, `G_${i}`);
      const own = spans.filter((span) => span.first <= i && i < span.first + span.functions[0].length);
      for (const span of own) {
        const places = span.x.map((at, s) => [px(at), py(span.functions[s][i - span.first])]);
        element(g, "polyline", { points: line(places), stroke, "stroke-dasharray": dash, class: "function" });
      }
      const shape = shapes?.[i];
      if (!shape?.extrema) continue;
      // At a jump the limit from the left is hollow, and the value, that from the right, filled; at t_m the limit is the value.
      const dot = (at, y, filled) => element(g, "circle", { cx: px(at), cy: py(y), r: 4, stroke, ...(filled ? { fill: stroke } : { class: "hollow" }) });
      for (const { at, left: before, right: after } of shape.jumps) {
        dot(float(at), float(before), false);
        dot(float(at), float(after), true);
      }
      for (const { kind, x: at, height, interval, plateau } of shape.extrema) {
        if (kind !== "maximum") continue;
        const places = plateau ? interval.map(float) : [Number(at)];
        const mark = (place) => `M${px(place) - 5},${py(Number(height)) - 11}h10l-5,8z`;
        element(g, "path", { d: places.map(mark).join(""), fill: stroke, class: "maximum" });
      }
    }
    let written = -Infinity;
    knots.forEach(({ at, exact, times }, stop) => {
      element(svg, "line", { x1: px(at), x2: px(at), y1: py(low), y2: py(low) + 7, class: "axis" });
      element(element(svg, "circle", { cx: px(at), cy: py(low), r: 6, class: "handle", "data-knot": stop }), "title", {}, `${exact}: drag it`);
      if (px(at) - written > 30) {
        element(svg, "text", { x: px(at), y: bottom + 24, "text-anchor": "middle" }, short(at));
        if (times > 1) element(svg, "text", { x: px(at), y: bottom + 42, "text-anchor": "middle" }, `×${times}`);
        written = px(at);
      }
    });
  };

  const drawCurve = () => {
    const { drawing: { points, spans }, values } = shown;
    const plane = points !== null && points[0].length === 2 && points.flat().every((c) => c !== null);
    byId("curve-figure").hidden = !plane;
    if (!plane) return;
    const svg = byId("curve");
    svg.replaceChildren();
    const range = (axis) => { const all = points.map((point) => point[axis]); return [Math.min(...all), Math.max(...all)]; };
    // While a point is dragged the frame stays where it is.
    if (!dragged || frames.curve === null) {
      const [[x0, x1], [y0, y1]] = [range(0), range(1)];
      const scale = Math.min((WIDTH - 60) / (x1 - x0 || 1), (HEIGHT - 60) / (y1 - y0 || 1));
      frames.curve = { scale, middle: [(x0 + x1) / 2, (y0 + y1) / 2] };
    }
    const { scale, middle } = frames.curve;
    const place = ([a, b]) => [WIDTH / 2 + (a - middle[0]) * scale, HEIGHT / 2 - (b - middle[1]) * scale];
    element(svg, "polyline", { points: line(points.map(place)), class: "polygon" });
    for (const { curve } of spans.filter(({ curve }) => curve !== null)) {
      element(svg, "polyline", { points: line(curve.map(place)), class: "trace", stroke: COLOURS[0] });
    }
    points.forEach((point, i) => {
      const [cx, cy] = place(point);
      element(element(svg, "circle", { cx, cy, r: 6, class: "control", "data-point": i }), "title", {}, `d${i}: drag it`);
      element(svg, "text", { x: cx + 8, y: cy - 8 }, `d${i}`);
    });
    // Outside of [t_k, t_{n+1}] the functions do not add up to 1, and there is no curve.
    const x = float(values.x);
    const traced = spans.filter(({ curve }) => curve !== null);
    if (values.curve && traced.length > 0 && traced[0].x[0] <= x && x <= traced.at(-1).x.at(-1)) {
      const [cx, cy] = place(values.curve.map(float));
      element(svg, "circle", { cx, cy, r: 5.5, fill: COLOURS[1], class: "point" });
    }
  };

  /** A cell with an exact number, which may be long, and a decimal where that says more. */
  const number = (row, exact, decimal) => {
    const cell = row.insertCell();
    cell.dataset.exact = exact;
    cell.title = exact;
    const code = document.createElement("code");
    code.textContent = exact.length > 44 ? `${exact.slice(0, 40)}…` : exact;
    cell.append(code);
    if (exact.includes("/")) cell.append(` ≈ ${decimal}`);
  };

  /** The local maxima: exactly where they are known so, else in settled digits, with exact bounds to be seen at a closer look. */
  const maxima = (cell, shape) => {
    if (!shape?.extrema) {
      cell.textContent = shape ? "negative somewhere: no shape" : "…";
      return;
    }
    const all = shape.extrema.filter(({ kind }) => kind === "maximum");
    const at = ({ interval: [from, to], x, plateau }) => (plateau ? `from ${from} to ${to}` : from === to ? from : `≈ ${x}`);
    cell.textContent = all.map(at).join(", ");
    cell.title = all.filter(({ interval: [from, to], plateau }) => !plateau && from !== to).map(({ interval: [from, to] }) => `between ${from} and ${to}`).join("; ");
  };

  const write = () => {
    const { values, shapes } = shown;
    const rows = values.values.map((value, i) => {
      const row = document.createElement("tr");
      row.insertCell().textContent = i;
      row.insertCell().textContent = `[${values.supports[i].join(", ")}]`;
      number(row, value, values.decimals[i][0]);
      number(row, values.derivatives[0][i], values.decimals[i][1]);
      maxima(row.insertCell(), shapes?.[i]);
      row.classList.toggle("chosen", chosen === i);
      return row;
    });
    byId("values").tBodies[0].replaceChildren(...rows);
    const point = values.curve ? ` The point of the curve: (${values.curve.join(", ")}) ≈ (${values.curve_decimals.join(", ")}).` : "";
    byId("panel-sum").textContent = `At x = ${values.x} the functions add up to ${values.sum}.${point}`;
    byId("panel-command").textContent = `knotproof eval ${options()} --x ${values.x}`;
    const index = values.ratio !== undefined;
    byId("index").hidden = !index;
    if (index) {
      if (document.activeElement !== byId("ratio")) byId("ratio").value = Math.log10(Number(values.ratio));
      byId("ratio-value").textContent = `r = ${short(Number(values.ratio))}`;
    }
  };

  /** The options of the command line that say the same. */
  const options = () => {
    const { degree, knots, alpha, family, set } = asked();
    const quoted = (text) => (/^[\w./=,:-]+$/.test(text) ? text : `"${text.trim()}"`);
    const weights = family ? [`--family ${family}`, ...set.map((one) => `--set ${quoted(one)}`)].join(" ") : `--alpha ${quoted(alpha.trim())}`;
    return `--degree ${degree.trim()} --knots ${quoted(knots.trim())} ${weights}`;
  };

  const draw = () => {
    drawBasis();
    drawCurve();
    write();
  };

  // ---- Verdicts ------------------------------------------------------------------------------------------------------

  const forgetVerdicts = () => {
    if (modules.judge.isBusy()) modules.judge.stop();
    byId("verdicts-here").tBodies[0].replaceChildren();
    for (const id of ["judge-count", "judge-command"]) byId(id).textContent = "";
  };

  /** Judges a sentence on what is typed, and writes the verdict into a row. */
  const judge = async (row, on, { sentence, definitions }) => {
    const [, said, told] = row.cells;
    said.textContent = "…";
    try {
      const { status, claimed, found, at, reason, statement } = await ask(modules.judge, { ...on, sentence, definitions });
      said.innerHTML = "";
      const badge = document.createElement("span");
      badge.className = `badge ${status}`;
      badge.textContent = status;
      said.append(badge);
      const where = at?.length ? `at ${at.map(([name, value]) => `${name} = ${value}`).join(", ")}: ` : "";
      told.textContent = claimed ? `${where}it says ${claimed}; but ${found}` : reason ?? (row.dataset.claim ? "" : statement);
      return status;
    } catch (error) {
      said.textContent = error instanceof modules.Stopped ? "stopped" : error.message;
      if (!(error instanceof Refused || error instanceof modules.Fault || error instanceof modules.Stopped)) throw error;
      return error instanceof modules.Stopped ? null : "error";
    }
  };

  const rowOf = (id, title) => {
    const row = byId("verdicts-here").tBodies[0].insertRow();
    const name = row.insertCell();
    const general = document.querySelector(`tr[data-claim="${id}"] .badge`)?.cloneNode(true);
    if (general) {
      row.dataset.claim = id;
      const link = document.createElement("a");
      link.href = `#${id}`;
      link.textContent = id;
      name.append(link, ` ${title}`);
    } else {
      name.textContent = title;
    }
    row.insertCell();
    row.insertCell().className = "told";
    if (general) row.insertCell().append("in general: ", general);
    return row;
  };

  const judgeAll = async () => {
    forgetVerdicts();
    const on = asked();
    const all = on.family ? classical : claims;
    const rows = all.map(({ id, title }) => rowOf(id, title));
    const counts = new Map();
    for (const [at, row] of rows.entries()) {
      byId("judge-count").textContent = `${at} of ${all.length} …`;
      const status = await judge(row, on, all[at]);
      if (status === null) return;
      counts.set(status, (counts.get(status) ?? 0) + 1);
    }
    byId("judge-count").textContent = `For every x: ${[...counts].map(([status, count]) => `${count} ${status}`).join(", ")}.`;
    byId("judge-command").textContent = `knotproof check ${options()}${on.family ? " --classical" : ""}`;
  };

  const judgeOwn = () => {
    forgetVerdicts();
    const sentence = byId("sentence").value;
    byId("judge-command").textContent = `knotproof check ${options()} --claim "${sentence}"`;
    return judge(rowOf("", sentence), asked(), { sentence, definitions: [] });
  };

  // ---- Dragging ------------------------------------------------------------------------------------------------------

  let dragged = null;

  /** A number in as many digits as a point of the screen is worth. */
  const rounded = (value, step) => {
    const digits = Math.max(0, Math.ceil(-Math.log10(step)));
    return String(Number(value.toFixed(Math.min(digits, 20))));
  };

  const placeIn = (svg, { clientX, clientY }) => {
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(svg.getScreenCTM().inverse());
    return [x, y];
  };

  const moveX = (at) => {
    const { x, step } = frames.basis;
    byId("x").value = rounded(Math.min(Math.max(x(at), shown.drawing.knots[0].at), shown.drawing.knots.at(-1).at), step);
  };

  // All copies of a knot move, as far as its neighbours.
  const moveKnot = (stop, at) => {
    const { x, step } = frames.basis;
    const { knots } = shown.drawing;
    const [low, high] = [knots[stop - 1]?.at ?? -Infinity, knots[stop + 1]?.at ?? Infinity];
    const to = rounded(Math.min(Math.max(x(at), low + step), high - step), step);
    const list = byId("knots").value.split(/[\s,]+/).filter(Boolean);
    const before = knots.slice(0, stop).reduce((sum, { times }) => sum + times, 0);
    list.fill(to, before, before + knots[stop].times);
    byId("knots").value = list.join(" ");
    byId("instance").value = "";
  };

  const movePoint = (i, [x, y]) => {
    const { scale, middle } = frames.curve;
    const to = [middle[0] + (x - WIDTH / 2) / scale, middle[1] - (y - HEIGHT / 2) / scale];
    const list = byId("points").value.trim().split(/\s+/);
    list[i] = to.map((c) => rounded(c, 1 / scale)).join(",");
    byId("points").value = list.join(" ");
  };

  const drag = (id, begins) => {
    const svg = byId(id);
    svg.addEventListener("pointerdown", (event) => {
      dragged = frames[id] && begins(event.target.dataset);
      if (!dragged) return;
      event.preventDefault();
      svg.setPointerCapture(event.pointerId);
      dragged(placeIn(svg, event));
      update();
    });
    svg.addEventListener("pointermove", (event) => {
      if (!dragged) return;
      dragged(placeIn(svg, event));
      update();
    });
    for (const over of ["pointerup", "pointercancel"]) {
      svg.addEventListener(over, () => {
        if (!dragged) return;
        dragged = null;
        update();
      });
    }
  };

  // ---- The form ------------------------------------------------------------------------------------------------------

  const remember = () => {
    const { family, set } = asked();
    const state = { panel: byId("instance").value || "own", ...texts(), ...(family ? { family, set: set.join(" ") } : {}), ...(chosen === null ? {} : { function: chosen }) };
    history.replaceState(null, "", `#${new URLSearchParams(state)}`);
  };

  let families = [];

  /** A field for each parameter of the family that is chosen, with the settings given or the simplest ones. */
  const showMember = async (set) => {
    const family = families.find(({ name }) => name === byId("family").value);
    byId("alpha-field").hidden = family !== undefined;
    byId("index").hidden = family !== undefined;
    byId("weight").textContent = family ? `${family.title}. Weights, rise : fall = ${family.weight}.` : "";
    byId("members").replaceChildren();
    if (!family) return;
    const settled = set ?? (await ask(modules.panel, { ask: "member", ...asked() })).set;
    const given = new Map(settled.map((one) => one.split(/=(.*)/s).slice(0, 2)));
    for (const { parameter, bound } of family.parameters) {
      const name = parameter.split("[")[0];
      const label = document.createElement("label");
      const input = document.createElement("input");
      [input.dataset.name, input.value, input.spellcheck] = [name, given.get(name) ?? "", false];
      input.addEventListener("input", () => update());
      label.append(bound || parameter, input);
      byId("members").append(label);
    }
  };

  const choose = ({ degree, knots, points, indices }) => {
    byId("degree").value = degree;
    byId("knots").value = knots;
    byId("points").value = points.map((point) => point.join(",")).join(" ");
    byId("alpha").value = indices.includes("-1") ? "-1" : (indices[1] ?? indices[0] ?? "inf");
    const list = knots.split(" ");
    byId("x").value = rounded((float(list[0]) + float(list.at(-1))) / 2, 1e-3);
  };

  // Sets the fields from the part of the address after #.
  const restore = async (hash) => {
    const state = new URLSearchParams(hash);
    const at = instances.findIndex(({ name, degree }) => `${name}/${degree}` === state.get("panel"));
    byId("instance").value = at < 0 ? "" : state.get("panel");
    if (at >= 0) choose(instances[at]); else byId("points").value = "";
    for (const id of FIELDS) if (state.has(id)) byId(id).value = state.get(id);
    if (at < 0 && !state.has("x")) byId("x").value = byId("knots").value.split(/[\s,]+/)[0];
    const i = state.get("function");
    chosen = /^\d+$/.test(i ?? "") ? Number(i) : null;
    busy();
    await started;
    byId("family").value = state.get("family") ?? "";
    await showMember(state.has("set") ? state.get("set").split(" ") : undefined).catch(complain);
    await update(true);
  };

  const begin = async () => {
    ({ families } = await ask(modules.panel, { ask: "families" }));
    for (const { name, parameters } of families) {
      const own = parameters.map(({ parameter }) => parameter).join(", ");
      byId("family").append(new Option(own ? `${name}: ${own}` : name, name));
    }
  };
  let started;

  const listen = () => {
    const list = byId("instance");
    list.addEventListener("change", async () => {
      busy();
      chosen = null;
      if (list.value) choose(instances[list.selectedIndex - 1]);
      await showMember().catch(complain);
      await update();
    });
    byId("family").addEventListener("change", async () => {
      busy();
      await showMember().catch(complain);
      await update();
    });
    for (const id of FIELDS) {
      byId(id).addEventListener("input", () => {
        if (id === "degree" || id === "knots") [list.value, chosen] = ["", null];
        update();
      });
    }
    byId("ratio").addEventListener("input", async () => {
      busy();
      const ratio = rounded(10 ** Number(byId("ratio").value), 1e-4);
      const index = await ask(modules.panel, { ask: "index", ratio }).catch(complain);
      if (index) byId("alpha").value = index.alpha;
      await update();
    });
    byId("conjugate").addEventListener("click", () => {
      if (shown.values?.conjugate) byId("alpha").value = shown.values.conjugate;
      update();
    });
    byId("judge").addEventListener("click", () => judgeAll());
    byId("own-form").addEventListener("submit", (event) => {
      event.preventDefault();
      judgeOwn();
    });
    byId("panel-form").addEventListener("submit", (event) => event.preventDefault());
    drag("basis", ({ knot }) => (knot === undefined ? ([x]) => moveX(x) : ([x]) => moveKnot(Number(knot), x)));
    drag("curve", ({ point }) => (point === undefined ? null : (at) => movePoint(Number(point), at)));
  };

  const start = () => {
    const list = byId("instance");
    list.append(new Option("own", ""));
    for (const { name, degree, figure } of instances) list.append(new Option(`${name}, k = ${degree} (${figure})`, `${name}/${degree}`));
    list.value = "C5/3";
    if (!list.value) list.selectedIndex = Math.min(1, instances.length);
    choose(instances[list.selectedIndex - 1] ?? { degree: 2, knots: "0 0 0 1 2 2 2", points: [], indices: ["inf"] });
    listen();
    // After the page is there.
    started = new Promise((done) => { (window.requestIdleCallback ?? setTimeout)(done); }).then(begin).catch(complain);
    if (!location.hash.startsWith("#panel=")) started.then(() => update(true));
  };

  return { start, restore };
})();
