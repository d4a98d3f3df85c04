"use strict";
// The panel: the recursion of the paper in f64, to look at. Nothing here takes part in a verdict.
const panel = (() => {
  // ---- The basis -------------------------------------------------------------------------------------------------

  // w and its derivative on [a, b]: rise = r(x − a), fall = b − x, w = rise/(rise + fall), 1 − w = fall/(rise + fall).
  const weight = (r, x, a, b) => {
    const [rise, fall] = [r * (x - a), b - x];
    const sum = rise + fall;
    return { w: rise / sum, rest: fall / sum, slope: r * (b - a) / (sum * sum) };
  };

  // All functions of degree k and their derivatives at x, on the span [t_j, t_{j+1}]: entry i is [G_i, G_i′].
  // G_i^d = w_i^d G_i^{d−1} + (1 − w_{i+1}^d) G_{i+1}^{d−1}.
  const functionsOn = ({ t, k, r }, j, x) => {
    let level = t.slice(1).map((_, i) => (i === j ? [1, 0] : [0, 0]));
    for (let d = 1; d <= k; d++) {
      level = level.slice(1).map((next, i) => {
        const own = level[i];
        let [value, slope] = [0, 0];
        // Weights of functions that are 0 on the span are not needed, and may be 0/0.
        if (i <= j && j < i + d) {
          const { w, slope: dw } = weight(r, x, t[i], t[i + d]);
          value += w * own[0];
          slope += dw * own[0] + w * own[1];
        }
        if (i + 1 <= j && j < i + 1 + d) {
          const { rest, slope: dw } = weight(r, x, t[i + 1], t[i + 1 + d]);
          value += rest * next[0];
          slope += rest * next[1] - dw * next[0];
        }
        return [value, slope];
      });
    }
    return level;
  };

  const spansOf = (t) => t.slice(1).map((_, j) => j).filter((j) => t[j] < t[j + 1]);

  // The span of x: right-continuous, and at t_m the last one; undefined outside of [t_0, t_m].
  const spanAt = (t, x) => {
    const spans = spansOf(t);
    return x === t.at(-1) ? spans.at(-1) : spans.find((j) => t[j] <= x && x < t[j + 1]);
  };

  const functionsAt = (basis, x) => {
    const j = spanAt(basis.t, x);
    return j === undefined ? basis.t.slice(basis.k + 1).map(() => [0, 0]) : functionsOn(basis, j, x);
  };

  // Local maxima of G_i, from the signs of the slopes, one-sided at the ends of spans: a maximum lies between a place with slope > 0
  // and the next one with slope < 0. Inside a span a function rises, or falls, or rises and then falls (X.maxima.spans), so that
  // maxima close to a knot, on its two sides, are not missed. The slope at an end may be 0: hence the places between.
  const maximaOf = (basis, i) => {
    const { t, k } = basis;
    if (k === 0) return [];
    const tiny = 1e-11 * (k + 1) * (basis.r + 1 / basis.r) / (t[i + k + 1] - t[i]);
    const maxima = [];
    let rising = { x: t[i], j: spanAt(t, t[i]) }; // Where it was last seen to rise: it begins with that.
    let before = 0;
    const see = (x, j, slope) => {
      if (slope > tiny) rising = { x, j };
      if (slope < -tiny && rising !== null) {
        maxima.push(rising.x === x ? x : peak(basis, i, rising, { x, j }));
        rising = null;
      }
    };
    for (const j of spansOf(t).filter((j) => t[i] <= t[j] && t[j + 1] <= t[i + k + 1])) {
      const [start, end] = [functionsOn(basis, j, t[j])[i], functionsOn(basis, j, t[j + 1])[i]];
      if (start[0] > before + 1e-9) rising = { x: t[j], j }; // It jumps up,
      if (start[0] < before - 1e-9) rising = null; // or down: then the limit is not attained.
      see(t[j], j, start[1]);
      for (const part of [0.25, 0.5, 0.75]) {
        const x = t[j] + part * (t[j + 1] - t[j]);
        see(x, j, functionsOn(basis, j, x)[i][1]);
      }
      see(t[j + 1], j, end[1]);
      before = end[0];
    }
    // At t_m the value is the limit from the left.
    if (rising?.x === t.at(-1) && before > 1e-9) maxima.push(rising.x);
    return maxima;
  };

  // The maximum between two places, by halving: on the sign of the slope where they are in one span, else it is at the
  // knot between them, or so flat there that the knot will do.
  const peak = (basis, i, from, to) => {
    if (from.j !== to.j) return basis.t[to.j];
    let [low, high] = [from.x, to.x];
    for (let step = 0; step < 60; step++) {
      const x = (low + high) / 2;
      if (functionsOn(basis, from.j, x)[i][1] > 0) low = x; else high = x;
    }
    return (low + high) / 2;
  };

  const pointOf = (points, functions) =>
    points[0].map((_, axis) => points.reduce((sum, point, i) => sum + point[axis] * functions[i][0], 0));

  // ---- What is typed -----------------------------------------------------------------------------------------------

  class Rule extends Error {
    constructor(field, message) {
      super(message);
      this.field = field;
    }
  }

  const numberIn = (field, text) => {
    const match = /^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)(?:\/(\d+))?$/i.exec(text.trim());
    const value = match ? Number(match[1]) / Number(match[2] ?? 1) : NaN;
    if (!Number.isFinite(value)) throw new Rule(field, `“${text.trim()}” is not a number: write 3, -1/2, 0.4 or 1e-3.`);
    return value;
  };

  const ratioOf = (text) => {
    if (/^[+-]?(inf|∞)$/i.test(text.trim())) return 1;
    const alpha = numberIn("alpha", text);
    if (alpha >= 0 && alpha <= 1) throw new Rule("alpha", `α = ${text.trim()} lies in [0, 1]: an index is negative, greater than 1, or inf (D2.3).`);
    return alpha / (alpha - 1);
  };

  const alphaOf = (r) => (r === 1 ? "inf" : String(Number((r / (r - 1)).toPrecision(12))));

  const basisFrom = ({ degree, knots, alpha }) => {
    const k = Number(degree);
    if (!/^\d+$/.test(degree.trim()) || k > 12) throw new Rule("degree", "The degree k is a whole number from 0 to 12 here.");
    const t = knots.split(/[\s,;]+/).filter(Boolean).map((text) => numberIn("knots", text));
    const needed = Math.max(2 * k, k + 1) + 1;
    if (t.length < needed) throw new Rule("knots", `Degree ${k} needs at least ${needed} knots (m ≥ 2k, D3.2), and here are ${t.length}.`);
    const fall = t.findIndex((knot, i) => i > 0 && knot < t[i - 1]);
    if (fall > 0) throw new Rule("knots", `Knots must not decrease (D3.1), but knot ${fall} is ${t[fall]}, after ${t[fall - 1]}.`);
    if (t[0] === t.at(-1)) throw new Rule("knots", "All knots are equal: there is no interval between them (D3.2 asks for a < b).");
    return { t, k, r: ratioOf(alpha) };
  };

  const pointsFrom = (text, count) => {
    const points = text.trim().split(/\s+/).filter(Boolean).map((point) => point.split(",").map((c) => numberIn("points", c)));
    if (points.length === 0) return null;
    if (points.some((point) => point.length !== 2)) throw new Rule("points", "A control point is written x,y, without spaces: 0,0 1,2 3,1.");
    if (points.length !== count) throw new Rule("points", `There are ${count} basis functions, so ${count} control points are needed (D3.4), and here are ${points.length}.`);
    return points;
  };

  // ---- Drawing ------------------------------------------------------------------------------------------------------

  const byId = (id) => document.getElementById(id);
  // Okabe and Ito's colours but for black and yellow, told apart by dashes as well.
  const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9"];
  const DASHES = ["", "9 4", "3 3", "12 3 3 3"];
  const [WIDTH, HEIGHT, SAMPLES] = [640, 360, 120];

  const draw = (parent, name, attributes, text) => {
    const element = document.createElementNS("http://www.w3.org/2000/svg", name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    if (text !== undefined) element.textContent = text;
    parent.append(element);
    return element;
  };
  const line = (places) => places.map(([x, y]) => `${x.toFixed(2)},${y.toFixed(2)}`).join(" ");
  const short = (value) => String(Number(value.toPrecision(6)));
  const sampled = (from, to) => Array.from({ length: SAMPLES + 1 }, (_, s) => (s === SAMPLES ? to : from + (to - from) * s / SAMPLES));

  const drawBasis = (basis, x, chosen, maxima) => {
    const { t, k } = basis;
    const svg = byId("basis");
    svg.replaceChildren();
    const [first, last] = [t[0], t.at(-1)];
    const [left, right, top, bottom] = [40, WIDTH - 16, 20, HEIGHT - 52];
    const px = (value) => left + (value - first) / (last - first) * (right - left);
    const py = (value) => bottom - value * (bottom - top);
    for (const value of [0, 0.5, 1]) {
      draw(svg, "line", { x1: left, x2: right, y1: py(value), y2: py(value), class: value === 0 ? "axis" : "tick" });
      draw(svg, "text", { x: left - 6, y: py(value) + 4, "text-anchor": "end" }, String(value));
    }
    let written = -Infinity;
    for (const knot of new Set(t)) {
      const times = t.filter((other) => other === knot).length;
      draw(svg, "line", { x1: px(knot), x2: px(knot), y1: bottom, y2: bottom + 7, class: "axis" });
      if (px(knot) - written > 30) {
        draw(svg, "text", { x: px(knot), y: bottom + 22, "text-anchor": "middle" }, short(knot));
        if (times > 1) draw(svg, "text", { x: px(knot), y: bottom + 40, "text-anchor": "middle" }, `×${times}`);
        written = px(knot);
      }
    }
    if (x >= first && x <= last) draw(svg, "line", { x1: px(x), x2: px(x), y1: top, y2: bottom, class: "at" });
    const count = t.length - k - 1;
    const lines = Array.from({ length: count }, () => []);
    for (const j of spansOf(t)) {
      const rows = sampled(t[j], t[j + 1]).map((at) => [at, functionsOn(basis, j, at)]);
      lines.forEach((runs, i) => {
        if (t[i] <= t[j] && t[j + 1] <= t[i + k + 1]) runs.push(rows.map(([at, row]) => [at, row[i][0]]));
      });
    }
    lines.forEach((runs, i) => {
      const [stroke, dash] = [COLOURS[i % COLOURS.length], DASHES[Math.floor(i / COLOURS.length) % DASHES.length]];
      const g = draw(svg, "g", { "data-function": i, class: chosen === null || chosen === i ? "" : "faded" });
      draw(g, "title", {}, `G_${i}`);
      for (const run of runs) draw(g, "polyline", { points: line(run.map(([at, y]) => [px(at), py(y)])), stroke, "stroke-dasharray": dash, class: "function" });
      // Jumps: the limit from the left is hollow, the value from the right filled; at t_m the limit is the value.
      const dot = (at, y, filled) => draw(g, "circle", { cx: px(at), cy: py(y), r: 4, stroke, ...(filled ? { fill: stroke } : { class: "hollow" }) });
      runs.forEach((run, at) => {
        const [here, before] = [run[0], at > 0 ? runs[at - 1].at(-1) : [run[0][0], 0]];
        if (Math.abs(here[1] - before[1]) > 1e-9) { if (here[0] > first) dot(...before, false); dot(...here, true); }
      });
      const end = runs.at(-1)?.at(-1);
      if (end && end[1] > 1e-9) dot(...end, end[0] === last);
      for (const at of maxima[i]) {
        const [mx, my] = [px(at), py(functionsAt(basis, at)[i][0])];
        draw(g, "path", { d: `M${mx - 5},${my - 11}h10l-5,8z`, fill: stroke, class: "maximum" });
      }
    });
  };

  const drawCurve = (basis, points, x) => {
    byId("curve-figure").hidden = points === null;
    if (points === null) return;
    const svg = byId("curve");
    svg.replaceChildren();
    const range = (axis) => { const all = points.map((point) => point[axis]); return [Math.min(...all), Math.max(...all)]; };
    const [[x0, x1], [y0, y1]] = [range(0), range(1)];
    const scale = Math.min((WIDTH - 60) / (x1 - x0 || 1), (HEIGHT - 60) / (y1 - y0 || 1));
    const place = ([a, b]) => [WIDTH / 2 + (a - (x0 + x1) / 2) * scale, HEIGHT / 2 - (b - (y0 + y1) / 2) * scale];
    draw(svg, "polyline", { points: line(points.map(place)), class: "polygon" });
    points.forEach((point, i) => {
      const [cx, cy] = place(point);
      draw(svg, "circle", { cx, cy, r: 3.5, class: "control" });
      draw(svg, "text", { x: cx + 6, y: cy - 6 }, `d${i}`);
    });
    // Outside of [t_k, t_{n+1}] the functions do not add up to 1, and the curve runs to the origin.
    const [from, to] = [basis.t[basis.k], basis.t[points.length]];
    for (const j of spansOf(basis.t).filter((j) => from <= basis.t[j] && basis.t[j + 1] <= to)) {
      const run = sampled(basis.t[j], basis.t[j + 1]).map((at) => place(pointOf(points, functionsOn(basis, j, at))));
      draw(svg, "polyline", { points: line(run), class: "trace", stroke: COLOURS[0] });
    }
    if (x >= from && x <= to) {
      const [cx, cy] = place(pointOf(points, functionsAt(basis, x)));
      draw(svg, "circle", { cx, cy, r: 5.5, fill: COLOURS[1] });
    }
  };

  // ---- The form ------------------------------------------------------------------------------------------------------

  const FIELDS = ["degree", "knots", "points", "alpha", "x"];
  const instances = JSON.parse(byId("instances").textContent);
  let chosen = null; // The function that a witness is about.

  const read = () => Object.fromEntries(FIELDS.map((id) => [id, byId(id).value]));

  // Redraws everything from the fields; `keep` says that the address is to stay as it is.
  const update = (keep = false) => {
    const fields = read();
    for (const id of FIELDS) byId(id).setAttribute("aria-invalid", "false");
    byId("panel-error").textContent = "";
    try {
      const basis = basisFrom(fields);
      const count = basis.t.length - basis.k - 1;
      const points = pointsFrom(fields.points, count);
      const x = numberIn("x", fields.x);
      const all = functionsAt(basis, x);
      if (chosen !== null && chosen >= count) chosen = null;
      const maxima = all.map((_, i) => (basis.t[i] < basis.t[i + basis.k + 1] ? maximaOf(basis, i) : []));
      byId("ratio").value = Math.log10(basis.r);
      byId("ratio-value").textContent = `r = ${short(basis.r)}`;
      drawBasis(basis, x, chosen, maxima);
      drawCurve(basis, points, x);
      const rows = all.map(([value, slope], i) => {
        const row = document.createElement("tr");
        const cells = [i, `[${short(basis.t[i])}, ${short(basis.t[i + basis.k + 1])}]`, value, short(slope), maxima[i].map((at) => at.toPrecision(8)).join(", ")];
        cells.forEach((cell) => { row.insertCell().textContent = cell; });
        row.dataset.value = value;
        return row;
      });
      byId("values").tBodies[0].replaceChildren(...rows);
      const sum = all.reduce((total, [value]) => total + value, 0);
      const point = points && ` The point of the curve: (${pointOf(points, all).map(short).join(", ")}).`;
      byId("panel-sum").textContent = `At x = ${fields.x.trim()} the functions add up to ${short(sum)}.${point ?? ""}`;
      byId("panel-command").textContent = `knotproof eval --degree ${basis.k} --knots "${fields.knots.trim()}" --alpha ${fields.alpha.trim()} --x ${fields.x.trim()}`;
      if (!keep) history.replaceState(null, "", `#${new URLSearchParams({ panel: byId("instance").value || "own", ...fields, ...(chosen === null ? {} : { function: chosen }) })}`);
    } catch (error) {
      if (!(error instanceof Rule)) throw error;
      byId(error.field).setAttribute("aria-invalid", "true");
      byId("panel-error").textContent = error.message;
    }
  };

  const choose = ({ degree, knots, points, indices }) => {
    byId("degree").value = degree;
    byId("knots").value = knots;
    byId("points").value = points.map((point) => point.join(",")).join(" ");
    byId("alpha").value = indices.includes("-1") ? "-1" : (indices[1] ?? indices[0]);
    const t = knots.split(", ").map((knot) => numberIn("knots", knot));
    byId("x").value = short((t[0] + t.at(-1)) / 2);
  };

  // Sets the fields from the part of the address after #.
  const restore = (hash) => {
    const state = new URLSearchParams(hash);
    const at = instances.findIndex(({ name, degree }) => `${name}/${degree}` === state.get("panel"));
    byId("instance").value = at < 0 ? "" : state.get("panel");
    if (at >= 0) choose(instances[at]); else byId("points").value = "";
    for (const id of FIELDS) if (state.has(id)) byId(id).value = state.get(id);
    if (at < 0 && !state.has("x")) byId("x").value = byId("knots").value.split(",")[0];
    const i = state.get("function");
    chosen = /^\d+$/.test(i ?? "") ? Number(i) : null;
    update(true);
  };

  const start = () => {
    const list = byId("instance");
    list.append(new Option("own", ""));
    for (const { name, degree, figure } of instances) list.append(new Option(`${name}, k = ${degree} (${figure})`, `${name}/${degree}`));
    list.addEventListener("change", () => {
      chosen = null;
      if (list.value) choose(instances[list.selectedIndex - 1]);
      update();
    });
    for (const id of FIELDS) {
      byId(id).addEventListener("input", () => {
        if (id === "degree" || id === "knots") { list.value = ""; chosen = null; }
        update();
      });
    }
    byId("ratio").addEventListener("input", () => {
      byId("alpha").value = alphaOf(10 ** Number(byId("ratio").value));
      update();
    });
    byId("conjugate").addEventListener("click", () => {
      try {
        const [text, r] = [byId("alpha").value.trim(), ratioOf(byId("alpha").value)];
        // 1 − p/q = (q − p)/q, so that a fraction stays one.
        const fraction = /^(-?\d+)(?:\/(\d+))?$/.exec(text);
        if (fraction) {
          const [p, q] = [BigInt(fraction[1]), BigInt(fraction[2] ?? 1)];
          byId("alpha").value = q === 1n ? String(q - p) : `${q - p}/${q}`;
        } else {
          byId("alpha").value = alphaOf(1 / r);
        }
      } catch (error) {
        if (!(error instanceof Rule)) throw error;
      }
      update();
    });
    byId("panel-form").addEventListener("submit", (event) => event.preventDefault());
    list.value = "C5/3";
    if (!list.value) list.selectedIndex = Math.min(1, instances.length);
    choose(instances[list.selectedIndex - 1] ?? { degree: 2, knots: "0, 0, 0, 1, 2, 2, 2", points: [], indices: ["inf"] });
    update(true);
  };

  return { start, restore };
})();
