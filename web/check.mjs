// The modules of the page against the program: the checker accepts every certificate and no forged one; the panel has the
// numbers, the judge the verdicts, and both the complaints of the command line. Where two lists differ, that is printed.
//
// usage: node web/check.mjs FOLDER KNOTPROOF; FOLDER has the compressed modules
import { spawnSync } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { gunzipSync } from "node:zlib";

const [folder, knotproof] = process.argv.slice(2);
const repository = join(dirname(fileURLToPath(import.meta.url)), "..");

let [passed, failed] = [0, 0];
const check = (name, holds, found) => {
  if (holds) passed += 1; else failed += 1;
  if (!holds) console.log(`FAILED  ${name}${found === undefined ? "" : `: ${JSON.stringify(found).slice(0, 2000)}`}`);
};
const same = (name, found, expected) => check(name, JSON.stringify(found) === JSON.stringify(expected), { found, expected });

const module = async (name) => {
  const { instance: { exports } } = await WebAssembly.instantiate(gunzipSync(readFileSync(join(folder, `${name}.wasm.gz`))));
  const text = (length) => new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.text(), length));
  return (question) => {
    const bytes = new TextEncoder().encode(question);
    const at = exports.question(bytes.length);
    new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
    try {
      return text(exports.answer());
    } catch (error) {
      return `panic: ${text(exports.fault())} (${error})`;
    }
  };
};
const asking = (of) => (question) => JSON.parse(of(JSON.stringify(question)));
const program = (...options) => {
  const { stdout, stderr } = spawnSync(knotproof, [...options, "--format", "json"], { encoding: "utf8", env: { ...process.env, KNOTPROOF_PROGRESS: "never" } });
  return JSON.parse(stdout || stderr);
};
const options = ({ degree, knots, alpha, family, set = [], points }) => [
  "--degree", degree, "--knots", knots, ...(points ? ["--points", points] : []),
  ...(family ? ["--family", family, ...set.flatMap((one) => ["--set", one])] : ["--alpha", alpha]),
];

// ---- The checker
{
  const checker = await module("checker");
  const certs = join(repository, "proofs/certs");
  const names = readdirSync(certs).filter((file) => file.endsWith(".statement")).map((file) => file.replace(/\.statement$/, ""));
  const texts = (name) => ["statement", "proof"].map((kind) => readFileSync(join(certs, `${name}.${kind}`), "utf8"));
  const accepts = (statement, proof) => checker(`${statement}\0${proof}`).startsWith("accepted: ");
  check("there are certificates", names.length > 100);
  for (const name of names) check(`${name} is accepted`, accepts(...texts(name)));
  // The sum of all functions is 2; what is refuted is proved; a proof of something else, or of nothing; what is cut off.
  const forged = (name, change) => change(...texts(name));
  const unity = (change) => forged("T3.5.2.printed", change);
  for (const [what, [statement, proof]] of [
    ["another number", unity((statement, proof) => [statement.replace(/\(int 0\)/, "(int 1)"), proof])],
    ["another relation", unity((statement, proof) => [statement.replaceAll("(> (int 0))", "(< (int 0))"), proof])],
    ["a refutation as a proof", forged("T3.5.3.printed", (statement, proof) => [statement.replace("(verdict refuted)", "(verdict proved)"), proof])],
    ["another proof", unity((statement) => [statement, texts("T3.5.3.amended")[1]])],
    ["no proof", unity((statement) => [statement, "(proof 1)"])],
    ["half of a proof", unity((statement, proof) => [statement, proof.slice(0, proof.length / 2)])],
    ["nothing", ["", ""]],
  ]) {
    check(`${what} is rejected`, checker(`${statement}\0${proof}`).startsWith("rejected: "), checker(`${statement}\0${proof}`));
    check(`${what} is no certificate that there is`, names.every((name) => JSON.stringify(texts(name)) !== JSON.stringify([statement, proof])));
  }
}

// ---- The panel
const SMALL = { degree: "2", knots: "0 0 0 1 2 2 2", x: "1/3" };
const CASES = [
  { degree: "3", knots: "0 0 0 0 1 2 4 4", alpha: "5/2", x: "3/2" },
  { degree: "3", knots: "0 0 0 0 1 2 4 4 4 4", alpha: "-1", x: "1", points: "0,0 1,2 2,0 3,1 4,4 5,0" },
  { degree: "2", knots: "0,0,0,1,1,1,2,2,2", alpha: "inf", x: "1", points: "0 1 2 3 4 5" },
  { degree: "5", knots: "0 1 2 3 4 5 6 7 8 9 10 11", alpha: "-1/7", x: "0x1.8p1" },
  { degree: "1", knots: "0 0 1 2", alpha: "1000000", x: "7" },
  { degree: "0", knots: "0 1/3 2.5 1e1", alpha: "3/2", x: "1e1" },
  { ...SMALL, family: "lupas", set: ["q=1/2"] },
  { ...SMALL, family: "knot-weights", set: ["omega=1,1,1,2,1,1/3,1"], points: "0,0 1,2 2,0 3,1" },
  { ...SMALL, family: "free-ratios", set: ["rho=1,2,1,1,1,1;1,1,1/2,1,1"] },
  { ...SMALL, family: "square", set: [] },
  { ...SMALL, family: "mobius", set: ["r=3"] },
  { ...SMALL, family: "smoothstep", set: [] },
];
const panel = asking(await module("panel"));
{
  const { families } = panel({ ask: "families" });
  const listed = program("families").families.filter(({ name }) => !["classical", "mobius"].includes(name));
  same("the families are those of the program", families.map(({ name, title, weight, parameters }) => ({ name, title, weight, parameters })), listed.map(({ name, title, weight, parameters }) => ({ name, title, weight, parameters })));
  const shownFor = [];
  for (const { name } of families) {
    const { set } = panel({ ask: "member", ...SMALL, family: name });
    const on = { ...SMALL, family: name, set };
    if (!panel({ ask: "values", ...on }).error) shownFor.push(on);
  }
  check("most families have a member on these knots", shownFor.length > families.length / 2, shownFor);
  for (const on of [...CASES, ...shownFor]) {
    const name = JSON.stringify(on);
    // Fields that are missing on both sides are the same: these are not.
    const [values, expected] = [panel({ ask: "values", ...on }), program("eval", ...options(on), "--x", on.x, "--derivatives", "1")];
    check(`${name}: there are values`, values.values?.length > 0 && expected.values?.length > 0, [values, expected]);
    for (const field of ["degree", "knots", "alpha", "family", "x", "side", "values", "derivatives", "curve"]) same(`${name}: ${field}`, values[field], expected[field]);
    const [shapes, told] = [panel({ ask: "shapes", ...on }).functions, program("shape", ...options({ ...on, points: "" }))];
    if (told.error) {
      check(`${name}: a function is negative`, shapes.some(({ negative }) => negative) && /is negative/.test(told.error.message), told);
      continue;
    }
    for (const [i, shape] of shapes.entries()) for (const field of Object.keys(shape)) same(`${name}: ${field} of G_${i}`, shape[field], told.functions[i][field]);
    // The drawing: floats close to the exact values, at the points of each span.
    const { spans } = panel({ ask: "drawing", ...on });
    for (const { x, first, functions } of spans.slice(0, 2)) {
      const exact = program("eval", ...options({ ...on, points: "" }), "--x", String(x[7]), "--float").values;
      check(`${name}: the drawing at ${x[7]}`, functions[7].every((value, c) => first + c >= exact.length || Math.abs(value - exact[first + c]) < 1e-9), [functions[7], exact]);
    }
  }
}

// ---- The judge
const judge = asking(await module("judge"));
{
  const own = "x in [t[0], t[m]] : sum(i in 0..n: G[i](x)) = 1";
  for (const on of CASES) {
    for (const sentence of [own, "i in 0..n : maxima(G[i]) <= 1", "i in 0..n; x in (t[i], t[i+k+1]) : G[i](x) > 0", "i in 0..n : G'[i](t[m]-) >= 0"]) {
      const [{ properties: [expected] }, found] = [program("check", ...options(on), "--claim", sentence), judge({ ...on, sentence })];
      const name = `${JSON.stringify(on)}: ${sentence}`;
      same(`${name}: the statement`, found.statement, expected.statement);
      same(`${name}: the verdict`, [found.status, found.scope, found.reason, found.witness], [expected.status, expected.scope, expected.reason, expected.witness]);
    }
  }
}

// ---- What can't be read: in the words of the command line
const GARBAGE = [
  { degree: "two" }, { degree: "-1" }, { degree: "99999999999999999999" }, { knots: "" }, { knots: "0 1 1 0" }, { knots: "0 0 0 0 2 1 4 4" },
  { knots: "0 0 x 1" }, { knots: "0 0 0 1,5 6 6 6" }, { knots: "1/0" }, { knots: "\u{1f600}" }, { knots: "3 3 3 3 3 3 3" }, { alpha: "1/2" },
  { alpha: "" }, { alpha: "nan" }, { x: "one" }, { points: "0,0 1,1" }, { points: "(0,1" }, { points: "[[1,\"a\"]]" }, { points: "0 1 2 three" },
  { family: "nobody" }, { family: "lupas" }, { family: "lupas", set: ["q"] }, { family: "lupas", set: ["q=0"] }, { family: "lupas", set: ["q=1", "q=2"] },
  { family: "lupas", set: ["q=symbolic"] }, { family: "lupas", set: ["p=1"] }, { family: "knot-weights", set: ["omega=1,2"] },
];
for (const wrong of GARBAGE) {
  const on = { ...SMALL, alpha: "-1", ...wrong };
  const { message, argument } = program("eval", ...options(on), "--x", on.x).error;
  same(`${JSON.stringify(wrong)} is refused`, panel({ ask: "values", ...on }).error, { message, argument });
}
{
  const sentence = "i in 0..n : maxma(G[i]) = 1";
  const { message, argument } = program("check", ...options({ ...SMALL, alpha: "-1" }), "--claim", sentence).error;
  same("a sentence with a misspelt word is refused", judge({ ...SMALL, alpha: "-1", sentence }).error, { message, argument });
}

console.log(`${passed} passed, ${failed} failed`);
process.exitCode = failed === 0 && passed > 500 ? 0 : 1;
