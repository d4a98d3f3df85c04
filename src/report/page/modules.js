"use strict";
// The modules of the program that stand in the page: each in a worker of its own, begun when it is first asked.
const modules = (() => {
  const byId = (id) => document.getElementById(id);

  /** What a module can't answer: a bug of the program, or a browser that lacks what it takes. */
  class Fault extends Error {}
  /** The question was taken back. */
  class Stopped extends Error {}

  const module = (name) => {
    const waiting = new Map();
    let worker;
    let last = 0;
    const settle = ({ id, answer, fault }) => {
      const { resolve, reject } = waiting.get(id);
      waiting.delete(id);
      if (fault === undefined) resolve(answer); else reject(new Fault(`internal error: ${fault}`));
    };
    const begin = () => {
      const source = URL.createObjectURL(new Blob([byId("worker").textContent], { type: "text/javascript" }));
      worker = new Worker(source);
      worker.onmessage = ({ data }) => settle(data);
      worker.onerror = ({ message }) => { for (const id of [...waiting.keys()]) settle({ id, fault: message }); };
      worker.postMessage({ base64: byId(`module-${name}`).textContent.trim() });
    };
    return {
      /** The answer, a text. */
      ask: (question) => new Promise((resolve, reject) => {
        try {
          if (!worker) begin();
        } catch (error) {
          reject(new Fault(String(error)));
          return;
        }
        last += 1;
        waiting.set(last, { resolve, reject });
        worker.postMessage({ id: last, question });
      }),
      /** Is there an answer to come? */
      isBusy: () => waiting.size > 0,
      /** Takes all questions back; the next one begins anew. */
      stop: () => {
        worker?.terminate();
        worker = undefined;
        for (const { reject } of waiting.values()) reject(new Stopped());
        waiting.clear();
      },
    };
  };

  return { panel: module("panel"), judge: module("judge"), checker: module("checker"), Fault, Stopped };
})();

// Certificates, each read by the checker in front of the reader.
{
  const byId = (id) => document.getElementById(id);
  let texts;
  const certificates = () => {
    texts ??= (async () => {
      const packed = new Blob([Uint8Array.from(atob(byId("certificates").textContent.trim()), (c) => c.charCodeAt(0))]);
      return new Response(packed.stream().pipeThrough(new DecompressionStream("gzip"))).json();
    })();
    return texts;
  };
  document.addEventListener("click", async (event) => {
    const button = event.target.closest("button.check");
    if (!button) return;
    const says = button.nextElementSibling;
    button.disabled = true;
    says.textContent = "reading …";
    says.className = "";
    try {
      const [statement, proof] = (await certificates())[button.dataset.certificate];
      const began = performance.now();
      const answer = await modules.checker.ask(`${statement}\0${proof}`);
      const seconds = ((performance.now() - began) / 1000).toFixed(1);
      says.className = `badge ${answer.startsWith("accepted") ? "proved" : "refuted serious"}`;
      says.textContent = `${answer} (${seconds} s)`;
    } catch (error) {
      says.className = "badge refuted serious";
      says.textContent = error.message;
    }
    button.disabled = false;
  });
}
