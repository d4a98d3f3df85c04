// A page in headless Chromium, spoken to over a pipe in the DevTools protocol: nothing to install, no port, no network.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

const PROGRAMS = [process.env.CHROMIUM, "chromium", "chromium-browser", "google-chrome"].filter(Boolean);
const ANSWER_WITHIN = 20_000;

const launched = (program, profile) =>
  new Promise((resolve, reject) => {
    const flags = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--hide-scrollbars", "--log-level=3", "--remote-debugging-pipe"];
    const child = spawn(program, [...flags, `--user-data-dir=${profile}`, "about:blank"], {
      stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"],
      env: { ...process.env, DBUS_SESSION_BUS_ADDRESS: "disabled:" },
    });
    child.once("error", reject);
    child.once("spawn", () => resolve(child));
  });

/** Opens `url`; `close` ends the browser, and only that one. */
export async function open(url) {
  const profile = mkdtempSync(join(tmpdir(), "knotproof-browser-"));
  let child;
  for (const program of PROGRAMS) {
    child = await launched(program, profile).catch(() => undefined);
    if (child) break;
  }
  if (!child) throw new Error(`there is no Chromium: tried ${PROGRAMS.join(", ")}`);
  const [input, output] = [child.stdio[3], child.stdio[4]];
  const [waiting, events, listeners] = [new Map(), [], []];
  let [buffer, last] = ["", 0];
  output.setEncoding("utf8");
  output.on("data", (text) => {
    const messages = (buffer + text).split("\0");
    buffer = messages.pop();
    for (const message of messages.map((message) => JSON.parse(message))) {
      if (message.id) {
        waiting.get(message.id)?.(message);
        waiting.delete(message.id);
      } else {
        events.push(message);
        listeners.forEach((listen) => listen(message));
      }
    }
  });
  let session;
  const send = (method, params = {}) =>
    new Promise((resolve, reject) => {
      const id = ++last;
      const timer = setTimeout(() => reject(new Error(`no answer to ${method}`)), ANSWER_WITHIN);
      waiting.set(id, ({ result, error }) => {
        clearTimeout(timer);
        if (error) reject(new Error(`${method}: ${error.message}`)); else resolve(result);
      });
      input.write(`${JSON.stringify({ id, method, params, sessionId: session })}\0`);
    });
  const event = (name) =>
    new Promise((resolve, reject) => {
      const timer = setTimeout(() => reject(new Error(`${name} did not happen`)), ANSWER_WITHIN);
      listeners.push((message) => {
        if (message.method === name) { clearTimeout(timer); resolve(message.params); }
      });
    });
  const close = async () => {
    const ended = new Promise((resolve) => child.once("exit", resolve));
    child.kill("SIGKILL");
    await ended;
    // Its children write on for a moment. What they leave is in the folder for temporary files, and no result.
    for (let tries = 0; tries < 20; tries++) {
      try {
        return rmSync(profile, { recursive: true, force: true });
      } catch {
        await new Promise((resolve) => setTimeout(resolve, 200));
      }
    }
  };
  try {
    const { targetInfos } = await send("Target.getTargets");
    const { targetId } = targetInfos.find(({ type }) => type === "page");
    session = (await send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    for (const domain of ["Page", "Runtime", "Network", "Log"]) await send(`${domain}.enable`);
    const loaded = event("Page.loadEventFired");
    await send("Page.navigate", { url });
    await loaded;
  } catch (error) {
    await close();
    throw error;
  }
  /** The value of an expression in the page. */
  const evaluate = async (expression) => {
    const { result, exceptionDetails } = await send("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  };
  return { send, evaluate, events, close };
}
