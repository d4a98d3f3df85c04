"use strict";
// In a worker: a module of the program, and its questions one after the other. What a panic leaves behind is not used again.
let compiled;
let exports;

const compile = async (base64) => {
  const packed = new Blob([Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))]);
  const bytes = new Response(packed.stream().pipeThrough(new DecompressionStream("gzip")));
  return WebAssembly.compile(await bytes.arrayBuffer());
};

const text = (length) => new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.text(), length));

const answer = async (question) => {
  exports ??= (await WebAssembly.instantiate(await compiled)).exports;
  const bytes = new TextEncoder().encode(question);
  const at = exports.question(bytes.length);
  new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
  return text(exports.answer());
};

onmessage = async ({ data: { base64, id, question } }) => {
  if (base64 !== undefined) {
    compiled = compile(base64);
    return;
  }
  try {
    postMessage({ id, answer: await answer(question) });
  } catch (error) {
    const said = exports?.fault() ?? 0;
    postMessage({ id, fault: said > 0 ? text(said) : String(error) });
    exports = undefined;
  }
};
