// The workers, as the page sees them. Each takes one task at a time; the others wait here, so that a task's time is its
// own and the waiting ones survive when a worker is ended.
import { byId } from './dom.mjs';

const patience_ms = 20000;

export class Cancelled extends Error {
  constructor(message = 'cancelled') {
    super(message);
    this.code = 'CANCELLED';
  }
}

let compiled; // what the first worker unpacked and compiled; workers share the machine code
let workerUrl;

// What this browser lacks of what the module needs; empty: nothing. The smallest modules with a vector and with a `try`.
export function missingFeature() {
  const can = (...body) => typeof WebAssembly === 'object' && WebAssembly.validate(Uint8Array.of(0, 97, 115, 109, 1, 0, 0, 0, ...body));
  if (!can()) return 'WebAssembly';
  if (!can(1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 10, 1, 8, 0, 65, 0, 253, 15, 253, 98, 11)) return 'WebAssembly with SIMD';
  if (!can(1, 4, 1, 96, 0, 0, 3, 2, 1, 0, 10, 8, 1, 6, 0, 6, 64, 25, 11, 11)) return 'WebAssembly with exceptions';
  return typeof DecompressionStream === 'function' ? '' : 'DecompressionStream';
}

function startWorker() {
  workerUrl ??= URL.createObjectURL(new Blob([byId('worker').textContent], { type: 'text/javascript' }));
  return new Worker(workerUrl);
}

export class Engine {
  #worker;
  #ready;
  #queue = [];
  #current;
  #timer;
  #number = 0;
  #listener;
  generation = 0; // counts the workers: what a worker was told is forgotten with it

  constructor(listener = () => {}) {
    this.#listener = listener;
  }

  get busy() {
    return Boolean(this.#current) || this.#queue.length > 0;
  }

  // Resolves to the worker's answer. `label` is shown while it works.
  call(task, argument, { label = '', patience = patience_ms } = {}) {
    return new Promise((resolve, reject) => {
      this.#queue.push({ task, argument, label, patience, resolve, reject });
      this.#next();
    });
  }

  run(words, files = {}, options = {}) {
    return this.call('run', { words, files }, { label: words[0], ...options });
  }

  start() {
    this.#ready ??= this.#open();
    return this.#ready;
  }

  // Ends the worker with its task; waiting tasks go on with a new one unless `all`.
  cancel({ all = true, error = new Cancelled() } = {}) {
    const lost = [this.#current, ...(all ? this.#queue.splice(0) : [])].filter(Boolean);
    this.#close();
    for (const entry of lost) entry.reject(error);
    this.#next();
  }

  #close() {
    clearTimeout(this.#timer);
    this.#worker?.terminate();
    this.#worker = undefined;
    this.#ready = undefined;
    this.#current = undefined;
    ++this.generation;
    this.#listener(this);
  }

  async #open() {
    const worker = startWorker();
    this.#worker = worker;
    const { wasm } = await new Promise((resolve, reject) => {
      worker.onmessage = ({ data }) => (data.error ? reject(Object.assign(new Error(data.error.message), data.error)) : resolve(data.result));
      worker.onerror = (event) => reject(new Error(event.message));
      const argument = compiled ? { wasm: compiled } : { packed: byId('wasm').textContent.trim() };
      worker.postMessage({ id: 0, task: 'start', argument });
    });
    compiled ??= wasm;
    byId('wasm')?.remove();
    worker.onmessage = ({ data }) => this.#answer(worker, data);
    worker.onerror = (event) => {
      event.preventDefault();
      this.cancel({ all: false, error: Object.assign(new Error(event.message), { code: 'WORKER' }) });
    };
  }

  #answer(worker, { id, result, error }) {
    if (worker !== this.#worker || id !== this.#current?.id) return;
    clearTimeout(this.#timer);
    const done = this.#current;
    this.#current = undefined;
    if (error?.fatal) this.#close();
    if (error) done.reject(Object.assign(new Error(error.message), error));
    else done.resolve(result);
    this.#next();
  }

  async #next() {
    if (this.#current || this.#queue.length === 0) {
      this.#listener(this);
      return;
    }
    const entry = this.#queue.shift();
    entry.id = ++this.#number;
    this.#current = entry;
    this.#listener(this);
    try {
      await this.start();
    } catch (error) {
      if (this.#current !== entry) return;
      this.#close();
      entry.reject(error);
      this.#next();
      return;
    }
    if (this.#current !== entry) return; // cancelled meanwhile
    this.#timer = setTimeout(() => this.cancel({ all: false, error: Object.assign(
      new Error(`no answer after ${entry.patience / 1000} s: stopped`), { code: 'TIMEOUT' }) }), entry.patience);
    this.#worker.postMessage({ id: entry.id, task: entry.task, argument: entry.argument });
  }

  get label() {
    return this.#current?.label ?? '';
  }
}

// The report of a command with --json, also of one that failed with a report.
export function reportOf(answer) {
  const text = new TextDecoder().decode(answer.stdout);
  if (text) return JSON.parse(text);
  throw errorOf(answer);
}

// What a failed command says, as the tool prints it: "file:line:column: error[CODE]: message" and hints.
export function diagnosticsOf(stderr) {
  const found = [];
  for (const line of stderr.split('\n')) {
    const match = /^(?:(.*?):)??(?:(\d+):(\d+): |\s*)?(error|warning|note)\[(\w+)\]: (.*)$/.exec(line);
    if (match) found.push({ file: match[1] ?? '', line: Number(match[2] ?? 0), column: Number(match[3] ?? 0), severity: match[4], code: match[5], message: match[6], hint: '' });
    else if (found.length && line.startsWith('hint: ')) found.at(-1).hint = line.slice(6);
  }
  return found;
}

export function errorOf(answer) {
  const diagnostics = diagnosticsOf(answer.stderr);
  const last = diagnostics.findLast((entry) => entry.severity === 'error');
  return Object.assign(new Error(last?.message ?? (answer.stderr.trim() || `exit status ${answer.status}`)),
    { code: last?.code ?? '', hint: last?.hint ?? '', diagnostics });
}

// The answer of a command that must succeed.
export function succeeded(answer) {
  if (answer.status !== 0) throw errorOf(answer);
  return answer;
}
